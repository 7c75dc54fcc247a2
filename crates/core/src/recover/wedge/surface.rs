//! A face in the cross-section of a crease: a plane or a quadric over its tangent plane, fitted without the points nearest the edge.
//!
//! This departs from Gumhold 2001, section 4.1, which fits planes to all points: those nearest the edge may belong to either face, and
//! noise mixes them; a face that bends is a plane only near the edge.

use crate::math::least_squares::{inverse, solve};
use crate::math::quantile::quantile;
use crate::math::vec3::{cross, dot, sub};

/// Coefficients of a quadric: height, slopes away from and along the edge, and the three second-order ones.
pub(super) const TERMS: usize = 6;
/// Rounds of weighting and solving.
const ROUNDS: usize = 3;
/// Residual, in standard deviations, at which the weight is zero: 95 % efficiency for normal errors (Beaton and Tukey 1974).
const BIWEIGHT: f64 = 4.685;
/// Share of the variance of normal errors that these weights leave, `E[w r^2] / E[w]`.
const TAKEN: f64 = 0.828;
/// Variance of the coefficients against that which the weighted normal equations give: `E[w] / 0.95`.
const EFFICIENT: f64 = 0.963;
/// Median of absolute normal errors to their standard deviation.
const FROM_MEDIAN: f64 = 1.4826;
/// Points more than coefficients that a fit needs.
const SPARE: usize = 4;

/// Axes of a face at a crease point: away from the edge, along it, and off the face.
#[derive(Clone, Copy, Debug)]
pub(in crate::recover) struct Axes {
    pub origin: [f64; 3],
    pub away: [f64; 3],
    pub along: [f64; 3],
    pub normal: [f64; 3],
}

impl Axes {
    /// At `origin`, `along` the crease, for a face with this normal, which leads away towards `inside`; `None` where the normal runs
    /// along the crease.
    pub(super) fn new(origin: [f64; 3], along: [f64; 3], normal: [f64; 3], inside: [f64; 3]) -> Option<Self> {
        let away = cross(along, normal);
        let length = dot(away, away).sqrt();
        if length < 0.5 {
            return None;
        }
        let sign = if dot(away, sub(inside, origin)) < 0.0 { -1.0 } else { 1.0 };
        let away = away.map(|x| sign * x / length);
        Some(Self { origin, away, along, normal: cross(away, along) })
    }

    /// Coordinates away, along and off.
    pub(super) fn local(&self, p: [f64; 3]) -> [f64; 3] {
        let d = sub(p, self.origin);
        [dot(d, self.away), dot(d, self.along), dot(d, self.normal)]
    }
}

/// A fitted face: `w = a + b u + c v + d u^2 + e u v + f v^2` in its axes, of which a plane has the first three.
#[derive(Clone, Copy, Debug)]
pub(in crate::recover) struct Fit {
    pub coefficients: [f64; TERMS],
    /// Covariance of the coefficients for points of variance one.
    pub inverse: [[f64; TERMS]; TERMS],
    /// Variance of a point off the face.
    pub variance: f64,
    /// Share of the points that lie on the face.
    pub share: f64,
}

impl Fit {
    /// The height of the face, `u` away from the edge and in the cross-section.
    pub(in crate::recover) fn height(&self, u: f64) -> f64 {
        let [a, b, _, d, ..] = self.coefficients;
        a + (b + d * u) * u
    }

    /// Its height `u` away from the edge and `v` along it.
    pub(super) fn height_at(&self, u: f64, v: f64) -> f64 {
        terms(u, v).iter().zip(self.coefficients).map(|(t, c)| t * c).sum()
    }

    /// Its slopes there, away from the edge and along it.
    pub(in crate::recover) fn slopes(&self, u: f64) -> [f64; 2] {
        let [_, b, c, d, e, _] = self.coefficients;
        [b + 2.0 * d * u, c + e * u]
    }

