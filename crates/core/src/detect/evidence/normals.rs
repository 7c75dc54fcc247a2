//! Unit normals that stay on their side of a crease.
//!
//! The correlation ellipsoid's normal (Gumhold 2001, section 3.1) blends the faces at a crease. A few bilateral passes
//! separate them: each normal becomes the mean of the neighbouring normals that agree with it in angle and whose points lie
//! in its plane. This departs from the paper, whose penalties do not need normals.

use super::consensus::{NEGLIGIBLE, bell, consensus_normals, tolerance};
use crate::math::vec3::{add_scaled, dot, sub, unit};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::parallel;
use crate::surface::Scales;

/// Passes of bilateral averaging: the first moves most normals to one side, the second those left in between.
const PASSES: usize = 2;
/// Angle at which a normal has `exp(-1)` times the weight of a parallel one.
const GATE_DEG: f64 = 20.0;

/// `(N)` normals with their support, local frame.
#[derive(Clone, Debug, Default)]
pub struct Normals {
    /// `(N, 3)` unit vectors without orientation.
    pub vectors: Vec<[f32; 3]>,
    /// `(N)` share of the neighbourhood that agreed with the normal in the last pass, 0 to 1.
    pub support: Vec<f32>,
}

/// Estimates the normals from neighbourhoods of graph distance `hops`, which may differ from point to point.
pub fn normals<'a>(
    points: &[[f64; 3]],
    graph: &Neighbors,
    hops: impl Fn(usize) -> usize + Sync,
    scales: impl Into<Scales<'a>>,
) -> Normals {
    let scales = scales.into();
    let vectors = consensus_normals(points, graph, &hops, scales);
    let mut normals = Normals { vectors, support: vec![1.0; points.len()] };
    for _ in 0..PASSES {
        normals = pass(points, graph, &hops, scales, &normals);
    }
    normals
}

/// The nearer part of a neighbourhood of graph distance `hops`: one edge less, but at least the direct neighbours.
pub(crate) fn inner<'a>(graph: &'a Neighbors, i: usize, hops: usize, scratch: &'a mut Scratch) -> &'a [u32] {
    if hops <= 2 { graph.of(i) } else { graph.hops(i, hops - 1, scratch) }
}

fn pass(
    points: &[[f64; 3]],
    graph: &Neighbors,
    hops: impl Fn(usize) -> usize + Sync,
    scales: Scales,
    from: &Normals,
) -> Normals {
    let angle_rate = 1.0 / (1.0 - GATE_DEG.to_radians().cos());
    let rows = parallel::map_with(points.len(), parallel::QUICK, |scratch: &mut Scratch, i| {
        let own = from.vectors[i].map(f64::from);
        let (mut sum, mut total) = (own, 1.0);
        let offset_rate = 0.5 / tolerance(scales.at(i)).powi(2);
        let neighbors = graph.hops(i, hops(i), scratch);
        for &j in neighbors {
            let other = from.vectors[j as usize].map(f64::from);
            let cosine = dot(own, other);
            let offset = dot(own, sub(points[j as usize], points[i]));
            let exponent = (1.0 - cosine.abs()) * angle_rate + offset * offset * offset_rate;
            if exponent < NEGLIGIBLE {
                let weight = bell(exponent);
                sum = add_scaled(sum, other, weight * cosine.signum());
                total += weight;
            }
        }
        (unit(sum).map(|x| x as f32), (total / (neighbors.len() + 1) as f64) as f32)
    });
    let (vectors, support) = rows.into_iter().unzip();
    Normals { vectors, support }
}
