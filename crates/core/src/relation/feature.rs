//! A line or circle of a network with what the relations need of it.

use super::relations::Member;
use crate::curve::Round;
use crate::curve::pieces::Observed;
use crate::math::vec3::dot;

/// A symmetric matrix.
pub(super) type Covariance = [[f64; 3]; 3];

/// How far a line or a circle may lie aside whatever its points say, in spacings: faces are not quite what the fits take them for. Added
/// to all covariances.
const SYSTEMATIC: f64 = 0.01;

/// A line or a circle.
#[derive(Clone, Debug)]
pub(super) struct Feature {
    /// Which curve it is.
    pub member: Member,
    /// As it was seen, its covariance with the systematic part.
    pub observed: Observed,
    /// The middle of the line or the centre.
    pub at: [f64; 3],
    /// Unit direction of the line or normal of the circle.
    pub direction: [f64; 3],
    /// Covariance of the direction.
    pub turn: Covariance,
    /// Covariance of the place; along a line it is zero.
    pub place: Covariance,
}

impl Feature {
    /// Of what was seen where points are `spacing` apart.
    pub(super) fn new(member: Member, mut observed: Observed, spacing: f64) -> Self {
        let floor = (SYSTEMATIC * spacing).powi(2);
        (0..6).for_each(|k| observed.covariance[k][k] += floor);
        let [u, v] = observed.axes;
        let (direction, c) = (observed.direction(), &observed.covariance);
        let (turn, place) = match observed.round() {
            None => (spread(&[(u, 0), (v, 1)], c), spread(&[(u, 4), (v, 5)], c)),
            Some(_) => {
                let minus = v.map(|x| -x);
                (spread(&[(u, 3), (minus, 2)], c), spread(&[(u, 0), (v, 1), (direction, 5)], c))
            }
        };
        let turn = turn.map(|row| row.map(|x| x / (observed.half * observed.half)));
        Self { member, at: observed.middle(), direction, turn, place, observed }
    }

    /// The circle; `None` of a line.
    pub(super) fn round(&self) -> Option<Round> {
        self.observed.round()
    }

    /// The variance of the radius.
    pub(super) fn radius_variance(&self) -> f64 {
        self.observed.covariance[4][4]
    }

    /// Size of the direction's covariance: the less, the surer.
    pub(super) fn doubt(&self) -> f64 {
        (0..3).map(|k| self.turn[k][k]).sum()
    }
}

/// The covariance in space of numbers along axes.
fn spread(axes: &[([f64; 3], usize)], c: &[[f64; 6]; 6]) -> Covariance {
    let mut sum = [[0.0; 3]; 3];
    for (a, i) in axes {
        for (b, j) in axes {
            (0..3).for_each(|k| (0..3).for_each(|l| sum[k][l] += a[k] * c[*i][*j] * b[l]));
        }
    }
    sum
}

/// `a^T m b`.
pub(super) fn between(a: [f64; 3], m: &Covariance, b: [f64; 3]) -> f64 {
    dot(a, m.map(|row| dot(row, b)))
}
