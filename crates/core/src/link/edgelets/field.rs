//! The direction in which the surface does not change, and normals fitted to tubes along it.

use super::knobs;
use crate::math::eigen3::{Eigen3, eigen3};
use crate::math::tensor::add_product;
use crate::math::vec3::{add_scaled, dot, scale, sub, unit};
use crate::neighbors::Index;
use crate::surface::Scales;
use rayon::prelude::*;

/// Of every point: its normal, the direction without change, whether it lies at a fold, and its place on the surface.
pub(super) struct Field {
    pub(super) normal: Vec<[f64; 3]>,
    pub(super) along: Vec<[f64; 3]>,
    /// 0 where the normals have no direction without change, or are all equal; up to 1.
    pub(super) grade: Vec<f32>,
    pub(super) place: Vec<[f64; 3]>,
}

const REACH: f64 = 4.7;
const ROUNDS: usize = 3;
const ACROSS: f64 = 1.3;

struct Tensor {
    along: [f64; 3],
    bend: f64,
    grade: f64,
}

pub(super) fn field(points: &[[f64; 3]], normals: &[[f32; 3]], index: &Index, scales: Scales) -> Field {
    let mut normal: Vec<[f64; 3]> = normals.iter().map(|n| unit(n.map(f64::from))).collect();
    let mut place = points.to_vec();
    let mut last = Vec::new();
    let least = knobs().bend;
    for round in 0..=ROUNDS {
        let tensors: Vec<Tensor> = (0..points.len())
            .into_par_iter()
            .with_min_len(64)
            .map(|i| tensor(points, &normal, index, scales.at(i).spacing, i))
            .collect();
        if round == ROUNDS {
            last = tensors;
            break;
        }
        let next: Vec<([f64; 3], [f64; 3])> = (0..points.len())
            .into_par_iter()
            .with_min_len(16)
            .map_init(Vec::new, |near, i| match tensors[i].bend > least {
                true => tube(points, &normal, &place, index, scales, i, &tensors[i], round, near),
                false => (normal[i], place[i]),
            })
            .collect();
        (normal, place) = next.into_iter().unzip();
    }
    let grade = last.iter().map(|t| if t.bend > least { t.grade as f32 } else { 0.0 }).collect();
    Field { normal, along: last.iter().map(|t| t.along).collect(), grade, place }
}

fn tensor(points: &[[f64; 3]], normal: &[[f64; 3]], index: &Index, h: f64, i: usize) -> Tensor {
    let (mut m, mut sum) = ([0.0; 6], 0.0);
    index.around(points[i], REACH * h, |f| {
        let w = (-f.distance2 / (3.5 * h * 3.5 * h)).exp();
        add_product(&mut m, normal[f.index as usize], w);
        sum += w;
    });
    let Eigen3 { values, vectors } = eigen3(&m);
    Tensor { along: vectors[0], bend: values[1] / sum, grade: (values[1] - values[0]) / values[1].max(1e-12) }
}

/// The plane through the points of a tube along the direction without change.
#[allow(clippy::too_many_arguments)]
fn tube(
    points: &[[f64; 3]],
    normal: &[[f64; 3]],
    place: &[[f64; 3]],
    index: &Index,
    scales: Scales,
    i: usize,
    tensor: &Tensor,
    round: usize,
    near: &mut Vec<(usize, [f64; 3], f64)>,
) -> ([f64; 3], [f64; 3]) {
    let r = scales.at(i);
    let h = r.spacing;
    let long = (3.0 + 14.0 * r.noise / h).clamp(3.0, 7.0) * h;
    let own = points[i];
    near.clear();
    index.around(own, 1.5 * long, |f| {
        let d = sub(points[f.index as usize], own);
        let al = dot(d, tensor.along);
        let ac2 = (f.distance2 - al * al).max(0.0);
        let e = 2.0 * (al / long).powi(2) + 2.0 * ac2 / (ACROSS * h).powi(2);
        if e < 6.9 {
            near.push((f.index as usize, d, (-e).exp()));
        }
    });
    let s0 = r.noise.max(0.05 * h);
    let spread: f64 = if round == 0 { 0.45 } else { 0.3 };
    let (mut n, mut q) = (normal[i], sub(place[i], own));
    for step in 0..3 {
        let s = s0 * if step < 2 { 2.0 } else { 1.5 };
        let (mut sum, mut c, mut m) = (0.0, [0.0; 3], [0.0; 6]);
        for &(j, d, w) in near.iter() {
            let off = dot(sub(d, q), n);
            let cosine = dot(normal[j], n);
            let w = w * (-0.5 * (off / s).powi(2) - (1.0 - cosine * cosine) / (2.0 * spread * spread)).exp();
            sum += w;
            c = add_scaled(c, d, w);
            add_product(&mut m, d, w);
        }
        if sum < 1e-6 {
            break;
        }
        c = scale(c, 1.0 / sum);
        add_product(&mut m, c, -sum);
        n = eigen3(&m).vectors[0];
        q = scale(n, dot(c, n));
    }
    (n, add_scaled(own, q, 1.0))
}
