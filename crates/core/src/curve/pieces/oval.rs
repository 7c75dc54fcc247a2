//! A row of points as one ellipse, where the points determine it: short arcs of free curves are near to many ellipses.

use super::noise::{Kind, Noise};
use crate::curve::ellipse::Ellipse;
use crate::math::vec3::{distance2, norm};
use std::f64::consts::TAU;

/// Description length of the kind beyond its parameters, nats: ellipses are few among the edges of parts.
const RARE: f64 = 5.0;
/// Greatest standard deviation of a half axis, relative to it.
const VAGUE: f64 = 0.05;
/// Standard deviations by which the half axes differ at least.
const APART: f64 = 4.0;
/// Least change of the parameter along the row: a third of a turn.
const LEAST_SWEEP: f64 = TAU / 3.0;
/// Squares that the algebraic fit may have, in those at which the description is no shorter than another.
const GUESS: f64 = 16.0;

/// The ellipse of a row of points and the length of its description, if that is less than `limit`.
pub(crate) fn oval(
    points: &[[f64; 3]],
    weights: &[f64],
    noise: &Noise,
    limit: f64,
) -> Option<(Ellipse, f64)> {
    let own = noise.cost(noise.parameters(Kind::Ellipse), 0.0) + RARE;
    if points.len() <= Kind::Ellipse.fewest_steps() || own >= limit {
        return None;
    }
    let most = 2.0 * noise.sigma * noise.sigma * (limit - own);
    let ellipse = Ellipse::fit(points, weights, GUESS * most)?;
    let squares: f64 = points.iter().zip(weights).map(|(&p, w)| w * distance2(p, ellipse.foot(p))).sum();
    let known = ellipse.known(points, weights)?.within;
    let variance = |v: f64| (noise.sigma * noise.sigma * v).sqrt();
    let (a, b) = (norm(ellipse.major), ellipse.minor);
    let sure = variance(known[2][2]) <= VAGUE * a && variance(known[3][3]) <= VAGUE * b;
    let apart = a - b >= APART * variance(known[2][2] + known[3][3] - 2.0 * known[2][3]);
    let cost = own + noise.cost(0, squares);
    (sure && apart && ellipse.sweep(points).abs() >= LEAST_SWEEP && cost < limit).then_some((ellipse, cost))
}
