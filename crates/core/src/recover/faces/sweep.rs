//! A line or a circle as the path of a cross-section: coordinates across it, and how they change as it moves.

use crate::curve::Round;
use crate::curve::pieces::{Free, Piece, Shape};
use crate::math::vec3::{add_scaled, cross, dot, norm, perpendicular, scale, sub, unit};

/// Parameters of a path's pose beside the two shifts of the whole cross-section: of a line its two slopes, of a circle two shifts
/// of the centre and two tilts, all as lengths.
pub(in crate::recover) const POSE: usize = 4;

/// The path of a cross-section.
#[derive(Clone, Copy, Debug)]
pub(in crate::recover) enum Sweep {
    /// A straight line.
    Line {
        /// The middle of its stretch.
        middle: [f64; 3],
        /// Its unit direction.
        along: [f64; 3],
        /// A unit vector across it, the first axis of the cross-section.
        across: [f64; 3],
        /// Half the length of the stretch.
        half: f64,
    },
    /// A circle.
    Round {
        /// The circle.
        round: Round,
        /// The unit vector from its centre towards phase 0.
        zero: [f64; 3],
    },
}

/// A point as the path sees it.
#[derive(Clone, Copy, Debug)]
pub(in crate::recover) struct Seen {
    /// Coordinates across the path; of a circle outwards and along its axis.
    pub at: [f64; 2],
    /// Length along the path: from the middle of a line, from phase 0 of a circle.
    pub phase: f64,
    /// How much both coordinates change with each parameter of the pose.
    pub slopes: [[f64; POSE]; 2],
}

impl Sweep {
    /// The path of a piece; `None` for ellipses and splines.
    pub(in crate::recover) fn of(piece: &Piece) -> Option<Self> {
        match &piece.shape {
            Shape::Line => {
                let chord = sub(piece.to, piece.from);
                let half = 0.5 * norm(chord);
                let middle = add_scaled(piece.from, chord, 0.5);
                let along = unit(chord);
                (half > 0.0).then(|| Sweep::Line { middle, along, across: perpendicular(along), half })
            }
            Shape::Arc { round, .. } | Shape::Circle(round) => {
                let zero = unit(sub(round.foot(piece.from), round.centre));
                Some(Sweep::Round { round: *round, zero })
            }
            Shape::Ellipse { .. } | Shape::Spline(_) => None,
        }
    }

    /// The phases between which a piece on the path lies.
    pub(in crate::recover) fn range(&self, piece: &Piece) -> (f64, f64) {
        match (self, &piece.shape) {
            (Sweep::Line { half, .. }, _) => (-half, *half),
            (Sweep::Round { round, .. }, Shape::Arc { sweep, .. }) => (0.0, sweep * round.radius),
            (Sweep::Round { round, .. }, _) => (0.0, std::f64::consts::TAU * round.radius),
        }
    }

    /// The point of the path at a phase.
    pub(in crate::recover) fn point(&self, phase: f64) -> [f64; 3] {
        match self {
            Sweep::Line { middle, along, .. } => add_scaled(*middle, *along, phase),
            Sweep::Round { round, zero } => {
                let (sin, cos) = (phase / round.radius).sin_cos();
                let towards = add_scaled(scale(*zero, cos), cross(round.normal, *zero), sin);
                add_scaled(round.centre, towards, round.radius)
            }
        }
    }

    /// Half the length of a line's stretch, the radius of a circle.
    pub(in crate::recover) fn half(&self) -> f64 {
        match self {
            Sweep::Line { half, .. } => *half,
            Sweep::Round { round, .. } => round.radius,
        }
    }

    /// The path without ends.
    pub(in crate::recover) fn free(&self) -> Free {
        match *self {
            Sweep::Line { middle, along, .. } => Free::Line { at: middle, direction: along },
            Sweep::Round { round, .. } => Free::Arc(round),
        }
    }

    /// Two unit vectors that span the cross-section at the middle of a line, or the plane of a circle.
    pub(in crate::recover) fn axes(&self) -> [[f64; 3]; 2] {
        match self {
            Sweep::Line { along, across, .. } => [*across, cross(*along, *across)],
            Sweep::Round { round, zero } => [*zero, cross(round.normal, *zero)],
        }
    }

