//! A row of points along a curve as lines, arcs, circles and splines end to end, those of least description length.
//!
//! [`search`] finds the breaks between lines and arcs, [`refine`] moves them, [`merge`] puts runs of short arcs together where a spline
//! says them in fewer numbers, [`join`] lets the pieces meet.

mod join;
mod merge;
mod refine;
mod search;
mod sigma;

pub use sigma::Sigma;

use super::BSpline;
use super::round::Round;
use crate::math::vec3::{add_scaled, distance2, dot, sub};

/// One curve of a row of points.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Its kind with its parameters.
    pub shape: Shape,
    /// Its first point, the last one of the piece before it.
    pub from: [f64; 3],
    /// Its last point.
    pub to: [f64; 3],
    /// The first point of the row that it stands for.
    pub first: usize,
    /// The last one. At most `first` where the piece runs over the end of a closed row.
    pub last: usize,
    /// Root mean square distance of these points from it.
    pub deviation: f64,
    /// How well its parameters are known; `None` for splines, and where the points do not determine them.
    pub sigma: Option<Sigma>,
}

/// Kinds of curves.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Straight from end to end.
    Line,
    /// From end to end counter-clockwise about the normal.
    Arc {
        /// The circle that it is part of.
        round: Round,
        /// The angle swept, radians, 0 to a full turn.
        sweep: f64,
    },
    /// A whole circle.
    Circle(Round),
    /// A cubic B-spline.
    Spline(BSpline),
}

impl Shape {
    /// The name in files: `line`, `arc`, `circle` or `b-spline`.
    pub fn name(&self) -> &'static str {
        match self {
            Shape::Line => "line",
            Shape::Arc { .. } => "arc",
            Shape::Circle(_) => "circle",
            Shape::Spline(_) => "b-spline",
        }
    }
}

/// What is known of the points before any curve is fitted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Noise {
    /// Standard deviation of a point across the curve.
    pub sigma: f64,
    /// Independent observations that a point stands for: neighbours err alike.
    pub share: f64,
    /// Natural logarithm of the number of independent observations.
    pub log_count: f64,
    /// Whether the points lie in a plane that is known.
    pub flat: bool,
}

impl Noise {
    /// Of a row of `count` points that is `length` long, where points err alike over a length of `reach`.
    pub(crate) fn new(sigma: f64, reach: f64, count: usize, length: f64) -> Self {
        let share = (length / (count.max(2) - 1) as f64 / reach).clamp(1e-3, 1.0);
        Self { sigma, share, log_count: (share * count as f64).max(2.0).ln(), flat: false }
    }

    /// The description length of a piece, nats.
    fn cost(&self, parameters: usize, squares: f64) -> f64 {
        0.5 * squares / (self.sigma * self.sigma) + 0.5 * parameters as f64 * self.log_count
    }

    /// The number of parameters of a piece: its curve and where on it the piece ends.
    fn parameters(&self, kind: Kind) -> usize {
        let curve = match (kind, self.flat) {
            (Kind::Line, false) => 4,
            (Kind::Line, true) => 2,
            (Kind::Arc, false) => 7,
            (Kind::Arc, true) => 4,
            (Kind::Spline(controls), false) => 3 * controls,
            (Kind::Spline(controls), true) => 2 * controls,
        };
        curve + 1
    }
}

/// Kinds of pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Line,
    Arc,
    /// With this number of control points.
    Spline(usize),
}

impl Kind {
    /// Least number of steps from point to point that speak for the kind: three points lie on a circle.
    fn fewest_steps(self) -> usize {
        if self == Kind::Line { 1 } else { 3 }
    }
}

/// Points `first..=last` under one description.
#[derive(Clone, Copy, Debug)]
struct Span {
    first: usize,
    last: usize,
    kind: Kind,
}

