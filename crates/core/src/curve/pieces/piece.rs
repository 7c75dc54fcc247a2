//! A typed curve and how well it is known.

use crate::curve::{BSpline, Ellipse, Round};
use crate::math::vec3::{add_scaled, distance2, dot, sub};

/// One curve of a row of points.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    /// Root mean square distance of these points from it; of the points of the strip where it was laid along the faces.
    pub deviation: f64,
    /// How well its parameters are known; `None` for splines, and where the points do not determine them.
    pub sigma: Option<Sigma>,
}

/// Kinds of curves.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    /// An ellipse, or part of one: from end to end counter-clockwise about the normal.
    Ellipse {
        /// The ellipse.
        ellipse: Ellipse,
        /// The change of its parameter, radians, 0 to a full turn.
        sweep: f64,
    },
    /// A cubic B-spline.
    Spline(BSpline),
}

impl Shape {
    /// The name in files: `line`, `arc`, `circle`, `ellipse` or `b-spline`.
    pub fn name(&self) -> &'static str {
        match self {
            Shape::Line => "line",
            Shape::Arc { .. } => "arc",
            Shape::Circle(_) => "circle",
            Shape::Ellipse { .. } => "ellipse",
            Shape::Spline(_) => "b-spline",
        }
    }
}

/// Standard deviations of a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Sigma {
    /// Of a line.
    Line {
        /// Across the line at its middle, in either direction.
        offset: f64,
        /// Of its direction, radians, in either direction.
        direction: f64,
    },
    /// Of an arc or a circle.
    Round {
        /// Of the radius.
        radius: f64,
        /// Of the normal, radians: the root of the sum of both squares.
        normal: f64,
        /// Covariance of centre and radius: x, y, z, r.
        covariance: [[f64; 4]; 4],
    },
    /// Of an ellipse.
    Ellipse {
        /// Of its turn within its plane, radians.
        turn: f64,
        /// Of the normal, radians: the root of the sum of both squares.
        normal: f64,
        /// Covariance of centre and half axes: x, y, z, greater, lesser.
        covariance: [[f64; 5]; 5],
    },
}

impl Sigma {
    /// In a unit of which one of today's has `unit`.
    fn scaled(self, unit: f64) -> Self {
        match self {
            Sigma::Line { offset, direction } => Sigma::Line { offset: offset * unit, direction },
            Sigma::Round { radius, normal, covariance } => Sigma::Round {
                radius: radius * unit,
                normal,
                covariance: covariance.map(|row| row.map(|c| c * unit * unit)),
            },
            Sigma::Ellipse { turn, normal, covariance } => Sigma::Ellipse {
                turn,
                normal,
                covariance: covariance.map(|row| row.map(|c| c * unit * unit)),
            },
        }
    }
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
            Shape::Ellipse { ellipse, .. } => *ellipse = ellipse.mapped(map, unit),
            Shape::Spline(curve) => *curve = curve.mapped(map, unit),
        }
    }

    /// The point of the line, the circle or the ellipse nearest to `p`; on a spline the nearest of many.
    pub(crate) fn foot(&self, p: [f64; 3]) -> [f64; 3] {
        match &self.shape {
            Shape::Line => {
                let along = sub(self.to, self.from);
                let length2 = dot(along, along).max(f64::MIN_POSITIVE);
                add_scaled(self.from, along, dot(sub(p, self.from), along) / length2)
            }
            Shape::Arc { round, .. } | Shape::Circle(round) => round.foot(p),
            Shape::Ellipse { ellipse, .. } => ellipse.foot(p),
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
