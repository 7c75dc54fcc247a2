//! Fits a surface to each patch: plane, sphere, cylinder, cone or torus, with its residual.
//!
//! Each kind is started from points and normals (`start`) and refined to the least sum of squared distances (`refine`). The kind
//! is chosen by the Bayesian information criterion (G. Schwarz, "Estimating the dimension of a model", Annals of Statistics
//! 6, 1978), which weighs the residual against the number of parameters. Residuals below a share of the spacing count as equal.

mod refine;
mod start;
mod surface;

pub use surface::{Fit, Surface};

use super::beside::Beside;
use super::ground::Ground;
use crate::math::vec3::dot;
use crate::parallel;

/// Greatest number of points to which a surface is fitted.
const FITTED_POINTS: usize = 800;
/// Distance from a strip up to which points are left out if there are enough others, spacings.
const CLEAR_OF_STRIPS: f64 = 0.8;
/// Fewest points clear of strips that suffice for a fit.
const FEWEST_CLEAR: usize = 24;
/// Residual below which fits count as equally good, spacings: a scan resolves no less.
pub(super) const FLOOR: f64 = 0.03;
/// Distance from a surface above which a point counts no more, in standard deviations of the others; and these in medians of the
/// distance, where it is normally distributed.
const FAR: f64 = 3.0;
const OF_MEDIAN: f64 = 1.4826;
/// Residual of the best surface above which a patch is free-form, spacings; plus twice the noise.
const FREE: f64 = 0.15;

/// The best surface of each patch. `normals` point outwards; local frame.
pub fn fits(ground: &Ground, normals: &[[f64; 3]], members: &[Vec<u32>], beside: &Beside) -> Vec<Fit> {
    parallel::map(members.len(), parallel::TASK, |patch| fit(ground, normals, &members[patch], beside))
}

fn fit(ground: &Ground, normals: &[[f64; 3]], patch: &[u32], beside: &Beside) -> Fit {
    let clear = |&i: &u32| {
        let least = CLEAR_OF_STRIPS * ground.scales.at(i as usize).spacing;
        beside.of(i as usize).iter().all(|e| e.distance >= least)
    };
    let mut chosen: Vec<u32> = patch.iter().copied().filter(clear).collect();
    if chosen.len() < FEWEST_CLEAR {
        chosen = patch.to_vec();
    }
    let step = chosen.len().div_ceil(FITTED_POINTS).max(1);
    let chosen: Vec<u32> = chosen.into_iter().step_by(step).collect();
    let points: Vec<[f64; 3]> = chosen.iter().map(|&i| ground.points[i as usize]).collect();
    let normals: Vec<[f64; 3]> = chosen.iter().map(|&i| normals[i as usize]).collect();
    let spacing = ground.scales.mean_spacing(&chosen);
    let floor = FLOOR * spacing;
    let best = start::all(&points, &normals)
        .into_iter()
        .filter_map(|s| refine::refine(s, &points))
        .map(|s| (cost(&s, &points, floor), s))
        .min_by(|a, b| a.0.total_cmp(&b.0));
    match best {
        Some((_, surface)) => {
            let residual = residual(&surface, &points);
            let free = residual > FREE * spacing + 2.0 * ground.scales.mean.noise;
            let outwards = |(&p, &n): (&[f64; 3], &[f64; 3])| dot(surface.normal(p), n);
            let outward = points.iter().zip(&normals).map(outwards).sum::<f64>() >= 0.0;
            Fit { surface, residual, free, outward }
        }
        None => Fit { surface: start::plane(&points), residual: 0.0, free: false, outward: true },
    }
}

/// Root mean square distance.
fn residual(surface: &Surface, points: &[[f64; 3]]) -> f64 {
    let squares: f64 = points.iter().map(|&p| surface.distance(p).powi(2)).sum();
    (squares / points.len().max(1) as f64).sqrt()
}

/// What chooses the kind. Points far beyond the others are of another face or of none, and count as at [`FAR`]: a plane with a few
/// of them is no wide sphere.
fn cost(surface: &Surface, points: &[[f64; 3]], floor: f64) -> f64 {
    if points.is_empty() {
        return 0.0;
    }
    let count = points.len() as f64;
    let mut squares: Vec<f64> = points.iter().map(|&p| surface.distance(p).powi(2)).collect();
    let middle = *squares.select_nth_unstable_by(points.len() / 2, f64::total_cmp).1;
    let most = FAR * FAR * (middle * OF_MEDIAN * OF_MEDIAN + floor * floor);
    let mean = squares.iter().map(|s| s.min(most)).sum::<f64>() / count;
    count * (mean + floor * floor).ln() + surface.freedom() as f64 * count.ln()
}

#[cfg(test)]
mod tests;
