//! The minimum spanning graph: a minimum spanning tree that keeps long cycles (Gumhold 2001, section 3.2).

use super::walk::Walker;
use super::{Candidate, Reach};
use crate::math::union_find::UnionFind;
use crate::math::vec3::{cross, distance, norm, sub};
use crate::measure::Penalties;
use crate::pattern::LineGraph;
use crate::resolution::Resolution;

/// Adds the edges in their order, unless they close a cycle that is shorter than `reach.rho` or encloses nothing.
pub fn minimum_spanning_graph(
    penalties: &Penalties,
    edges: &[Candidate],
    resolution: Resolution,
    reach: Reach,
) -> LineGraph {
    let mut lines = LineGraph {
        points: penalties.points.clone(),
        positions: penalties.foot.clone(),
        penalty: penalties.scalar.clone(),
        corner: penalties.corner.clone(),
        evidence: penalties.evidence.clone(),
        expected: penalties.expected.clone(),
        fold: penalties.fold.clone(),
        edges: vec![Vec::new(); penalties.len()],
        nodes: Vec::new(),
    };
    let mut sets = UnionFind::new(penalties.len());
    let mut walker = Walker::new(penalties.len(), resolution, reach);
    for edge in edges {
        if sets.union(edge.a, edge.b) || closes_long(&lines, &mut walker, edge, resolution, reach) {
            lines.edges[edge.a as usize].push(edge.b);
            lines.edges[edge.b as usize].push(edge.a);
        }
    }
    for list in &mut lines.edges {
        list.sort_unstable();
    }
    lines
}

/// Whether the cycle that `edge` closes is long enough, and open: the paper's `pathLonger`.
pub(super) fn closes_long(
    lines: &LineGraph,
    walker: &mut Walker,
    edge: &Candidate,
    resolution: Resolution,
    reach: Reach,
) -> bool {
    let closing = walker.length(lines, edge.a, edge.b);
    if walker.path(lines, edge.a, edge.b, reach.rho - closing).is_some() {
        return false;
    }
    if reach.openness == 0.0 {
        return true;
    }
    // A cycle much longer than it is wide may be two strands of one band: look at the shortest one whole.
    match walker.path(lines, edge.a, edge.b, 8.0 * reach.rho) {
        Some(path) => openness(&lines.positions, &path) >= reach.openness * resolution.unit(),
        None => true,
    }
}

/// Area over length of the polygon through `path`.
fn openness(positions: &[[f64; 3]], path: &[u32]) -> f64 {
    let at = |i: usize| positions[path[i % path.len()] as usize];
    let (mut area, mut length) = ([0.0; 3], 0.0);
    for i in 0..path.len() {
        let twice = cross(sub(at(i), at(0)), sub(at(i + 1), at(0)));
        area = [area[0] + twice[0], area[1] + twice[1], area[2] + twice[2]];
        length += distance(at(i), at(i + 1));
    }
    if length > 0.0 { 0.5 * norm(area) / length } else { 0.0 }
}
