//! Where a wall ends at nothing: the end of an even spread of points that noise has blurred, of greatest likelihood.

use std::f64::consts::TAU;

use super::end::{By, End};
use super::ground::Spot;
use super::search::Search;

/// Greatest distance of an end before the last point, spacings; plus four standard deviations of the noise.
const END_REACH: f64 = 1.0;
/// Chance given to points that belong to nothing.
const STRAY_CHANCE: f64 = 1e-3;
/// Width, in spacings, of the strips whose points may be added at the end: points that keep their distance, or lie on a
/// lattice, line up along a border, at most in one row more.
const LINED_ROWS: [f64; 6] = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5];

/// The end of the wall; `None` where it goes on to the end of the search, as when only a part of it ends.
pub(super) fn border(search: &Search, spots: &[Spot], h: f64, noise: f64) -> Option<End> {
    let wall = |s: &&Spot| {
        let beside = s.off <= (0.5 + 2.0 * noise) * h || !search.upright;
        beside && !s.flat()
    };
    let ahead: Vec<f64> = spots.iter().filter(wall).map(|s| search.ahead(s.height)).collect();
    let (first, last) = (search.ahead(search.start()), *ahead.last()?);
    if search.ahead(search.outer) - last <= h {
        return None;
    }
    // Only the last few rows tell the end; before them the wall may be denser or sparser.
    let from = first.max(last - (6.0 + 4.0 * noise) * h);
    let near: Vec<f64> = ahead.into_iter().filter(|&a| a >= from).collect();
    let sigma = noise * h;
    let end = if sigma <= 0.02 * h {
        // Half of the gaps lie beyond the last point.
        last + (last - from) / near.len().max(1) as f64
    } else {
        likeliest(&near, from, last, sigma, h)
    };
    let height = search.inner + end * (search.outer - search.inner).signum();
    Some(End { height, error: (0.1 + 0.3 * noise) * h, by: By::Border })
}

/// The end `e` for which points even from `from` to `e`, each blurred by `sigma`, are likeliest, with more of them at the end
/// itself where that is much likelier still.
fn likeliest(points: &[f64], from: f64, last: f64, sigma: f64, h: f64) -> f64 {
    // One number more explains any points a little better: it has to be worth it (Schwarz's criterion).
    let worth = 0.5 * (points.len() as f64).ln();
    let ends = LINED_ROWS.map(|rows| {
        let (end, log) = even_end(points, from, last, sigma, rows * h, h);
        (end, if rows > 0.0 { log - worth } else { log })
    });
    ends.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(last, |e| e.0)
}

/// The likeliest end where the points of a strip `more` wide are added there, and the logarithm of its likelihood.
fn even_end(points: &[f64], from: f64, last: f64, sigma: f64, more: f64, h: f64) -> (f64, f64) {
    let log = |e: f64| {
        let density = |p: f64| {
            let x = (e - p) / sigma;
            below(x) + more / sigma * (-0.5 * x * x).exp() / TAU.sqrt() + STRAY_CHANCE
        };
        let sum: f64 = points.iter().map(|&p| density(p).ln()).sum();
        sum - points.len() as f64 * (e - from + more).ln()
    };
    let (mut low, mut high) = ((last - END_REACH * h - 4.0 * sigma).max(from + 0.5 * h), last + sigma);
    if low >= high {
        return (last, log(last));
    }
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    for _ in 0..30 {
        let (a, b) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
        if log(a) >= log(b) { high = b } else { low = a }
    }
    let end = 0.5 * (low + high);
    (end, log(end))
}

/// The normal distribution below `x`, to about 1e-3 (a logistic curve of the cube).
fn below(x: f64) -> f64 {
    1.0 / (1.0 + (-1.5976 * x - 0.070_56 * x * x * x).exp())
}

#[cfg(test)]
mod tests {
    use super::{below, likeliest};
    use crate::shapes::Rng;

    #[test]
    fn the_end_of_a_blurred_spread_is_found() {
        for seed in 0..10 {
            let mut rng = Rng::new(seed);
            let points: Vec<f64> = (0..400)
                .map(|k| 5.0 * (f64::from(k) + rng.uniform()) / 400.0 + 0.25 * rng.gaussian())
                .collect();
            let near: Vec<f64> = points.into_iter().filter(|&p| p >= 1.0).collect();
            let last = near.iter().copied().fold(0.0, f64::max);
            let end = likeliest(&near, 1.0, last, 0.25, 1.0);
            assert!((end - 5.0).abs() < 0.1, "seed {seed}: {end}");
        }
    }

    #[test]
    fn the_normal_distribution_is_near_enough() {
        for (x, truth) in [(-2.0, 0.02275), (-1.0, 0.15866), (0.0, 0.5), (1.0, 0.84134), (2.0, 0.97725)] {
            assert!((below(x) - truth).abs() < 1e-3);
        }
    }
}
