//! A line or a circle as its points or faces show it, before its ends were laid on nodes, with the covariance of all its parameters.

use super::free::Free;
use super::piece::{Piece, Shape, Sigma};
use crate::curve::round::{Round, plane};
use crate::math::vec3::{cross, distance, dot, perpendicular, scale, sub, unit};

/// Share of a row at either end of which the points are left out: they lead to nodes, which are known less well.
const ENDS: usize = 6;
/// Fewest points of a line.
const FEWEST: usize = 3;

/// A line or a circle with its covariance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Observed {
    /// A line through its middle, or a circle.
    pub free: Free,
    /// Two unit vectors across the line, or in the plane of the circle.
    pub axes: [[f64; 3]; 2],
    /// Half the length of the line that was seen; the radius of the circle.
    pub half: f64,
    /// Of a line: of the shifts of its end along both axes against its middle, nothing, nothing, of the shifts of its middle. Of a circle:
    /// of the centre along both axes, of the tilts about them as lengths at the radius, of the radius, of the centre along the normal.
    pub covariance: [[f64; 6]; 6],
}

impl Observed {
    /// Of a piece over these points, by the standard deviations that it has; `None` for splines, and where it has none.
    pub(crate) fn of(piece: &Piece, points: &[[f64; 3]]) -> Option<Self> {
        match (&piece.shape, piece.sigma?) {
            (Shape::Line, Sigma::Line { offset, direction }) => line(piece, points, offset, direction),
            (Shape::Arc { round, .. } | Shape::Circle(round), Sigma::Round { normal, covariance, .. }) => {
                Some(circle(*round, normal, &covariance))
            }
            _ => None,
        }
    }

    /// The unit direction of the line, the unit normal of the circle.
    pub(crate) fn direction(&self) -> [f64; 3] {
        match self.free {
            Free::Line { direction, .. } => direction,
            Free::Arc(round) => round.normal,
            Free::Ellipse(_) | Free::Other => [0.0; 3],
        }
    }

    /// The middle of the line, the centre of the circle.
    pub(crate) fn middle(&self) -> [f64; 3] {
        match self.free {
            Free::Line { at, .. } => at,
            Free::Arc(round) => round.centre,
            Free::Ellipse(_) | Free::Other => [0.0; 3],
        }
    }

    /// The circle; `None` of a line.
    pub(crate) fn round(&self) -> Option<Round> {
        match self.free {
            Free::Arc(round) => Some(round),
            _ => None,
        }
    }
}

fn line(piece: &Piece, points: &[[f64; 3]], offset: f64, direction: f64) -> Option<Observed> {
    let skip = points.len() / ENDS;
    let inner = &points[skip..points.len() - skip];
    if inner.len() < FEWEST {
        return None;
    }
    let (at, [along, ..]) = plane(inner)?;
    let along = if dot(along, sub(piece.to, piece.from)) < 0.0 { scale(along, -1.0) } else { along };
    let along = unit(along);
    let half = 0.5 * distance(piece.from, piece.to);
    let mut covariance = [[0.0; 6]; 6];
    for k in 0..2 {
        covariance[k][k] = (direction * half).powi(2);
        covariance[4 + k][4 + k] = offset * offset;
    }
    let across = perpendicular(along);
    let axes = [across, cross(along, across)];
    (half > 0.0).then_some(Observed { free: Free::Line { at, direction: along }, axes, half, covariance })
}

fn circle(round: Round, normal: f64, known: &[[f64; 4]; 4]) -> Observed {
    let u = perpendicular(round.normal);
    let axes = [u, cross(round.normal, u)];
    // Where the parameters stand among the six: the centre on three axes and the radius.
    let rows: [(usize, [f64; 4]); 4] = [
        (0, [axes[0][0], axes[0][1], axes[0][2], 0.0]),
        (1, [axes[1][0], axes[1][1], axes[1][2], 0.0]),
        (4, [0.0, 0.0, 0.0, 1.0]),
        (5, [round.normal[0], round.normal[1], round.normal[2], 0.0]),
    ];
    let mut covariance = [[0.0; 6]; 6];
    for (i, a) in rows {
        for (j, b) in rows {
            let inner = |k: usize| (0..4).map(|l| known[k][l] * b[l]).sum::<f64>();
            covariance[i][j] = (0..4).map(|k| a[k] * inner(k)).sum();
        }
    }
    for tilt in [2, 3] {
        covariance[tilt][tilt] = 0.5 * (normal * round.radius).powi(2);
    }
    Observed { free: Free::Arc(round), axes, half: round.radius, covariance }
}
