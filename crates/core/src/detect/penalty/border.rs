//! The robust border penalties, and where on the border a point belongs.
//!
//! The open angle (Gumhold 2001, equation 8) counts only if it is wider than chance would leave it in as many directions.
//! The direction of the border is at right angles to the middle of the opening, which holds at short borders where the
//! ellipsoid (equation 7) shows none. Points that see the opening lie in a ragged row behind the border: each is moved
//! across to the mean of those beside it, so that the row becomes a line before it is linked.

use crate::detect::open_angle::{chance_opening, open_angle};
use crate::detect::tensor::ellipsoid;
use crate::math::vec3::{add_scaled, cross, dot, norm, sub};
use crate::measure::{Penalties, Row};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::resolution::Resolution;
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};

/// Chance that a point within the surface shows its open angle by accident.
const CHANCE: f64 = 1e-3;
/// Least distance of the neighbourhood's centre in the tangent plane, in mean distances of its points: half a disc has its
/// centre at two thirds, a whole one at its own point. What lies below cannot be a border, and most points do.
const LEAST_LEAN: f64 = 0.2;
/// Openings wider than this leave less than half of a plane: the border turns.
const TURN: f64 = 1.2 * PI;
/// Half the length of border that a point is averaged over, spacings.
const ROW: f64 = 2.0;

/// The border penalties of point `i` with neighbourhood `wide`; `None` if it cannot lie on a border.
pub fn border(points: &[[f64; 3]], i: usize, wide: &[u32], angles: &mut Vec<f64>) -> Option<Row> {
    let (sum, distances) = wide.iter().fold(([0.0; 3], 0.0), |(sum, total), &j| {
        let d = sub(points[j as usize], points[i]);
        (add_scaled(sum, d, 1.0), total + norm(d))
    });
    if norm(sum) < LEAST_LEAN * distances {
        return None;
    }
    let normal = ellipsoid(points, i, wide).axes.vectors[0];
    let opening = open_angle(points, i, wide, normal, angles);
    if opening.angle < chance_opening(angles.len(), CHANCE).max(0.4 * PI) {
        return None;
    }
    Some(Row {
        scalar: (1.0 - opening.angle / TAU) as f32,
        vector: cross(normal, opening.middle).map(|x| x as f32),
        corner: if opening.angle > TURN { 0.5 } else { 1.0 },
        foot: points[i],
        evidence: 0.0,
        expected: 0.0,
        fold: 0.0,
    })
}

/// Moves every candidate across the border, to the mean of the candidates beside it.
pub fn align(points: &[[f64; 3]], graph: &Neighbors, border: &mut Penalties, scale: Resolution) {
    let feet: Vec<[f64; 3]> = (0..border.len())
        .into_par_iter()
        .with_min_len(64)
        .map_init(Scratch::default, |scratch, c| aligned(points, graph, border, scale, c, scratch))
        .collect();
    border.foot = feet;
}

fn aligned(
    points: &[[f64; 3]],
    graph: &Neighbors,
    border: &Penalties,
    scale: Resolution,
    c: usize,
    scratch: &mut Scratch,
) -> [f64; 3] {
    let own = border.points[c] as usize;
    let along = border.vector[c].map(f64::from);
    let (mut sum, mut count) = ([0.0; 3], 1.0);
    for j in graph.hops(own, 2, scratch) {
        if border.points.binary_search(j).is_err() {
            continue;
        }
        let d = sub(points[*j as usize], points[own]);
        let t = dot(d, along);
        if t.abs() <= ROW * scale.spacing {
            sum = add_scaled(sum, add_scaled(d, along, -t), 1.0);
            count += 1.0;
        }
    }
    add_scaled(points[own], sum, 1.0 / count)
}
