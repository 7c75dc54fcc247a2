//! The minimum spanning graph (MSG): a minimum spanning tree that keeps long cycles (Gumhold 2001, section 3.2).

use super::rule::CycleRule;
use super::walk::Walker;
use super::weight::Candidate;
use crate::math::union_find::UnionFind;
use crate::math::vec3::{cross, distance, norm, sub};
use crate::measure::Penalties;
use crate::params::PenaltyForm;
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// Longest cycle whose openness is tested, in multiples of `rho`.
const WHOLE_CYCLE: f64 = 8.0;

/// Computes the minimum spanning graph (the paper's pseudocode "compute MSG") from `edges`, the queue in ascending order.
///
/// An edge is added if it joins two components of the disjoint sets (the paper's `find`), or if it closes a cycle that is
/// longer than `rho` (`pathLonger`) and, in the robust form, encloses an area.
pub(crate) fn minimum_spanning_graph(
    penalties: &Penalties,
    edges: &[Candidate],
    scales: Scales,
    rule: CycleRule,
) -> LineGraph {
    let mut lines = LineGraph {
        points: penalties.points.clone(),
        positions: penalties.foot.clone(),
        penalty: penalties.scalar.iter().map(|&p| Some(p)).collect(),
        corner: penalties.corner.clone(),
        evidence: penalties.evidence.clone(),
        edges: vec![Vec::new(); penalties.len()],
        nodes: Vec::new(),
    };
    let mut sets = UnionFind::new(penalties.len());
    let mut walker = Walker::new(penalties.len(), rule.metric);
    for edge in edges {
        if sets.union(edge.a, edge.b) || closes_long(&lines, &mut walker, edge, scales, rule) {
            lines.edges[edge.a as usize].push(edge.b);
            lines.edges[edge.b as usize].push(edge.a);
        }
    }
    for list in &mut lines.edges {
        list.sort_unstable();
    }
    lines
}

/// The cycle test: whether the cycle that `edge` closes is longer than `rho` (the paper's `pathLonger`) and, in the robust
/// form, open.
pub(crate) fn closes_long(
    lines: &LineGraph,
    walker: &mut Walker,
    edge: &Candidate,
    scales: Scales,
    rule: CycleRule,
) -> bool {
    let unit = scales.between(lines.points[edge.a as usize], lines.points[edge.b as usize]);
    let closing = walker.length(lines, edge.a, edge.b);
    if walker.path(lines, edge.a, edge.b, rule.rho - closing).is_some() {
        return false;
    }
    match rule.form {
        PenaltyForm::Paper => true,
        // A cycle much longer than it is wide may be two strands of one band: the shortest one decides.
        PenaltyForm::Robust => walker
            .path(lines, edge.a, edge.b, WHOLE_CYCLE * rule.rho)
            .is_none_or(|path| openness(&lines.positions, &path) >= rule.openness * unit),
    }
}

/// Ratio of area to length of the polygon through `path`.
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
