//! From a pattern to a network: strips between nodes, each with its curve.

mod corner;
mod ends;
mod faces;
mod meet;
mod nodes;
mod observe;
mod recovery;
mod rings;
mod sharpen;
mod spline;
mod tidy;
mod verify;
mod wedge;
mod world;

pub(crate) use ends::settle as settle_ends;
pub(crate) use faces::{HOPS as FACE_HOPS, refit};
pub(crate) use meet::meet;
pub(crate) use nodes::{LED_ON, SPANNING};
pub(crate) use observe::observe;
pub use recovery::{Grouped, RecoveredPlace, Recovery};
pub(crate) use rings::close as close_rings;
pub(crate) use sharpen::sharpen;
pub(crate) use spline::span_spacings;
pub use verify::take_back;
pub use world::to_world;

use crate::network::{Network, Node, NodeKind, StripKind};
use crate::parallel;
use crate::params::SplineParams;
use crate::pattern::{LineGraph, Pattern, paths};
use crate::surface::Scales;

/// Strips and nodes of a pattern, with smooth curves (Gumhold 2001, section 4, the simple solution); local frame, sources as
/// canonical indices. Creases between nodes that are up to `contracted` spacings long become one node.
pub(crate) fn recover<'a>(
    pattern: &Pattern,
    scales: impl Into<Scales<'a>>,
    params: &SplineParams,
    contracted: f64,
) -> Network {
    let scales = scales.into();
    let mut network = Network::default();
    let met = |lines, contracted| nodes::meet(lines, paths(lines), scales, contracted);
    // Borders are lines of the spanning graph in the default method too.
    let (mut crease, border) = (met(&pattern.crease, contracted), met(&pattern.border, SPANNING));
    nodes::agree((&pattern.crease, &mut crease), (&pattern.border, &border), scales, contracted);
    for (kind, meeting) in [(StripKind::Crease, crease), (StripKind::Border, border)] {
        append(&mut network, kind, pattern.of(kind), meeting, scales, params);
    }
    tidy::tidy(&mut network, params.stub_spacings, scales);
    network
}

/// Adds the rounded edges of a pattern to a network, after all other strips.
pub(crate) fn append_rounded<'a>(
    network: &mut Network,
    pattern: &Pattern,
    scales: impl Into<Scales<'a>>,
    params: &SplineParams,
) {
    let (lines, scales) = (&pattern.rounded, scales.into());
    let meeting = nodes::meet(lines, paths(lines), scales, LED_ON);
    append(network, StripKind::Rounded, lines, meeting, scales, params);
}

fn append(
    network: &mut Network,
    kind: StripKind,
    lines: &LineGraph,
    meeting: nodes::Meeting,
    scales: Scales,
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
            sigma: None,
        });
    }
    let nodes = &network.nodes;
    let strips = parallel::map(paths.len(), parallel::TASK, |p| {
        let path = &paths[p];
        let ends = path.ends.map(|[a, b]| [first + a, first + b]);
        spline::strip(nodes, kind, lines, path, ends, scales, params)
    });
    network.strips.extend(strips);
}

#[cfg(test)]
mod tests;
