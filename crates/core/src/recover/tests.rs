use super::{LED_ON, SPANNING, recover, take_back};
use crate::network::{NodeKind, StripKind};
use crate::params::SplineParams;
use crate::patch::{Fit, Patch, Patches, Sides, Surface};
use crate::pattern::{LineGraph, Pattern};
use crate::resolution::Resolution;

const UNIT: Resolution = Resolution { spacing: 1.0, noise: 0.0 };

/// Adds a row of vertices a spacing apart, beginning at `from`, and returns the first and the last.
fn row(lines: &mut LineGraph, from: [f64; 3], step: [f64; 3], count: u32) -> [u32; 2] {
    let first = lines.edges.len() as u32;
    for i in 0..count {
        lines.push_vertex(first + i, [0, 1, 2].map(|k| from[k] + f64::from(i) * step[k]));
    }
    (1..count).for_each(|i| lines.add_edge(first + i - 1, first + i));
    [first, first + count - 1]
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];

#[test]
fn a_stub_is_left_out_and_a_branch_stays() {
    for (length, strips) in [(2, 2), (6, 3)] {
        let mut crease = LineGraph::default();
        row(&mut crease, [0.0; 3], X, 21);
        let [foot, _] = row(&mut crease, [10.0, 1.0, 0.0], Y, length);
        crease.add_edge(10, foot);
        let network =
            recover(&Pattern { crease, ..Pattern::default() }, UNIT, &SplineParams::default(), SPANNING);
        assert_eq!(network.strips.len(), strips, "length {length}");
    }
}

/// Two junctions two spacings apart, as the corners on both sides of a thin plate.
#[test]
fn short_strips_are_nodes_of_a_spanning_graph_and_edges_of_lines_that_were_led_on() {
    for (contracted, nodes) in [(SPANNING, 1), (LED_ON, 2)] {
        let mut crease = LineGraph::default();
        let [_, a] = row(&mut crease, [-10.0, 0.0, 0.0], X, 11);
        let [_, b] = row(&mut crease, [-10.0, 2.0, 0.0], X, 11);
        for (from, y, way) in [(a, -1.0, Y.map(|y| -y)), (b, 3.0, Y)] {
            let [foot, _] = row(&mut crease, [0.0, y, 0.0], way, 11);
            crease.add_edge(from, foot);
        }
        crease.add_edge(a, b);
        let pattern = Pattern { crease, ..Pattern::default() };
        let network = recover(&pattern, UNIT, &SplineParams::default(), contracted);
        assert_eq!(network.count(NodeKind::Junction), nodes, "{contracted}");
        assert_eq!(network.strips.len(), 3 + nodes, "{contracted}");
    }
}

#[test]
fn a_crease_that_ends_beside_the_end_of_a_border_ends_on_it() {
    for (gap, ends) in [(0.7, 2), (4.0, 4)] {
        let (mut crease, mut border) = (LineGraph::default(), LineGraph::default());
        row(&mut crease, [-20.0 - gap, 0.0, 0.0], X, 21);
        row(&mut border, [0.0; 3], Y, 21);
        let network = recover(
            &Pattern { crease, border, ..Pattern::default() },
            UNIT,
            &SplineParams::default(),
            SPANNING,
        );
        assert_eq!(network.count(NodeKind::End), ends, "gap {gap}");
        assert_eq!(network.strips.iter().filter(|s| s.kind == StripKind::Crease).count(), 1);
    }
}

/// A rectangle, 16 by 8, with a chord across its middle that folds by `fold_deg` between two patches; after verification.
fn chord(fold_deg: f64) -> (LineGraph, bool) {
    let mut crease = LineGraph::default();
    let corners = [[0.0, 0.0, 0.0], [16.0, 0.0, 0.0], [16.0, 8.0, 0.0], [0.0, 8.0, 0.0]];
    let ways = [(X, 16), (Y, 8), (X.map(|x| -x), 16), (Y.map(|y| -y), 8)];
    let sides: Vec<[u32; 2]> =
        corners.iter().zip(ways).map(|(&from, (step, count))| row(&mut crease, from, step, count)).collect();
    (0..4).for_each(|k| crease.add_edge(sides[k][1], sides[(k + 1) % 4][0]));
    let [foot, top] = row(&mut crease, [8.0, 1.0, 0.0], Y, 7);
    crease.add_edge(8, foot);
    crease.add_edge(top, sides[2][0] + 8);
    let pattern = Pattern { crease, ..Pattern::default() };
    let network = recover(&pattern, UNIT, &SplineParams::default(), SPANNING);
    let mut crease = pattern.crease;
    let beside = |s: &crate::Strip| {
        let is_chord = s.points.iter().all(|p| (p[0] - 8.0).abs() < 0.5);
        let fold_deg = Some(if is_chord { fold_deg } else { 90.0 });
        Sides { left: Some(0), right: Some(1), fold_deg, convex: Some(true) }
    };
    let surface = Surface::Plane { point: [0.0; 3], normal: [0.0, 0.0, 1.0] };
    let fit = Fit { surface, residual: 0.0, free: false, outward: true };
    let patch = Patch { loops: Vec::new(), neighbors: Vec::new(), points: 9, area: 1.0, fit };
    let sides = network.strips.iter().map(beside).collect();
    let patches = Patches { label: Vec::new(), patches: vec![patch.clone(), patch], sides };
    let taken = take_back(&mut crease, &network, &patches, UNIT, 25.0);
    (crease, taken)
}

#[test]
fn a_flat_chord_is_taken_back_and_the_loop_stays_closed() {
    let (crease, taken) = chord(10.0);
    assert!(taken);
    assert_eq!(crease.edge_count(), 48);
    assert!(crease.edges.iter().all(|e| e.is_empty() || e.len() == 2));
}

#[test]
fn a_chord_that_folds_stays() {
    let (crease, taken) = chord(40.0);
    assert!(!taken);
    assert_eq!(crease.edge_count(), 56);
}

#[test]
fn a_long_edge_between_points_of_a_dense_place_has_few_points() {
    // One edge of a thousand spacings of its points.
    let mut lines = LineGraph::default();
    row(&mut lines, [0.0; 3], [1000.0, 0.0, 0.0], 2);
    let pattern = Pattern { border: lines, ..Pattern::default() };
    let network =
        recover(&pattern, Resolution { spacing: 1.0, noise: 0.0 }, &SplineParams::default(), SPANNING);
    assert_eq!(network.strips.len(), 1);
    let count = network.strips[0].points.len();
    assert!((2..=33).contains(&count), "{count} points");
}