    /// The variance of its height there, for points of variance one.
    pub(super) fn leverage(&self, u: f64) -> f64 {
        let terms = terms(u, 0.0);
        let with = |row: &[f64; TERMS]| row.iter().zip(terms).map(|(c, t)| c * t).sum::<f64>();
        self.inverse.iter().zip(terms).map(|(row, t)| t * with(row)).sum::<f64>().max(0.0)
    }

    /// The variance of its height there.
    pub(in crate::recover) fn variance_at(&self, u: f64) -> f64 {
        self.variance * self.leverage(u)
    }
}

fn terms(u: f64, v: f64) -> [f64; TERMS] {
    [1.0, u, v, u * u, u * v, v * v]
}

/// Fits a plane (`count` 3) or a quadric (6) to points in a face's axes, by weighted rounds from the first guess `start`, or from the
/// least squares of all. Points far off lose their weight. `scale` is the standard deviation of a point before the fit, `floor` the
/// least after it.
pub(super) fn fit(
    points: &[[f64; 3]],
    count: usize,
    start: Option<&Fit>,
    scale: f64,
    floor: f64,
) -> Option<Fit> {
    if points.len() < count + SPARE {
        return None;
    }
    let off = |c: &[f64; TERMS], [u, v, w]: [f64; 3]| {
        w - terms(u, v).iter().zip(c).map(|(t, c)| t * c).sum::<f64>()
    };
    let mut coefficients = start.map(|s| s.coefficients);
    let mut scale = scale;
    let mut last = None;
    for _ in 0..ROUNDS {
        let weight = |p: [f64; 3]| match &coefficients {
            None => 1.0,
            Some(c) => (1.0 - (off(c, p) / (BIWEIGHT * scale)).powi(2)).max(0.0).powi(2),
        };
        let (matrix, right, total) = normal(points, count, weight);
        let solved = solve(matrix, right)?;
        let mut sizes: Vec<f64> =
            points.iter().filter(|&&p| weight(p) > 0.0).map(|&p| off(&solved, p).abs()).collect();
        if sizes.len() < count + SPARE {
            return None;
        }
        let on = sizes.len();
        let squares: f64 = points.iter().map(|&p| weight(p) * off(&solved, p).powi(2)).sum();
        let free = (total - count as f64).max(1.0);
        let robust = FROM_MEDIAN * quantile(&mut sizes, 0.5);
        scale = robust.max(floor);
        let taken = if coefficients.is_some() { TAKEN } else { 1.0 };
        let variance = (squares / free / taken).max(floor * floor);
        last = Some((solved, matrix, variance, on));
        coefficients = Some(solved);
    }
    let (coefficients, matrix, variance, on) = last?;
    let whole = inverse(matrix)?;
    let kept = |i: usize, j: usize| if i < count && j < count { EFFICIENT * whole[i][j] } else { 0.0 };
    let inverse = std::array::from_fn(|i| std::array::from_fn(|j| kept(i, j)));
    Some(Fit { coefficients, inverse, variance, share: on as f64 / points.len() as f64 })
}

/// The normal equations, the unused coefficients held at zero, and the sum of the weights.
fn normal(
    points: &[[f64; 3]],
    count: usize,
    weight: impl Fn([f64; 3]) -> f64,
) -> ([[f64; TERMS]; TERMS], [f64; TERMS], f64) {
    let (mut matrix, mut right, mut total) = ([[0.0; TERMS]; TERMS], [0.0; TERMS], 0.0);
    for &p in points {
        let weight = weight(p);
        if weight == 0.0 {
            continue;
        }
        let terms = terms(p[0], p[1]);
        for i in 0..count {
            (0..count).for_each(|j| matrix[i][j] += weight * terms[i] * terms[j]);
            right[i] += weight * terms[i] * p[2];
        }
        total += weight;
    }
    (count..TERMS).for_each(|k| matrix[k][k] = 1.0);
    (matrix, right, total)
}
