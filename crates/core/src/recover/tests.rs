use super::recover;
use crate::network::{NodeKind, StripKind};
use crate::params::SplineParams;
use crate::pattern::{LineGraph, Pattern};
use crate::resolution::Resolution;

const UNIT: Resolution = Resolution { spacing: 1.0, noise: 0.0 };

/// Adds a row of vertices a spacing apart from `from` on, and gives the first and the last.
fn row(lines: &mut LineGraph, from: [f64; 3], step: [f64; 3], count: u32) -> [u32; 2] {
    let first = lines.edges.len() as u32;
    for i in 0..count {
        lines.points.push(first + i);
        lines.positions.push([0, 1, 2].map(|k| from[k] + f64::from(i) * step[k]));
        lines.penalty.push(0.0);
        lines.corner.push(1.0);
        lines.evidence.push(9.0);
        lines.expected.push(9.0);
        lines.fold.push(1.0);
        lines.edges.push(Vec::new());
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
        let network = recover(&Pattern { crease, ..Pattern::default() }, UNIT, &SplineParams::default());
        assert_eq!(network.strips.len(), strips, "length {length}");
    }
}

#[test]
fn a_crease_that_ends_beside_the_end_of_a_border_ends_on_it() {
    for (gap, ends) in [(0.7, 2), (4.0, 4)] {
        let (mut crease, mut border) = (LineGraph::default(), LineGraph::default());
        row(&mut crease, [-20.0 - gap, 0.0, 0.0], X, 21);
        row(&mut border, [0.0; 3], Y, 21);
        let network = recover(&Pattern { crease, border }, UNIT, &SplineParams::default());
        assert_eq!(network.count(NodeKind::End), ends, "gap {gap}");
        assert_eq!(network.strips.iter().filter(|s| s.kind == StripKind::Crease).count(), 1);
    }
}
