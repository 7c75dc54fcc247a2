//! Two faces and the edge in which they meet, fitted together: Gauss-Newton steps over the pose of the edge's path and the
//! directions and bends of the faces.
//!
//! The residual of a point is its distance from its face in the cross-section that moves with the path, so that a bore's wall
//! is a straight line there. Points off both faces lose their weight (Beaton and Tukey 1974, the biweight). A weak prior holds
//! the path where its vertices were, for directions that the points leave open.

use super::fitted::{Fitted, UNKNOWNS};
use super::lengths::Lengths;
use super::profile::{Place, Profile};
use super::sweep::{POSE, Seen, Sweep};
use crate::math::least_squares::{inverse, solve};
use crate::math::quantile::quantile;

/// Places of the shift, the angles and the bends among the unknowns.
const SHIFT: usize = POSE;
const ANGLES: usize = POSE + 2;
const BENDS: usize = POSE + 4;
/// Rounds of assigning the points and solving.
const ROUNDS: usize = 12;
/// Greatest change of a face's angle in a round, radians.
const TURN: f64 = 0.3;
/// Residual, in standard deviations, at which the weight is zero: 95 % efficiency for normal errors.
const BIWEIGHT: f64 = 4.685;
/// Median of absolute normal errors to their standard deviation.
const FROM_MEDIAN: f64 = 1.4826;

/// One observation: the row of the Jacobian and the residual.
struct Row {
    slopes: [f64; UNKNOWNS],
    residual: f64,
}

/// The normal equations of weighted rows.
struct Normal {
    matrix: [[f64; UNKNOWNS]; UNKNOWNS],
    right: [f64; UNKNOWNS],
}

impl Normal {
    fn add(&mut self, row: &Row, weight: f64) {
        for i in 0..UNKNOWNS {
            let w = weight * row.slopes[i];
            if w != 0.0 {
                (0..UNKNOWNS).for_each(|j| self.matrix[i][j] += w * row.slopes[j]);
                self.right[i] -= w * row.residual;
            }
        }
    }
}

/// Fits the edge along `sweep` to the points near it. `held` are points of the path that the prior holds.
pub(in crate::recover) fn fit(
    points: &[[f64; 3]],
    held: &[[f64; 3]],
    sweep: Sweep,
    lengths: Lengths,
) -> Option<Fitted> {
    let mut sweep = sweep;
    let start: Vec<Seen> = points.iter().map(|&p| sweep.see(p)).filter(|s| lengths.on_faces(s.at)).collect();
    let mut profile = Profile::start(&start)?;
    let mut scale = lengths.gate;
    let mut fitted = None;
    for _ in 0..ROUNDS {
        let gate = BIWEIGHT * scale;
        let (rows, counts) = rows(points, &sweep, &profile, lengths, gate);
        let spread = deviation(&rows, lengths.floor);
        let mut normal = prior(held, &sweep, &profile, lengths, spread);
        rows.iter().for_each(|row| normal.add(row, (1.0 - (row.residual / gate).powi(2)).powi(2)));
        let step = solve(normal.matrix, normal.right)?;
        sweep = sweep.moved(std::array::from_fn(|k| step[k]), [step[SHIFT], step[SHIFT + 1]])?;
        for (k, face) in profile.faces.iter_mut().enumerate() {
            face.angle += step[ANGLES + k].clamp(-TURN, TURN);
            face.bend += step[BENDS + k];
        }
        let covariance = covariance(normal.matrix, spread, lengths)?;
        let fold_sine = profile.fold_sine();
        fitted = Some(Fitted { sweep, profile, counts, covariance, fold_sine, spread });
        scale = spread.max(0.5 * scale);
    }
    fitted
}

/// The covariance of the unknowns: that of least squares less the prior's share for the bends, as most faces are as flat as it says.
fn covariance(
    matrix: [[f64; UNKNOWNS]; UNKNOWNS],
    spread: f64,
    lengths: Lengths,
) -> Option<[[f64; UNKNOWNS]; UNKNOWNS]> {
    let inverse = inverse(matrix)?;
    let weight = (spread / lengths.bend).powi(2);
    let share = |i: usize, j: usize| -> f64 {
        (BENDS..UNKNOWNS).map(|k| weight * inverse[i][k] * inverse[k][j]).sum()
    };
    let entry = |i: usize, j: usize| spread * spread * (inverse[i][j] - share(i, j));
    Some(std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))))
}

/// The rows of the points on a face, and how many each face has.
fn rows(
    points: &[[f64; 3]],
    sweep: &Sweep,
    profile: &Profile,
    lengths: Lengths,
    gate: f64,
) -> (Vec<Row>, [usize; 2]) {
    let mut counts = [0; 2];
    let mut rows = Vec::new();
    for seen in points.iter().map(|&p| sweep.see(p)) {
        let (face, place) = profile.nearest(seen.at);
        if (lengths.clear..=lengths.reach).contains(&place.along) && place.off.abs() < gate {
            counts[face] += 1;
            rows.push(row(&seen, profile, face, place));
        }
    }
    (rows, counts)
}

fn row(seen: &Seen, profile: &Profile, face: usize, place: Place) -> Row {
    let (sin, cos) = profile.faces[face].angle.sin_cos();
    let lean = profile.faces[face].bend * place.along;
    // The normal of the bent face at the point.
    let normal = [-sin - lean * cos, cos - lean * sin];
    let mut slopes = [0.0; UNKNOWNS];
    for (k, slope) in slopes[..POSE].iter_mut().enumerate() {
        *slope = normal[0] * seen.slopes[0][k] + normal[1] * seen.slopes[1][k];
    }
    slopes[SHIFT] = -normal[0];
    slopes[SHIFT + 1] = -normal[1];
    // A turn of the face moves the point's foot too, by its distance.
    slopes[ANGLES + face] = -place.along - lean * place.off;
    slopes[BENDS + face] = -0.5 * place.along * place.along;
    Row { slopes, residual: place.off }
}

/// Standard deviation of the residuals by their median.
fn deviation(rows: &[Row], floor: f64) -> f64 {
    let mut sizes: Vec<f64> = rows.iter().map(|r| r.residual.abs()).collect();
    (FROM_MEDIAN * quantile(&mut sizes, 0.5)).max(floor)
}

/// The path stays near where it was, and faces are flat, as far as their standard deviations say.
fn prior(held: &[[f64; 3]], sweep: &Sweep, profile: &Profile, lengths: Lengths, spread: f64) -> Normal {
    let mut normal = Normal { matrix: [[0.0; UNKNOWNS]; UNKNOWNS], right: [0.0; UNKNOWNS] };
    for seen in held.iter().map(|&p| sweep.see(p)) {
        for c in 0..2 {
            let mut slopes = [0.0; UNKNOWNS];
            slopes[..POSE].copy_from_slice(&seen.slopes[c]);
            slopes[SHIFT + c] = -1.0;
            normal.add(&Row { slopes, residual: seen.at[c] }, (spread / lengths.prior).powi(2));
        }
    }
    for (k, face) in profile.faces.iter().enumerate() {
        let mut slopes = [0.0; UNKNOWNS];
        slopes[BENDS + k] = 1.0;
        normal.add(&Row { slopes, residual: face.bend }, (spread / lengths.bend).powi(2));
    }
    // The pose of a line has two parameters less.
    for k in 0..POSE {
        if normal.matrix[k][k] == 0.0 {
            normal.matrix[k][k] = 1.0;
        }
    }
    normal
}
