use super::*;
use crate::math::vec3::norm;
use crate::resolution::Resolution;

const FACES: [[f64; 3]; 2] = [[0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];

fn edgelet(place: [f64; 3], along: [f64; 3], arms: [[f64; 3]; 2]) -> Edgelet {
    Edgelet {
        place,
        point: 0,
        along,
        arms,
        spacing: 1.0,
        deviation: 0.1,
        evidence: 100.0,
        reach: 9.0,
        radius: 0.0,
    }
}

/// Edgelets along x, one spacing apart.
fn row(from: i32, to: i32, arms: [[f64; 3]; 2]) -> Vec<Edgelet> {
    // Directions of either sign, as edgelets have them.
    let along = |x: i32| [if x % 2 == 0 { 1.0 } else { -1.0 }, 0.0, 0.0];
    (from..to).map(|x| edgelet([f64::from(x), 0.0, 0.0], along(x), arms)).collect()
}

fn lines_of(edgelets: &[Edgelet]) -> LineGraph {
    over(LineGraph::default(), edgelets)
}

fn over(strips: LineGraph, edgelets: &[Edgelet]) -> LineGraph {
    chains(strips, edgelets, 5.0, 25.0, Resolution { spacing: 1.0, noise: 0.0 }.into())
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

/// A strip through places, a vertex each.
fn strip(lines: &mut LineGraph, places: impl Iterator<Item = [f64; 3]>) -> Vec<u32> {
    let added: Vec<u32> = places.map(|p| lines.push_vertex(0, p)).collect();
    added.windows(2).for_each(|w| lines.add_edge(w[0], w[1]));
    added
}

/// Numbers of edges of the vertices that are nodes.
fn degrees(lines: &LineGraph) -> Vec<usize> {
    let is_node = lines.is_node();
    let mut degrees: Vec<usize> =
        (0..is_node.len()).filter(|&v| is_node[v]).map(|v| lines.edges[v].len()).collect();
    degrees.sort_unstable();
    degrees
}

#[test]
fn a_chain_takes_the_place_of_the_strip_beside_it_and_the_rest_of_the_strip_goes_on() {
    let mut strips = LineGraph::default();
    let main = strip(&mut strips, (0..40).map(|x| [f64::from(x), 0.4, 0.0]));
    let branch = strip(&mut strips, (1..8).map(|y| [10.0, 0.4 + f64::from(y), 0.0]));
    strips.add_edge(main[10], branch[0]);
    // A link to nowhere, shorter than the neighbourhoods by which points are judged.
    let link = strip(&mut strips, (1..4).map(|y| [5.0, 0.4 + f64::from(y), 0.0]));
    strips.add_edge(main[5], link[0]);
    // As short, but far from any chain.
    strip(&mut strips, (0..4).map(|x| [f64::from(x), 50.0, 0.0]));
    let lines = over(strips, &row(0, 20, FACES));
    assert_eq!(degrees(&lines), [1, 1, 1, 1, 1, 3]);
    for (v, p) in lines.positions.iter().enumerate().filter(|(v, _)| !lines.edges[*v].is_empty()) {
        let expected = if p[0] < 19.5 { 0.0 } else { 0.4 };
        assert!(p[1] == expected || p[0] == 10.0 || p[1] == 50.0, "{v}: {p:?}");
    }
    let count = lines.positions.iter().filter(|p| p[1] == 0.4).count();
    assert_eq!(count, 20, "the strip goes on beyond the chain");
}

#[test]
fn of_two_chains_along_one_crease_the_longer_stays() {
    let beside = |y: f64, arms| {
        row(5, 12, arms).into_iter().map(move |e| Edgelet { place: [e.place[0], y, 0.0], ..e })
    };
    let double: Vec<Edgelet> = row(0, 20, FACES).into_iter().chain(beside(0.6, FACES)).collect();
    let lines = lines_of(&double);
    assert_eq!((degrees(&lines), lines.edge_count()), (vec![1, 1], 19));
    // The other side of a narrow face is another crease.
    let across = [[0.0, -1.0, 0.0], [0.0, 0.0, -1.0]];
    let narrow: Vec<Edgelet> = row(0, 20, FACES).into_iter().chain(beside(0.7, across)).collect();
    assert_eq!(lines_of(&narrow).edge_count(), 19 + 6);
}

#[test]
fn chains_that_end_before_a_corner_are_led_on_to_it() {
    // The three edges of a box at the origin, seen from 2.5 spacings on.
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let edge = |k: usize| {
        let (a, b) = (axes[(k + 1) % 3], axes[(k + 2) % 3]);
        (0..10).map(move |i| edgelet(axes[k].map(|x| x * (2.5 + f64::from(i))), axes[k], [a, b]))
    };
    let lines = lines_of(&(0..3).flat_map(edge).collect::<Vec<_>>());
    assert_eq!(degrees(&lines), [1, 1, 1, 3]);
    let corner = (0..lines.edges.len()).find(|&v| lines.edges[v].len() == 3).unwrap();
    assert!(norm(lines.positions[corner]) < 1e-9, "{:?}", lines.positions[corner]);
}

#[test]
fn a_chain_that_runs_into_the_side_of_another_meets_it_there() {
    let side = (3..13)
        .map(|y| edgelet([10.0, f64::from(y), 0.0], [0.0, 1.0, 0.0], [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0]]));
    let up = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let main = row(0, 20, up);
    let lines = lines_of(&main.iter().copied().chain(side.clone()).collect::<Vec<_>>());
    assert_eq!(degrees(&lines), [1, 1, 1, 3]);
    // Not where they bound no face together.
    let tilted = [[0.0, 0.6, 0.8], [0.0, -0.8, 0.6]];
    let apart = row(0, 20, tilted);
    let lines = lines_of(&apart.iter().copied().chain(side).collect::<Vec<_>>());
    assert_eq!(degrees(&lines), [1, 1, 1, 1]);
}

#[test]
fn the_end_of_a_narrow_face_is_closed() {
    // A rib two wide along x that ends at x = 0: its upper edges, and the upright ones of its end.
    let (top, end) = ([0.0, 0.0, -1.0], [1.0, 0.0, 0.0]);
    let sides = [(0.0, [0.0, 1.0, 0.0]), (2.0, [0.0, -1.0, 0.0])];
    let edges = sides.iter().flat_map(|&(y, inwards)| {
        let along = (2..12).map(move |x| edgelet([f64::from(x), y, 0.0], end, [inwards, top]));
        let down = (2..12).map(move |z| edgelet([0.0, y, -f64::from(z)], top, [inwards, end]));
        along.chain(down)
    });
    let lines = lines_of(&edges.collect::<Vec<_>>());
    assert_eq!(degrees(&lines), [1, 1, 1, 1, 3, 3]);
    let corners: Vec<u32> =
        (0..lines.edges.len() as u32).filter(|&v| lines.edges[v as usize].len() == 3).collect();
    assert!(lines.edges[corners[0] as usize].contains(&corners[1]), "the edge between both corners");
}

/// Edgelets of a rounded edge along x, and the points on its round and its faces.
fn blend(radius: f64) -> (Vec<Edgelet>, Vec<[f64; 3]>) {
    let row = (5..16).map(|k| edgelet([2.0 * f64::from(k), 0.0, 0.0], [1.0, 0.0, 0.0], FACES));
    let edgelets = row.map(|e| Edgelet { radius, ..e }).collect();
    let mut points = Vec::new();
    for x in 0..=40 {
        for k in 0..8 {
            let angle = std::f64::consts::FRAC_PI_2 * (f64::from(k) + 0.5) / 8.0;
            points.push([f64::from(x), radius * (1.0 - angle.sin()), radius * (angle.cos() - 1.0)]);
        }
        points.extend((0..8).map(|k| [f64::from(x), radius + f64::from(k), 0.0]));
    }
    (edgelets, points)
}

#[test]
fn a_rounded_edge_is_led_on_as_far_as_points_lie_on_its_round() {
    let (edgelets, points) = blend(3.0);
    let scales = Resolution { spacing: 1.0, noise: 0.0 };
    let (lines, kept) = rounded(&edgelets, 4.0, 4.0, &points, scales.into());
    assert_eq!(kept.len(), lines.points.len());
    assert_eq!(loose(&lines), 2);
    let extent = |pick: fn(f64, f64) -> f64| lines.positions.iter().map(|p| p[0]).reduce(pick).unwrap();
    // Eight steps at most beyond 10 and 30, and no step beyond the points.
    assert!((extent(f64::min), extent(f64::max)) == (2.0, 38.0), "{:?}", lines.positions);
    assert!(lines.radius.iter().all(|&r| r == 3.0));
    let none: Vec<[f64; 3]> = points.iter().copied().filter(|p| (8.0..=33.0).contains(&p[0])).collect();
    let (lines, _) = rounded(&edgelets, 4.0, 4.0, &none, scales.into());
    let most = lines.positions.iter().map(|p| p[0]).fold(0.0, f64::max);
    assert!((32.0..=34.0).contains(&most), "{most}");
}

#[test]
fn a_chamfer_of_which_the_whole_edge_shows_more_is_no_rounded_edge() {
    let (edgelets, points) = blend(3.0);
    let doubtful: Vec<Edgelet> = (0..)
        .zip(edgelets)
        .map(|(k, e)| Edgelet { evidence: if k % 3 == 0 { 2.0 } else { -3.0 }, ..e })
        .collect();
    let scales = Resolution { spacing: 1.0, noise: 0.0 };
    assert_eq!(rounded(&doubtful, 4.0, 4.0, &points, scales.into()).0.edge_count(), 0);
}