/// The pieces of a row of points in order, end to end. The first and last point of an open row are held.
pub(crate) fn pieces(points: &[[f64; 3]], closed: bool, noise: &Noise) -> Vec<Piece> {
    if points.len() < 2 {
        return Vec::new();
    }
    if !closed {
        let weights = weights(points.len(), noise);
        let spans = spans(points, &weights, noise);
        return join::join(points, &spans, noise, false, 0);
    }
    closed_pieces(points, noise)
}

/// Weight of a node against a point in the middle of a strip.
const NODE_WEIGHT: f64 = 0.25;
/// Points from a node on over which the weight rises to that of the others.
const BESIDE_NODE: usize = 4;

fn closed_pieces(points: &[[f64; 3]], noise: &Noise) -> Vec<Piece> {
    let n = points.len();
    let turned = |start: usize| -> Vec<[f64; 3]> { (0..=n).map(|k| points[(start + k) % n]).collect() };
    let weights = vec![noise.share; n + 1];
    let row = turned(0);
    let found = spans(&row, &weights, noise);
    let other = match found[..] {
        // An arc that comes back to where it began is the circle.
        [Span { kind: Kind::Arc, .. }] => f64::INFINITY,
        _ => merge::cost(&row, &weights, noise, &found),
    };
    if let Some(whole) = merge::whole(points, noise, other) {
        return vec![whole];
    }
    // The first row was broken where it happened to begin.
    let start = found[found.len() / 2].first;
    let row = turned(start);
    let found = spans(&row, &weights, noise);
    join::join(&row, &found, noise, true, start)
}

/// Weights of an open row: the nodes at its ends, and the points beside them, are less certain than those between.
fn weights(count: usize, noise: &Noise) -> Vec<f64> {
    let mut weights = vec![noise.share; count];
    for k in 0..BESIDE_NODE.min(count / 3).max(1) {
        let share = NODE_WEIGHT + (1.0 - NODE_WEIGHT) * k as f64 / BESIDE_NODE as f64;
        weights[k] *= share;
        weights[count - 1 - k] *= share;
    }
    weights
}

fn spans(points: &[[f64; 3]], weights: &[f64], noise: &Noise) -> Vec<Span> {
    let mut spans = search::search(points, weights, noise);
    refine::refine(points, weights, noise, &mut spans);
    let mut spans = merge::merge(points, weights, noise, &spans);
    refine::refine(points, weights, noise, &mut spans);
    spans
}

impl Piece {
    /// Moves the piece by an affine `map` that scales lengths by `unit` and turns nothing.
    pub(crate) fn place(&mut self, map: impl Fn([f64; 3]) -> [f64; 3] + Copy, unit: f64) {
        (self.from, self.to) = (map(self.from), map(self.to));
        self.deviation *= unit;
        self.sigma = self.sigma.map(|sigma| sigma.scaled(unit));
        match &mut self.shape {
            Shape::Line => {}
            Shape::Arc { round, .. } | Shape::Circle(round) => {
                round.centre = map(round.centre);
                round.radius *= unit;
            }
            Shape::Spline(curve) => *curve = curve.mapped(map, unit),
        }
    }

    /// The point of the line, or the circle, nearest to `p`; on a spline the nearest of many.
    pub(crate) fn foot(&self, p: [f64; 3]) -> [f64; 3] {
        match &self.shape {
            Shape::Line => {
                let along = sub(self.to, self.from);
                let length2 = dot(along, along).max(f64::MIN_POSITIVE);
                add_scaled(self.from, along, dot(sub(p, self.from), along) / length2)
            }
            Shape::Arc { round, .. } | Shape::Circle(round) => round.foot(p),
            Shape::Spline(curve) => nearest(curve, p),
        }
    }
}

/// The nearest of many points of a spline.
fn nearest(curve: &BSpline, p: [f64; 3]) -> [f64; 3] {
    let (from, to) = curve.domain();
    let count = 16 * curve.controls.len();
    let at = |k: usize| curve.point(from + (to - from) * k as f64 / count as f64);
    (0..=count).map(at).min_by(|a, b| distance2(*a, p).total_cmp(&distance2(*b, p))).unwrap_or(p)
}

#[cfg(test)]
mod tests;
