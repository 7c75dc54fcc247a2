//! Standard deviations of the parameters of lines and circles, by propagation of the points' errors.
//!
//! The covariance is `s^2 (J^T W J)^-1` of the linearised least squares, with `s` the error of a point and `W` the independent
//! observations that each stands for. Across the plane of a circle and within it the errors are independent.

use super::noise::Noise;
use super::piece::{Piece, Shape, Sigma};
use crate::curve::circle::solve3;
use crate::curve::ellipse::{Ellipse, Known};
use crate::curve::round::Round;
use crate::math::vec3::{add_scaled, cross, dot, perpendicular, scale, sub, unit};

/// The standard deviations of a piece from the points that it was fitted to.
pub(super) fn sigma(piece: &Piece, points: &[[f64; 3]], noise: &Noise) -> Option<Sigma> {
    // Two distances a point go into the deviation in space.
    let dimensions: f64 = if noise.flat { 1.0 } else { 2.0 };
    let error = noise.sigma.max(piece.deviation / dimensions.sqrt());
    let variance = error * error / noise.share;
    match &piece.shape {
        Shape::Line => line(piece, points, variance),
        Shape::Arc { round, .. } | Shape::Circle(round) => circle(round, points, variance),
        Shape::Ellipse { ellipse: found, .. } => ellipse(found, points, variance),
        Shape::Spline(_) => None,
    }
}

fn line(piece: &Piece, points: &[[f64; 3]], variance: f64) -> Option<Sigma> {
    let (along, middle) =
        (unit(sub(piece.to, piece.from)), scale(add_scaled(piece.from, piece.to, 1.0), 0.5));
    let spread: f64 = points.iter().map(|&p| dot(sub(p, middle), along).powi(2)).sum();
    (points.len() > 2 && spread > 0.0).then(|| Sigma::Line {
        offset: (variance / points.len() as f64).sqrt(),
        direction: (variance / spread).sqrt(),
    })
}

fn circle(round: &Round, points: &[[f64; 3]], variance: f64) -> Option<Sigma> {
    let Round { centre, normal, radius } = *round;
    let u = perpendicular(normal);
    let v = cross(normal, u);
    let (mut within, mut across) = ([[0.0; 3]; 3], [[0.0; 3]; 3]);
    for &p in points {
        let d = sub(p, centre);
        let (x, y) = (dot(d, u) / radius, dot(d, v) / radius);
        let length = x.hypot(y).max(f64::MIN_POSITIVE);
        add(&mut within, [x / length, y / length, 1.0]);
        add(&mut across, [1.0, x, y]);
    }
    let (within, across) = (inverse(within)?, inverse(across)?);
    // The covariance over u, v, normal and radius, turned into the frame of the points.
    let axes = [u, v, normal];
    let mut covariance = [[0.0; 4]; 4];
    let inner = |i: usize, j: usize| match (i, j) {
        (2, 2) => across[0][0],
        (2, _) | (_, 2) => 0.0,
        _ => within[i][j],
    };
    for i in 0..3 {
        for j in 0..3 {
            let sum = |a: usize| (0..3).map(|b| axes[a][i] * inner(a, b) * axes[b][j]).sum::<f64>();
            covariance[i][j] = variance * (0..3).map(sum).sum::<f64>();
        }
        let with_radius = variance * (axes[0][i] * within[0][2] + axes[1][i] * within[1][2]);
        (covariance[i][3], covariance[3][i]) = (with_radius, with_radius);
    }
    covariance[3][3] = variance * within[2][2];
    Some(Sigma::Round {
        radius: covariance[3][3].sqrt(),
        normal: (variance * (across[1][1] + across[2][2])).sqrt() / radius,
        covariance,
    })
}

fn ellipse(found: &Ellipse, points: &[[f64; 3]], variance: f64) -> Option<Sigma> {
    let Known { within, across } = found.known(points, &vec![1.0; points.len()])?;
    let [u, v] = found.axes();
    let mut covariance = [[0.0; 5]; 5];
    for i in 0..3 {
        for j in 0..3 {
            let flat = |a: usize, b: usize| [u, v][a][i] * within[a][b] * [u, v][b][j];
            let sum = flat(0, 0) + flat(0, 1) + flat(1, 0) + flat(1, 1);
            covariance[i][j] = variance * (sum + found.normal[i] * across[0] * found.normal[j]);
        }
        for k in 0..2 {
            let with = variance * (u[i] * within[0][2 + k] + v[i] * within[1][2 + k]);
            (covariance[i][3 + k], covariance[3 + k][i]) = (with, with);
            (0..2).for_each(|l| covariance[3 + k][3 + l] = variance * within[2 + k][2 + l]);
        }
    }
    let turn = (variance * within[4][4]).sqrt();
    Some(Sigma::Ellipse { turn, normal: (variance * across[1]).sqrt(), covariance })
}

fn add(m: &mut [[f64; 3]; 3], row: [f64; 3]) {
    (0..3).for_each(|i| (0..3).for_each(|j| m[i][j] += row[i] * row[j]));
}

/// The inverse of a symmetric matrix; `None` where it is singular to rounding.
fn inverse(m: [[f64; 3]; 3]) -> Option<[[f64; 3]; 3]> {
    let column = |k: usize| solve3(m, std::array::from_fn(|i| f64::from(u8::from(i == k))));
    Some([column(0)?, column(1)?, column(2)?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::pieces::pieces;
    use crate::math::uniform::uniform;
    use crate::math::vec3::distance;

    /// Intervals of two standard deviations hold the true radius as often as they say.
    #[test]
    fn the_radius_lies_within_its_interval() {
        let mut uniform = uniform(3);
        let mut normal = || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
        let (trials, mut inside) = (400, 0);
        for _ in 0..trials {
            let at = |k: i32| {
                let (s, c) = (f64::from(k) * std::f64::consts::TAU / 80.0).sin_cos();
                [9.0 * c + 0.1 * normal(), 9.0 * s + 0.1 * normal(), 0.1 * normal()]
            };
            let points: Vec<[f64; 3]> = (0..80).map(at).collect();
            let noise = Noise::new(0.1, 0.1, 80, 56.0);
            let found = pieces(&points, true, &noise, 2.5);
            let (Shape::Circle(round), Some(Sigma::Round { radius, .. })) = (&found[0].shape, found[0].sigma)
            else {
                panic!("{found:?}")
            };
            inside += i32::from((round.radius - 9.0).abs() <= 1.96 * radius);
            assert!(distance(round.centre, [0.0; 3]) < 0.2);
        }
        let share = f64::from(inside) / f64::from(trials);
        assert!((0.92..=0.98).contains(&share), "{share}");
    }
}
