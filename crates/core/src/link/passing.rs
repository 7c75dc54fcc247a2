//! Nodes that a line passes straight: ours.
//!
//! Lines are led on to the places where they meet, and some of them go again later. Where two are left that continue each other, there is
//! no corner.

use crate::math::vec3::{distance, dot, norm, sub};
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// Distance from the node at which the direction of a line is taken, in spacings.
const AHEAD: f64 = 3.0;
/// Least cosine between the directions of a line before and behind a node that it passes.
const STRAIGHT: f64 = 0.97;

/// Takes the mark of a node from each vertex at which two edges continue each other.
pub(super) fn unmark(lines: &mut LineGraph, scales: Scales) {
    let mut nodes = std::mem::take(&mut lines.nodes);
    nodes.retain(|&v| !is_passed(lines, v, scales));
    lines.nodes = nodes;
}

fn is_passed(lines: &LineGraph, node: u32, scales: Scales) -> bool {
    let [a, b] = lines.edges[node as usize][..] else { return false };
    let [a, b] = [a, b].map(|next| direction(lines, node, next, scales));
    dot(a, b) <= -STRAIGHT * norm(a) * norm(b)
}

/// The way from a node to a vertex of its line some spacings ahead, or to the line's end.
fn direction(lines: &LineGraph, node: u32, next: u32, scales: Scales) -> [f64; 3] {
    let place = |v: u32| lines.positions[v as usize];
    let reach = AHEAD * scales.at(lines.points[node as usize] as usize).spacing;
    let (mut before, mut at) = (node, next);
    while distance(place(node), place(at)) < reach {
        let [a, b] = lines.edges[at as usize][..] else { break };
        let onwards = if a == before { b } else { a };
        if onwards == node {
            break;
        }
        (before, at) = (at, onwards);
    }
    sub(place(at), place(node))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::resolution::Resolution;

    /// A line of nine vertices that turns by some degrees at the one in the middle, which is marked as a node.
    fn bent(degrees: f64) -> LineGraph {
        let mut lines = LineGraph::default();
        let (sin, cos) = degrees.to_radians().sin_cos();
        for i in -4..=4 {
            let x = f64::from(i);
            lines.push_vertex(0, if i < 0 { [x, 0.0, 0.0] } else { [x * cos, x * sin, 0.0] });
        }
        (1..9).for_each(|i| lines.add_edge(i - 1, i));
        lines.nodes = vec![4];
        lines
    }

    #[test]
    fn a_node_on_a_straight_line_goes_and_a_corner_stays() {
        let left = |degrees: f64| {
            let mut lines = bent(degrees);
            unmark(&mut lines, Resolution { spacing: 1.0, noise: 0.0 }.into());
            lines.nodes.len()
        };
        assert_eq!(left(5.0), 0);
        assert_eq!(left(40.0), 1);
    }
}
