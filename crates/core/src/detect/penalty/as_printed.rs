//! The penalty functions as printed (Gumhold 2001, section 3.1, equations 1 to 9).
//!
//! Each penalty function omega (ω) estimates how improbable it is that a point is close to a feature. Two weaknesses are in the
//! equations themselves: the curvature penalty `omega_kappa` is relative to the greatest curvature of all points, so that one
//! outlier makes every crease improbable; and the vector penalties `omega_cr` and `omega_b1` are least for edges *across* the
//! long axis of the correlation ellipsoid.

use super::{Derived, densities};
use crate::detect::evidence::open_angle::open_angle;
use crate::math::tensor::{Ellipsoid, ellipsoid};
use crate::math::vec3::{dot, scale};
use crate::measure::{Direction, Measure, Penalties, Row};
use crate::neighbors::{Neighbors, mean_distance, riemannian::Scratch};
use crate::parallel;
use crate::params::PenaltyParams;
use crate::resolution::Resolution;
use std::f64::consts::TAU;

/// Border penalty of an edge across the long axis of the ellipsoid within a surface: two open angles of some 70 degrees, equation 8, and
/// no directional part. `tau` must lie below it, or every face has false borders.
const WITHIN: f64 = 0.8;
/// The same for creases under noise, where no curvature stands out against the greatest.
const NOISY: f64 = 0.6;
/// Noise from which on this holds, spacings.
const NOISE: f64 = 0.05;

/// What the tolerance `tau` does in this form, and what to set; `None` where it is low enough.
pub(crate) fn note(tau: f64, borders: bool, resolution: Resolution) -> Option<String> {
    let ratio = resolution.noise / resolution.spacing;
    if ratio >= NOISE && tau > NOISY {
        return Some(format!(
            "penalty.form=paper: with noise of {ratio:.2} spacings nearly every edge of the graph passes spanning.tau={tau}, and many short \
             lines on smooth faces stay; set spanning.tau={NOISY} for fewer, or penalty.form=robust"
        ));
    }
    (borders && tau > WITHIN).then(|| {
        format!(
            "penalty.form=paper: edges within a face have a border penalty of about {WITHIN} and pass spanning.tau={tau}, which makes \
             false borders; set spanning.tau={WITHIN} or spanning.borders=false"
        )
    })
}

/// The values at a point that do not depend on the greatest curvature.
struct Point {
    /// `kappa`.
    curvature: f64,
    /// `omega_cr`.
    crease: [f64; 3],
    /// The corner penalty `omega_co`.
    corner: f64,
    normal: [f64; 3],
    border: Row,
}

/// Equations 1 to 9 for every point.
pub fn penalties(
    points: &[[f64; 3]],
    graph: &Neighbors,
    params: &PenaltyParams,
    derived: Derived,
) -> Measure {
    let rows = at_every_point(points, graph, derived.hops, point);
    let greatest = rows.iter().map(|r| r.curvature).fold(0.0, f64::max);
    let mut measure = Measure {
        density: densities(points, graph),
        crease: Penalties::new(derived.alpha, Direction::Along),
        border: Penalties::new(params.gamma, Direction::Along),
        ..Default::default()
    };
    for (i, row) in rows.iter().enumerate() {
        let curvature = if greatest > 0.0 { 1.0 - row.curvature / greatest } else { 1.0 }; // equation 5: omega_kappa
        measure.score.push((1.0 - curvature) as f32);
        measure.normal.push(single(row.normal));
        let crease = Row {
            scalar: curvature as f32,
            vector: single(row.crease),
            corner: row.corner as f32,
            foot: points[i],
            evidence: None,
        };
        measure.crease.push(i as u32, crease);
        measure.border.push(i as u32, row.border);
    }
    measure
}

/// Equations 2, 3, 7 and 8 for every point.
pub fn borders(
    points: &[[f64; 3]],
    graph: &Neighbors,
    params: &PenaltyParams,
    derived: Derived,
) -> Penalties {
    let rows = at_every_point(points, graph, derived.hops, |points, _, i, near, angles| {
        border(points, i, near, &ellipsoid(points, i, near), angles)
    });
    let mut penalties = Penalties::new(params.gamma, Direction::Along);
    rows.into_iter().enumerate().for_each(|(i, row)| penalties.push(i as u32, row));
    penalties
}

/// Calls `of` with every point, its neighbours up to `hops` away and scratch.
fn at_every_point<R: Send>(
    points: &[[f64; 3]],
    graph: &Neighbors,
    hops: usize,
    of: impl Fn(&[[f64; 3]], &Neighbors, usize, &[u32], &mut Vec<f64>) -> R + Sync,
) -> Vec<R> {
    parallel::map_with(points.len(), parallel::QUICK, |(scratch, angles): &mut (Scratch, Vec<f64>), i| {
        of(points, graph, i, graph.hops(i, hops, scratch), angles)
    })
}

fn point(points: &[[f64; 3]], graph: &Neighbors, i: usize, near: &[u32], angles: &mut Vec<f64>) -> Point {
    let around = ellipsoid(points, i, near); // equations 2 and 3
    let Ellipsoid { centre, axes, .. } = around;
    let mu = mean_distance(points, i, graph.of(i)); // equation 1
    let [l0, l1, l2] = axes.values.map(|x| x.max(0.0));
    let [normal, _, long] = axes.vectors;
    let inverse = if l2 > 0.0 { 1.0 / l2 } else { 0.0 };
    let distance = dot(normal, centre).abs();
    Point {
        curvature: if mu > 0.0 { 2.0 * distance / (mu * mu) } else { 0.0 }, // equation 4: kappa
        crease: scale(long, (l1 - l0).max((l2 - (l0 + l1)).abs()) * inverse), // equation 6: omega_cr
        corner: (l2 - l0) * inverse,                                        // equation 9: omega_co
        normal,
        border: border(points, i, near, &around, angles),
    }
}

fn border(points: &[[f64; 3]], i: usize, near: &[u32], around: &Ellipsoid, angles: &mut Vec<f64>) -> Row {
    let [_, l1, l2] = around.axes.values.map(|x| x.max(0.0));
    let [normal, _, long] = around.axes.vectors;
    let inverse = if l2 > 0.0 { 1.0 / l2 } else { 0.0 };
    let beta = open_angle(points, i, near, normal, angles).angle;
    Row {
        scalar: (1.0 - beta / TAU) as f32, // equation 8: omega_b2
        vector: single(scale(long, (l2 - 2.0 * l1).abs() * inverse)), // equation 7: omega_b1
        corner: f32::INFINITY,
        foot: points[i],
        evidence: None,
    }
}

fn single(v: [f64; 3]) -> [f32; 3] {
    v.map(|x| x as f32)
}
