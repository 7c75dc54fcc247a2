//! Takes a network from the local frame to that of the input.

use super::tidy::settle;
use crate::frame::{Frame, on_grid};
use crate::math::vec3::scale;
use crate::network::{Blend, Network, Strip};

/// The network with positions in the world frame and sources as indices of the input; and whether each strip stays, as rounding
/// far from the origin can be too coarse for a short line. An `exact` network is not rounded to the grid of results: relations hold
/// in it.
pub fn to_world(mut network: Network, frame: &Frame, source: &[u32], exact: bool) -> (Network, Vec<bool>) {
    let unit = frame.length_to_world(1.0);
    let placed = |p: [f64; 3]| frame.to_world(if exact { p } else { p.map(on_grid) });
    for node in &mut network.nodes {
        node.position = placed(node.position);
        node.sigma = node.sigma.map(|s| scale(s, unit));
        node.source = source[node.source as usize];
    }
    for strip in &mut network.strips {
        place_points(strip, placed, unit);
        strip.curve = strip.curve.mapped(placed, unit);
        strip.deviation *= unit;
        strip.blend = strip.blend.map(|b| Blend { radius: b.radius * unit, sigma: b.sigma * unit });
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

/// The points of a strip and their standard deviations; of points that fall together the first stays.
fn place_points(strip: &mut Strip, placed: impl Fn([f64; 3]) -> [f64; 3], unit: f64) {
    let mut sigma = std::mem::take(&mut strip.sigma).into_iter().map(|s| scale(s, unit));
    let mut points: Vec<[f64; 3]> = Vec::with_capacity(strip.points.len());
    for p in strip.points.iter().map(|&p| placed(p)) {
        let sigma = sigma.next();
        if points.last() != Some(&p) {
            points.push(p);
            strip.sigma.extend(sigma);
        }
    }
    strip.points = points;
}
