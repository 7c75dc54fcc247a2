//! The penalties as printed (Gumhold 2001, section 3.1, equations 1 to 9).
//!
//! Fragile by design: the curvature penalty is relative to the greatest curvature of all points, so that one outlier makes
//! every crease improbable; and the vector penalty is least for edges *across* the ellipsoid's long axis.

use super::{Derived, density};
use crate::detect::open_angle::open_angle;
use crate::math::tensor::{Ellipsoid, ellipsoid};
use crate::math::vec3::{dot, scale};
use crate::measure::{Direction, Measure, Penalties, Row};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::params::PenaltyParams;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// What is computed for a point before the greatest curvature is known.
struct Point {
    density: f64,
    curvature: f64,
    crease: [f64; 3],
    corner: f64,
    border: [f64; 3],
    opening: f64,
    normal: [f64; 3],
}

/// Equations 1 to 9 for every point.
pub fn penalties(
    points: &[[f64; 3]],
    graph: &Neighbors,
    params: &PenaltyParams,
    derived: Derived,
) -> Measure {
    let rows: Vec<Point> = (0..points.len())
        .into_par_iter()
        .with_min_len(1024)
        .map_init(Default::default, |(scratch, angles), i| {
            point(points, graph, derived.hops, i, scratch, angles)
        })
        .collect();
    let greatest = rows.iter().map(|r| r.curvature).fold(0.0, f64::max);
    let mut measure = Measure {
        crease: Penalties { share: derived.alpha, direction: Direction::Along, ..Default::default() },
        border: Penalties { share: params.gamma, direction: Direction::Along, ..Default::default() },
        ..Default::default()
    };
    for (i, row) in rows.iter().enumerate() {
        let curvature = if greatest > 0.0 { 1.0 - row.curvature / greatest } else { 1.0 };
        let single = |v: [f64; 3]| v.map(|x| x as f32);
        measure.density.push(row.density as f32);
        measure.score.push((1.0 - curvature) as f32);
        measure.normal.push(single(row.normal));
        let foot = points[i];
        let crease = Row {
            scalar: curvature as f32,
            vector: single(row.crease),
            corner: row.corner as f32,
            foot,
            evidence: 0.0,
            expected: 0.0,
            fold: 0.0,
        };
        measure.crease.push(i as u32, crease);
        let border = Row {
            scalar: row.opening as f32,
            vector: single(row.border),
            corner: f32::INFINITY,
            foot,
            evidence: 0.0,
            expected: 0.0,
            fold: 0.0,
        };
        measure.border.push(i as u32, border);
    }
    measure
}

fn point(
    points: &[[f64; 3]],
    graph: &Neighbors,
    hops: usize,
    i: usize,
    scratch: &mut Scratch,
    angles: &mut Vec<f64>,
) -> Point {
    let neighbors = graph.hops(i, hops, scratch);
    let Ellipsoid { centre, axes, .. } = ellipsoid(points, i, neighbors);
    let density = density(points, graph, i);
    let [l0, l1, l2] = axes.values.map(|x| x.max(0.0));
    let [normal, _, long] = axes.vectors;
    let inverse = if l2 > 0.0 { 1.0 / l2 } else { 0.0 };
    let distance = dot(normal, centre).abs();
    Point {
        density,
        curvature: if density > 0.0 { 2.0 * distance / (density * density) } else { 0.0 },
        crease: scale(long, (l1 - l0).max((l2 - (l0 + l1)).abs()) * inverse),
        corner: (l2 - l0) * inverse,
        border: scale(long, (l2 - 2.0 * l1).abs() * inverse),
        opening: 1.0 - open_angle(points, i, neighbors, normal, angles).angle / TAU,
        normal,
    }
}
