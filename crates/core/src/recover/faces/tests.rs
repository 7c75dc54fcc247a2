//! Edges of sampled faces, with and without noise.

use super::*;
use crate::curve::Round;
use crate::curve::pieces::Sigma;
use crate::math::uniform::uniform;
use crate::math::vec3::{distance, unit};
use crate::resolution::Resolution;

/// A plate's top at z = 0 round a bore of `radius` along z, a point a square unit at random, and the true rim.
fn bored(radius: f64, noise: f64, seed: u64) -> Vec<[f64; 3]> {
    let mut uniform = uniform(seed);
    let (reach, mut points) = (6.0, Vec::new());
    let outer = radius + reach;
    let top = std::f64::consts::PI * (outer * outer - radius * radius);
    for _ in 0..top as usize {
        let (r, turn) = ((radius * radius + uniform() * (outer * outer - radius * radius)).sqrt(), uniform());
        let (sin, cos) = (std::f64::consts::TAU * turn).sin_cos();
        points.push([r * cos, r * sin, 0.0]);
    }
    for _ in 0..(std::f64::consts::TAU * radius * reach) as usize {
        let (z, (sin, cos)) = (-reach * uniform(), (std::f64::consts::TAU * uniform()).sin_cos());
        points.push([radius * cos, radius * sin, z]);
    }
    let mut normal = || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
    points.iter().map(|p| p.map(|x| x + noise * normal())).collect()
}

fn piece(shape: Shape, from: [f64; 3], to: [f64; 3]) -> Piece {
    Piece { shape, from, to, first: 0, last: 1, deviation: 0.0, sigma: None }
}

/// A circle that is too large, aside and tilted.
fn first_guess(radius: f64) -> Piece {
    let round = Round { centre: [0.1, -0.05, 0.1], normal: unit([0.01, 0.02, 1.0]), radius: radius + 0.15 };
    let at = round.foot([radius, 0.0, 0.0]);
    piece(Shape::Circle(round), at, at)
}

fn lengths(noise: f64) -> Lengths {
    Lengths::of(Resolution { spacing: 1.0, noise })
}

fn refitted(piece: &Piece, points: &[[f64; 3]], noise: f64) -> Fitted {
    of_piece(piece, points, lengths(noise)).expect("two faces")
}

#[test]
fn a_bore_has_its_radius_however_small_and_large_it_was_taken() {
    for (radius, noise, off) in [(3.0, 0.0, 1e-3), (8.0, 0.0, 1e-3), (8.0, 0.1, 0.1), (8.0, 0.25, 0.25)] {
        for seed in 0..10 {
            let fitted = refitted(&first_guess(radius), &bored(radius, noise, seed), noise);
            let Sweep::Round { round, .. } = fitted.sweep else { panic!("{fitted:?}") };
            assert!((round.radius - radius).abs() < off, "{} for {radius}, noise {noise}", round.radius);
            assert!(distance(round.centre, [0.0; 3]) < 2.0 * off, "{:?}, noise {noise}", round.centre);
        }
    }
}

/// Intervals of 95 % hold the true radius and centre as often as they say, or a little more often.
#[test]
fn deviations_cover_the_truth() {
    let (trials, noise, radius) = (400, 0.1, 6.0);
    let mut inside = [0; 3];
    for seed in 0..trials {
        let fitted = refitted(&first_guess(radius), &bored(radius, noise, seed), noise);
        let Sweep::Round { round, .. } = fitted.sweep else { panic!("{fitted:?}") };
        let Some(Sigma::Round { radius: sigma, covariance, .. }) = fitted.sigma() else {
            panic!("{fitted:?}")
        };
        inside[0] += i32::from((round.radius - radius).abs() <= 1.96 * sigma);
        inside[1] += i32::from(round.centre[0].abs() <= 1.96 * covariance[0][0].sqrt());
        inside[2] += i32::from(round.centre[2].abs() <= 1.96 * covariance[2][2].sqrt());
    }
    for count in inside {
        let share = f64::from(count) / trials as f64;
        assert!((0.92..=0.99).contains(&share), "{inside:?} of {trials}");
    }
}

#[test]
fn a_smooth_sheet_has_no_edge_to_fit() {
    let points: Vec<[f64; 3]> = bored(6.0, 0.1, 1).into_iter().map(|[x, y, _]| [x, y, 0.0]).collect();
    assert!(of_piece(&first_guess(6.0), &points, lengths(0.1)).is_none());
    assert!(of_piece(&first_guess(6.0), &[], lengths(0.1)).is_none());
}
