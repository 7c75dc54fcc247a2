//! From a pattern to a network: strips between nodes, each with its curve.

mod nodes;
mod tidy;
mod verify;
mod world;

pub use verify::take_back;
pub use world::to_world;

use crate::curve::{FitOptions, fit};
use crate::math::vec3::{distance, distance2};
use crate::network::{Network, Node, NodeKind, Strip, StripKind};
use crate::params::SplineParams;
use crate::pattern::{LineGraph, Path, Pattern, paths};
use crate::resolution::Resolution;

/// Creases up to this many spacings long that hang on a node with nothing at their other end are left out.
const STUB: f64 = 3.0;

/// Strips and nodes of a pattern, with smooth curves (Gumhold 2001, section 4, the simple solution); local frame, sources as
/// canonical indices.
pub fn recover(pattern: &Pattern, resolution: Resolution, params: &SplineParams) -> Network {
    let mut network = Network::default();
    let met = |lines| nodes::meet(lines, paths(lines), resolution);
    let (mut crease, border) = (met(&pattern.crease), met(&pattern.border));
    nodes::agree((&pattern.crease, &mut crease), (&pattern.border, &border), resolution);
    for (kind, meeting) in [(StripKind::Crease, crease), (StripKind::Border, border)] {
        append(&mut network, kind, pattern.of(kind), meeting, resolution, params);
    }
    tidy::tidy(&mut network, STUB * resolution.unit());
    network
}

fn append(
    network: &mut Network,
    kind: StripKind,
    lines: &LineGraph,
    meeting: nodes::Meeting,
    resolution: Resolution,
    params: &SplineParams,
) {
    let nodes::Meeting { paths, clusters, .. } = meeting;
    let first = network.nodes.len() as u32;
    for cluster in &clusters {
        network.nodes.push(Node {
            position: cluster.position,
            kind: NodeKind::End,
            degree: 0,
            source: lines.points[cluster.vertex as usize],
        });
    }
    for path in paths {
        let ends = path.ends.map(|[a, b]| [first + a, first + b]);
        network.strips.push(strip(network, kind, lines, &path, ends, resolution, params));
    }
}

/// The span that suits the noise: more data for a control point where each says less.
fn span(params: &SplineParams, resolution: Resolution) -> f64 {
    let ratio = resolution.noise / resolution.spacing;
    params.span_spacings.or(|| 3.0 + 6.0 * ratio.min(1.0)) * resolution.unit()
}

fn strip(
    network: &Network,
    kind: StripKind,
    lines: &LineGraph,
    path: &Path,
    ends: Option<[u32; 2]>,
    resolution: Resolution,
    params: &SplineParams,
) -> Strip {
    let mut positions: Vec<[f64; 3]> = path.vertices.iter().map(|&v| lines.positions[v as usize]).collect();
    if let Some([start, end]) = ends {
        let last = positions.len() - 1;
        positions[0] = network.nodes[start as usize].position;
        positions[last] = network.nodes[end as usize].position;
    }
    let options = FitOptions { span: span(params, resolution), smoothing: 0.1, closed: ends.is_none() };
    let (curve, parameters) = fit(&positions, options);
    let squares: f64 = positions.iter().zip(&parameters).map(|(&p, &t)| distance2(p, curve.point(t))).sum();
    let mut sources: Vec<u32> = path.vertices.iter().map(|&v| lines.points[v as usize]).collect();
    sources.dedup();
    Strip {
        kind,
        closed: ends.is_none(),
        start: ends.map(|e| e[0]),
        end: ends.map(|e| e[1]),
        points: polyline(&curve, params.step_spacings * resolution.spacing),
        curve,
        sources,
        fold_deg: fold_deg(lines, path),
        evidence: mean(&lines.evidence, path),
        deviation: (squares / positions.len() as f64).sqrt(),
        confidence: (1.0 - mean(&lines.penalty, path)).clamp(0.0, 1.0),
    }
}

/// The mean over the vertices of a path.
fn mean(values: &[f32], path: &Path) -> f64 {
    path.vertices.iter().map(|&v| f64::from(values[v as usize])).sum::<f64>() / path.vertices.len() as f64
}

/// The mean fold over the vertices that measured one, degrees.
fn fold_deg(lines: &LineGraph, path: &Path) -> Option<f64> {
    let folds = || path.vertices.iter().map(|&v| f64::from(lines.fold[v as usize])).filter(|&f| f > 0.0);
    let count = folds().count();
    (count > 0).then(|| (folds().sum::<f64>() / count as f64).to_degrees())
}

/// Most points written for a span of a curve: enough to follow any cubic, and no more where points lie far apart.
const POINTS_A_SPAN: usize = 64;

/// Points on the curve about `step` apart; a closed curve's first is not repeated.
fn polyline(curve: &crate::curve::BSpline, step: f64) -> Vec<[f64; 3]> {
    let (from, to) = curve.domain();
    let most = POINTS_A_SPAN * curve.controls.len();
    let pieces = (((to - from) / step).ceil() as usize).clamp(if curve.periodic { 3 } else { 1 }, most);
    let last = if curve.periodic { pieces - 1 } else { pieces };
    let mut points: Vec<[f64; 3]> =
        (0..=last).map(|i| curve.point(from + (to - from) * i as f64 / pieces as f64)).collect();
    if !curve.periodic {
        // The curve's ends are its end controls; written so, they equal the nodes to the bit.
        points[0] = curve.controls[0];
        points[last] = curve.controls[curve.controls.len() - 1];
    }
    points.dedup_by(|a, b| distance(*a, *b) == 0.0);
    points
}

#[cfg(test)]
mod tests;
