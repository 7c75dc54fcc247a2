use super::*;
use crate::math::vec3::norm;
use crate::resolution::Resolution;

const FACES: [[f64; 3]; 2] = [[0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];

fn edgelet(place: [f64; 3], along: [f64; 3], arms: [[f64; 3]; 2]) -> Edgelet {
    Edgelet { place, point: 0, along, arms, spacing: 1.0, deviation: 0.1, evidence: 100.0, reach: 9.0 }
}

/// Edgelets along x, one spacing apart.
fn row(from: i32, to: i32, arms: [[f64; 3]; 2]) -> Vec<Edgelet> {
    // Directions of either sign, as edgelets have them.
    let along = |x: i32| [if x % 2 == 0 { 1.0 } else { -1.0 }, 0.0, 0.0];
    (from..to).map(|x| edgelet([f64::from(x), 0.0, 0.0], along(x), arms)).collect()
}

fn lines_of(edgelets: &[Edgelet]) -> LineGraph {
    let mut lines = LineGraph::default();
    follow(&mut lines, edgelets, 5.0, 25.0, Resolution { spacing: 1.0, noise: 0.0 }.into());
    lines
}

/// Vertices with one edge.
fn loose(lines: &LineGraph) -> usize {
    lines.edges.iter().filter(|list| list.len() == 1).count()
}

#[test]
fn a_row_becomes_a_strip_and_a_short_one_does_not() {
    let lines = lines_of(&row(0, 10, FACES));
    assert_eq!((lines.edge_count(), loose(&lines)), (9, 2));
    assert_eq!(lines.edges.len(), 10);
    assert!(lines.penalty.iter().all(|p| p.is_some_and(|p| (0.0..0.3).contains(&p))));
    let fold = lines.evidence[4].unwrap().fold;
    assert!((f64::from(fold) - 0.5 * std::f64::consts::PI).abs() < 1e-6);
    assert_eq!(lines_of(&row(0, 5, FACES)), LineGraph::default());
    assert_eq!(lines_of(&[]), LineGraph::default());
}

#[test]
fn what_edgelets_show_together_counts_once_where_they_rest_on_the_same_points() {
    let weak = |to: i32| {
        let mut weak = row(0, to, FACES);
        weak.iter_mut().for_each(|e| e.evidence = 10.0);
        weak
    };
    assert_eq!(lines_of(&weak(20)), LineGraph::default());
    assert_eq!(lines_of(&weak(25)).edge_count(), 24);
}

#[test]
fn rows_that_continue_each_other_become_one_where_their_faces_are_the_same() {
    let two = |gap: i32, arms| [row(0, 8, FACES), row(7 + gap, 15 + gap, arms)].concat();
    let swapped = [FACES[1], FACES[0]];
    for (gap, arms, ends, length) in [(6, FACES, 2, 20.0), (6, swapped, 2, 20.0), (12, FACES, 4, 14.0)] {
        let lines = lines_of(&two(gap, arms));
        assert_eq!(loose(&lines), ends, "{gap}");
        let edges = lines.edges.iter().enumerate().flat_map(|(a, list)| list.iter().map(move |&b| (a, b)));
        let of = |(a, b): (usize, u32)| lines.positions[b as usize][0] - lines.positions[a][0];
        let total: f64 = edges.map(of).map(f64::abs).sum();
        assert!((0.5 * total - length).abs() < 1e-9, "{gap}: {total}");
        assert!(lines.positions.iter().all(|p| p[1] == 0.0 && p[2] == 0.0));
    }
    let upside_down = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(loose(&lines_of(&two(6, upside_down))), 4);
}

#[test]
fn rings_are_closed_also_over_a_gap() {
    let around = |k: i32| {
        let (sin, cos) = (f64::from(k) / 12.0).sin_cos();
        edgelet([12.0 * cos, 12.0 * sin, 0.0], [-sin, cos, 0.0], [[-cos, -sin, 0.0], [0.0, 0.0, -1.0]])
    };
    // The circumference is 75.4: the last of 75 lies 1.4 before the first.
    for count in [75, 70] {
        let lines = lines_of(&(0..count).map(around).collect::<Vec<_>>());
        assert_eq!(loose(&lines), 0, "{count}");
        assert!(lines.edges.iter().all(|list| list.len() == 2));
        let off = |p: &[f64; 3]| (norm(*p) - 12.0).abs();
        assert!(lines.positions.iter().all(|p| off(p) < 0.2), "{count}");
    }
}

#[test]
fn strips_move_onto_chains_beside_them_and_no_second_strip_is_added() {
    let mut lines = LineGraph::default();
    for x in 0..20 {
        lines.push_vertex(0, [f64::from(x), 0.4, 0.0]);
    }
    (1..20).for_each(|v| lines.add_edge(v - 1, v));
    // A strip across it, which begins at a junction.
    let branch = [1.0, 2.0, 3.0].map(|y| lines.push_vertex(0, [10.0, 0.4 + y, 0.0]));
    for (a, b) in [(10, branch[0]), (branch[0], branch[1]), (branch[1], branch[2])] {
        lines.add_edge(a, b);
    }
    let before = lines.clone();
    follow(&mut lines, &row(0, 20, FACES), 5.0, 25.0, Resolution { spacing: 1.0, noise: 0.0 }.into());
    assert_eq!(lines.edges, before.edges);
    for v in 0..23 {
        let moved = v < 20 && v != 10;
        let y = if moved { 0.0 } else { before.positions[v][1] };
        assert!((lines.positions[v][1] - y).abs() < 1e-9, "{v}: {:?}", lines.positions[v]);
    }
}
