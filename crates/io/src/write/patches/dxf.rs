//! The loops of patches as DXF, each on the layer of its patch.

use crate::write::encode::dxf::{Drawing, Layer, Shape};
use crate::write::network::NetworkContext;
use crate::write::network::dxf::piece;
use lineament::Network;
use lineament::patch::Loop;
use std::io::{self, Write};

/// A loop is the typed curves of its strips; one with a strip that has none is a 3D POLYLINE.
pub(super) fn write(out: &mut dyn Write, network: &Network, context: &NetworkContext) -> io::Result<()> {
    let patches = context.patches.as_ref().map_or(&[][..], |p| &p.patches);
    let layers: Vec<Layer> =
        (0..patches.len()).map(|p| (format!("PATCH_{p:04}"), (p % 6 + 1) as u8)).collect();
    let loops = patches.iter().enumerate().flat_map(|(p, patch)| patch.loops.iter().map(move |l| (p, l)));
    let entities = loops.flat_map(|(p, boundary)| shapes(network, boundary).into_iter().map(move |s| (p, s)));
    Drawing { unit: context.known_unit(), layers, entities: entities.collect() }.write(out)
}

fn shapes<'a>(network: &'a Network, boundary: &Loop) -> Vec<Shape<'a>> {
    let strips = || boundary.coedges.iter().map(|c| &network.strips[c.strip as usize]);
    if strips().all(|strip| !strip.curves.is_empty()) {
        return strips().flat_map(|strip| &strip.curves).map(piece).collect();
    }
    let points = points(network, boundary);
    if points.len() < 2 {
        return Vec::new();
    }
    vec![Shape::Polyline { points: points.into(), closed: boundary.closed }]
}

/// The points of a loop in order, where strips meet once; the first is not repeated.
fn points(network: &Network, boundary: &Loop) -> Vec<[f64; 3]> {
    let mut points: Vec<[f64; 3]> = Vec::new();
    for c in &boundary.coedges {
        let strip = network.strips[c.strip as usize].points.iter().copied();
        if c.forward { points.extend(strip) } else { points.extend(strip.rev()) }
    }
    points.dedup();
    if boundary.closed && points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    points
}
