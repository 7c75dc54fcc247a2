//! The middle of a band: local regression between its corners.

use super::corner::corners;
use super::regression::{parabola, regress, spacing_at, width};
use crate::math::vec2::distance;
use crate::section::contour::band::Band;
use crate::section::contour::chain::{Chain, Vertex};

/// The smooth middle of a band, given the noise in local spacings and the least turn at a corner without it.
pub(crate) fn middle(band: &Band, noise: f64, corner_deg: f64) -> Chain {
    let corners = corners(band, noise, corner_deg);
    let mut vertices = Vec::new();
    if corners.is_empty() {
        stretch(band, noise, 0.0, band.length, false, &mut vertices);
        if !band.chain.closed {
            vertices.extend(end_vertex(band, noise));
        }
        return Chain { vertices, closed: band.chain.closed };
    }
    if !band.chain.closed {
        stretch(band, noise, 0.0, corners[0].0, false, &mut vertices);
    }
    for (k, corner) in corners.iter().enumerate() {
        vertices.push(corner.1);
        let last = k + 1 == corners.len();
        let end = match (last, band.chain.closed) {
            (false, _) => corners[k + 1].0,
            (true, true) => corners[0].0 + band.length,
            (true, false) => band.length,
        };
        stretch(band, noise, corner.0, end, true, &mut vertices);
    }
    if !band.chain.closed {
        vertices.extend(end_vertex(band, noise));
    }
    Chain { vertices, closed: band.chain.closed }
}

/// Vertices between two arcs, a little under a spacing apart; the samples used stay between the arcs where those
/// are corners.
fn stretch(band: &Band, noise: f64, from: f64, to: f64, corner: bool, vertices: &mut Vec<Vertex>) {
    let h = spacing_at(band, 0.5 * (from + to)).max(1e-300);
    let pieces = ((to - from) / h).round().clamp(1.0, 4e6) as usize;
    let whole = !corner && band.chain.closed;
    let (low, high) = if whole { (f64::NEG_INFINITY, f64::INFINITY) } else { (from, to) };
    for k in usize::from(corner)..pieces {
        let arc = from + (to - from) * k as f64 / pieces as f64;
        let local_h = spacing_at(band, band.wrapped(arc));
        if let Some(local) = parabola(band, arc, width(band, arc, local_h, noise) * local_h, low, high) {
            // Far from the polyline the regression runs away on too few samples.
            let at = if distance(local.at, band.at(arc)) <= local_h { local.at } else { band.at(arc) };
            vertices.push(Vertex::new(at, local_h));
        }
    }
}

fn end_vertex(band: &Band, noise: f64) -> Option<Vertex> {
    let h = spacing_at(band, band.length);
    regress(band, band.length, width(band, band.length, h, noise) * h, f64::NEG_INFINITY, f64::INFINITY)
        .map(|local| Vertex::new(local.at, h))
}
