//! Point penalties (Gumhold 2001, sections 2.2 and 3.1): how improbable it is that a point lies on a crease, a corner or a
//! border.
//!
//! Two forms: `as_printed` is the paper's; `robust`, the default, departs from it where it is fragile.

mod as_printed;
mod robust;

pub(crate) use as_printed::note;

use crate::detect::evidence::hops::hops;
use crate::math::tensor::{Ellipsoid, ellipsoid};
use crate::measure::{Measure, Penalties};
use crate::neighbors::{Neighbors, mean_distance, riemannian::Scratch};
use crate::parallel;
use crate::params::{PenaltyForm, PenaltyParams};
use crate::resolution::Resolution;
use crate::surface::Scales;

/// Parameters derived from the data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derived {
    /// Graph distance of the neighbourhoods.
    pub hops: usize,
    /// Share of the curvature penalty.
    pub alpha: f64,
}

/// Derives neighbourhood and share from the noise, unless given (section 3.1: direct neighbours without noise, graph distance
/// up to five with much noise; section 3.2: alpha from 0.5 down to 0.2).
pub fn derive(params: &PenaltyParams, resolution: Resolution) -> Derived {
    let ratio = resolution.noise / resolution.spacing;
    let alpha = params.alpha.or(|| (0.5 - 0.6 * (ratio - 0.05)).clamp(0.2, 0.5));
    Derived { hops: hops(params.hops, resolution), alpha }
}

/// The penalties of all points. `points` in canonical order, local frame; `graph` is the Riemannian graph.
pub fn penalty(points: &[[f64; 3]], graph: &Neighbors, scales: Scales, params: &PenaltyParams) -> Measure {
    let derived = derive(params, scales.mean);
    match params.form {
        PenaltyForm::Robust => robust::penalties(points, graph, scales, params, derived),
        PenaltyForm::Paper => as_printed::penalties(points, graph, params, derived),
    }
}

/// Steps along the neighbour graph over which the robust form reads: the values of a point depend on the rows, positions and scales
/// of points less than so many edges away, and on the positions of those that many away. The form as printed has no such bound, as it
/// reads the greatest curvature of all points.
pub(crate) fn robust_steps(params: &PenaltyParams, scales: Scales, count: usize) -> usize {
    let widest = (0..count).map(|i| hops(params.hops, scales.at(i))).max();
    robust::steps(widest.unwrap_or(1))
}

/// `(N)` the correlation ellipsoid of every point over its neighbourhood (section 3.1, figure 6), that of the place in the robust form.
pub(crate) fn ellipsoids(
    points: &[[f64; 3]],
    graph: &Neighbors,
    scales: Scales,
    params: &PenaltyParams,
) -> Vec<Ellipsoid> {
    let everywhere = derive(params, scales.mean).hops;
    let hops = |i: usize| match params.form {
        PenaltyForm::Robust => hops(params.hops, scales.at(i)),
        PenaltyForm::Paper => everywhere,
    };
    parallel::map_with(points.len(), parallel::QUICK, |scratch: &mut Scratch, i| {
        ellipsoid(points, i, graph.hops(i, hops(i), scratch))
    })
}

/// The border penalties alone.
pub fn borders(
    points: &[[f64; 3]],
    graph: &Neighbors,
    resolution: Resolution,
    params: &PenaltyParams,
) -> Penalties {
    let derived = derive(params, resolution);
    match params.form {
        PenaltyForm::Robust => robust::borders(points, graph, resolution.into(), params),
        PenaltyForm::Paper => as_printed::borders(points, graph, params, derived),
    }
}

/// `(N)` mean distance of every point from its direct neighbours (equation 1).
pub fn densities(points: &[[f64; 3]], graph: &Neighbors) -> Vec<f32> {
    parallel::map(points.len(), parallel::QUICK, |i| mean_distance(points, i, graph.of(i)) as f32)
}
