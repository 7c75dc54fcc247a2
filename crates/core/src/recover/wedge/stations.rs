//! Crease points: places along a strip with the crease direction there (Gumhold 2001, section 4.1).
//!
//! The paper takes the data points of the zigzag pattern at their parameters on the spline. Here the places lie at even steps of
//! the spline itself, so that each stretch of the crease is recovered equally often; the data point nearest to a place lends it
//! its neighbourhood.

use crate::math::vec3::{norm, scale, sub};
use crate::neighbors::{Found, Index};
use crate::network::Strip;
use crate::surface::Scales;

/// Distance of crease points, units of the finest place.
const STEP: f64 = 1.0;
/// Greatest number of crease points for each source of a strip.
const FOR_A_SOURCE: usize = 8;
/// Half the chord from which a direction is taken, as a share of the step: a spline bends gently over it.
const CHORD: f64 = 0.5;

/// A crease point.
#[derive(Clone, Copy, Debug)]
pub(in crate::recover) struct Station {
    /// The smoothed location on the spline (the paper's `p_s`), local frame.
    pub at: [f64; 3],
    /// The unit crease direction (`d_s`).
    pub direction: [f64; 3],
    /// The point of the cloud that belongs to it.
    pub source: u32,
}

/// The crease points of a strip: between the nodes of an open one, all round a closed one. None where the curve has no length.
pub(in crate::recover) fn stations(strip: &Strip, points: &[[f64; 3]], scales: Scales) -> Vec<Station> {
    let (from, to) = strip.curve.domain();
    let step = STEP * scales.finest(&strip.sources).unit();
    let most = FOR_A_SOURCE * strip.sources.len().max(2);
    let count = ((strip.length() / step).round() as usize).clamp(if strip.closed { 8 } else { 2 }, most);
    let places: Vec<[f64; 3]> = strip.sources.iter().map(|&i| points[i as usize]).collect();
    let index = Index::build(&places);
    let mut found: Vec<Found> = Vec::new();
    let inner = if strip.closed { 0..count } else { 1..count };
    let parameter = |k: f64| from + (to - from) * k / count as f64;
    inner
        .filter_map(|k| {
            let at = strip.curve.point(parameter(k as f64));
            let [before, after] = [-CHORD, CHORD].map(|c| strip.curve.point(parameter(k as f64 + c)));
            let chord = sub(after, before);
            let length = norm(chord);
            index.nearest(at, 1, &mut found);
            let source = strip.sources[found.first()?.index as usize];
            (length > 0.0).then(|| Station { at, direction: scale(chord, 1.0 / length), source })
        })
        .collect()
}
