//! From a pattern to a network: strips between nodes, each with its curve.

mod nodes;
mod spline;
mod tidy;
mod verify;
mod world;

pub use verify::take_back;
pub use world::to_world;

use crate::network::{Network, Node, NodeKind, StripKind};
use crate::params::SplineParams;
use crate::pattern::{LineGraph, Pattern, paths};
use crate::resolution::Resolution;

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
    tidy::tidy(&mut network, params.stub_spacings * resolution.unit());
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
        network.strips.push(spline::strip(network, kind, lines, &path, ends, resolution, params));
    }
}

#[cfg(test)]
mod tests;
