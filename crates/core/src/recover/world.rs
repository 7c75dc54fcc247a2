//! Takes a network from the local frame to that of the input.

use super::tidy::settle;
use crate::frame::{Frame, on_grid};
use crate::network::Network;

/// The network with positions in the world frame and sources as indices of the input; and whether each strip stays, as rounding
/// far from the origin can be too coarse for a short line.
pub fn to_world(mut network: Network, frame: &Frame, source: &[u32]) -> (Network, Vec<bool>) {
    let unit = frame.length_to_world(1.0);
    let placed = |p: [f64; 3]| frame.to_world(p.map(on_grid));
    for node in &mut network.nodes {
        node.position = placed(node.position);
        node.source = source[node.source as usize];
    }
    for strip in &mut network.strips {
        for p in &mut strip.points {
            *p = placed(*p);
        }
        strip.points.dedup();
        strip.curve = strip.curve.mapped(placed, unit);
        strip.deviation *= unit;
        let last = strip.points.len() - usize::from(!strip.closed);
        for piece in &mut strip.curves {
            piece.place(placed, unit);
            (piece.first, piece.last) = (piece.first.min(last), piece.last.min(last));
        }
        for s in &mut strip.sources {
            *s = source[*s as usize];
        }
    }
    let stay = settle(&mut network);
    (network, stay)
}
