//! The minimum spanning graph (MSG): a minimum spanning tree that keeps long cycles (Gumhold 2001, section 3.2).

use super::rule::CycleRule;
use super::web::Web;
use super::weight::Candidate;
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
        radius: vec![0.0; penalties.len()],
        edges: vec![Vec::new(); penalties.len()],
        nodes: Vec::new(),
    };
    let mut web = Web::new(penalties.len());
    for edge in edges {
        if enters(&lines, &mut web, edge, scales, rule) {
            lines.edges[edge.a as usize].push(edge.b);
            lines.edges[edge.b as usize].push(edge.a);
        }
    }
    for list in &mut lines.edges {
        list.sort_unstable();
    }
    lines
}

/// Whether `edge` enters the graph, and in `web` lets it: it joins two pieces, or closes a cycle that stays.
pub(crate) fn enters(
    lines: &LineGraph,
    web: &mut Web,
    edge: &Candidate,
    scales: Scales,
    rule: CycleRule,
) -> bool {
    let length = rule.metric.length(lines, edge.a, edge.b);
    if web.join(edge.a, edge.b, length) {
        return true;
    }
    let closes = closes_long(lines, web, edge, scales, rule);
    if closes {
        web.close(edge.a, edge.b, length);
    }
    closes
}

/// The cycle test: whether the cycle that `edge` closes is longer than `rho` (the paper's `pathLonger`) and, in the robust
/// form, open.
fn closes_long(lines: &LineGraph, web: &mut Web, edge: &Candidate, scales: Scales, rule: CycleRule) -> bool {
    let unit = scales.between(lines.points[edge.a as usize], lines.points[edge.b as usize]);
    let short = rule.rho - rule.metric.length(lines, edge.a, edge.b);
    // A cycle much longer than it is wide may be two strands of one band: the shortest one decides.
    let looked_at = match rule.form {
        PenaltyForm::Paper => short,
        PenaltyForm::Robust => WHOLE_CYCLE * rule.rho,
    };
    web.shortest(edge.a, edge.b, looked_at).is_none_or(|(length, path)| {
        length > short && openness(&lines.positions, &path) >= rule.openness * unit
    })
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