    /// A point as the path sees it.
    pub(in crate::recover) fn see(&self, p: [f64; 3]) -> Seen {
        let [u, v] = self.axes();
        match self {
            Sweep::Line { middle, along, half, .. } => {
                let d = sub(p, *middle);
                let phase = dot(d, *along);
                let lever = -phase / half;
                let slopes = [[lever, 0.0, 0.0, 0.0], [0.0, lever, 0.0, 0.0]];
                Seen { at: [dot(d, u), dot(d, v)], phase, slopes }
            }
            Sweep::Round { round, .. } => {
                let d = sub(p, round.centre);
                let (x, y, z) = (dot(d, u), dot(d, v), dot(d, round.normal));
                let off = x.hypot(y).max(f64::MIN_POSITIVE);
                let (cos, sin) = (x / off, y / off);
                let lever = 1.0 / round.radius;
                let slopes =
                    [[-cos, -sin, lever * z * sin, -lever * z * cos], [0.0, 0.0, -lever * y, lever * x]];
                let full = std::f64::consts::TAU;
                Seen {
                    at: [off - round.radius, z],
                    phase: y.atan2(x).rem_euclid(full) * round.radius,
                    slopes,
                }
            }
        }
    }

    /// The path moved by changes of its pose and by `shift` across it; `None` where a circle would vanish.
    pub(in crate::recover) fn moved(&self, pose: [f64; POSE], shift: [f64; 2]) -> Option<Self> {
        let [u, v] = self.axes();
        let plane = |a: f64, b: f64| add_scaled(u.map(|x| a * x), v, b);
        match *self {
            Sweep::Line { middle, along, across, half } => {
                let middle = add_scaled(middle, plane(shift[0], shift[1]), 1.0);
                let along = unit(add_scaled(along, plane(pose[0], pose[1]), 1.0 / half));
                let across = unit(add_scaled(across, along, -dot(across, along)));
                Some(Sweep::Line { middle, along, across, half })
            }
            Sweep::Round { round, zero } => {
                let [x, y, a, b] = pose;
                let normal = unit(add_scaled(round.normal, plane(b, -a), 1.0 / round.radius));
                let centre = add_scaled(round.centre, plane(x, y), 1.0);
                let centre = add_scaled(centre, normal, shift[1]);
                let radius = round.radius + shift[0];
                let zero = unit(add_scaled(zero, normal, -dot(zero, normal)));
                (radius > 0.0).then_some(Sweep::Round { round: Round { centre, normal, radius }, zero })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The slopes are the differences that a small move makes.
    #[test]
    fn slopes_are_those_of_the_coordinates() {
        let round = Round { centre: [1.0, 2.0, 3.0], normal: unit([1.0, -2.0, 0.5]), radius: 4.0 };
        let along = unit([1.0, 1.0, -0.5]);
        let line = Sweep::Line { middle: [0.5, 1.0, 2.0], along, across: perpendicular(along), half: 3.0 };
        for sweep in [Sweep::Round { round, zero: perpendicular(round.normal) }, line] {
            let p = [4.0, 3.5, 6.0];
            let seen = sweep.see(p);
            for k in 0..POSE {
                let mut pose = [0.0; POSE];
                pose[k] = 1e-6;
                let other = sweep.moved(pose, [0.0; 2]).unwrap().see(p);
                for (c, slopes) in seen.slopes.iter().enumerate() {
                    let slope = (other.at[c] - seen.at[c]) / 1e-6;
                    assert!((slope - slopes[k]).abs() < 1e-4, "{sweep:?} {k} {c}: {slope} {}", slopes[k]);
                }
            }
            let shifted = sweep.moved([0.0; POSE], [0.25, -0.5]).unwrap().see(p);
            assert!((shifted.at[0] - seen.at[0] + 0.25).abs() < 1e-9);
            assert!((shifted.at[1] - seen.at[1] - 0.5).abs() < 1e-9);
        }
    }
}
