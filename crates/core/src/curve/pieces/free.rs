//! A curve before it has ends, and the place where two of them meet.

use super::piece::{Piece, Shape};
use crate::curve::ellipse::Ellipse;
use crate::curve::round::Round;
use crate::math::vec3::{add_scaled, distance, dot, sub, unit};

/// Rounds of feet from one curve to the other on the way to where they meet.
const FEET: usize = 60;

/// A line, circle or ellipse without ends.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Free {
    /// Through a point in a unit direction.
    Line {
        /// A point of it.
        at: [f64; 3],
        /// Its unit direction.
        direction: [f64; 3],
    },
    /// A circle.
    Arc(Round),
    /// An ellipse.
    Ellipse(Ellipse),
    /// None of them: it meets others where it ends.
    Other,
}

impl Free {
    /// Of a piece.
    pub(crate) fn of(piece: &Piece) -> Free {
        match &piece.shape {
            Shape::Line => Free::Line { at: piece.from, direction: unit(sub(piece.to, piece.from)) },
            Shape::Arc { round, .. } | Shape::Circle(round) => Free::Arc(*round),
            Shape::Ellipse { ellipse, .. } => Free::Ellipse(*ellipse),
            Shape::Spline(_) => Free::Other,
        }
    }

    /// The point of the curve nearest to `p`.
    pub(super) fn foot(&self, p: [f64; 3]) -> [f64; 3] {
        match self {
            Free::Line { at, direction } => add_scaled(*at, *direction, dot(sub(p, *at), *direction)),
            Free::Arc(round) => round.foot(p),
            Free::Ellipse(ellipse) => ellipse.foot(p),
            Free::Other => p,
        }
    }
}

/// Where two curves meet near a point: where feet from one to the other come to rest, if that is not farther than `reach`.
pub(super) fn meet(a: &Free, b: &Free, near: [f64; 3], reach: f64) -> [f64; 3] {
    let first = (a.foot(near), b.foot(near));
    let mut feet = first;
    for _ in 0..FEET {
        feet.1 = b.foot(feet.0);
        feet.0 = a.foot(feet.1);
    }
    let middle = |(p, q): ([f64; 3], [f64; 3])| add_scaled(p, sub(q, p), 0.5);
    if distance(middle(feet), near) <= reach { middle(feet) } else { middle(first) }
}
