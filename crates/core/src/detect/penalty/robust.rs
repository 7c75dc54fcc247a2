//! The robust form of the penalties: Gumhold 2001, section 3.1, made safe against noise, outliers and blunt folds.
//!
//! Where it departs, and why:
//! * **Curvature.** The paper's `kappa / kappa_max` depends on the one sharpest point of the cloud. Here the fold is read
//!   from the correlation tensor of the neighbours' *normals*, `M = sum w n n^t`: two faces that fold by `phi` give it a
//!   middle eigenvalue of `sin^2(phi / 2)`, noise and thin sheets give it none. The penalty is one half where the fold is
//!   `fold_deg` and zero at twice that sine: no quantity of the whole cloud is in it.
//! * **Direction.** The least eigenvector of `M` is the crease's direction, also where the fold is too blunt to stretch the
//!   ellipsoid of the points. An edge is penalised by how far it leaves that direction.
//! * **Corner.** At a corner the least eigenvalue of `M` is large too, and no direction is preferred.
//! * **Foot.** The point nearest to all tangent planes of the neighbourhood (the quadric error of the paper's section 4.2,
//!   along the well-determined eigenvectors of `M` only) says where on the crease or corner the point belongs.
//! * **Narrow faces.** Where a neighbourhood holds more than two faces, two of them are looked at alone (`pair`).
//! * **Border.** The open angle counts only if it is wider than chance would leave it in as many directions, and not at an
//!   acute crease, where one face hides the other.

use super::align::align;
use super::border::{border, may_be_border};
use super::pair::{Pair, pair};
use super::sharpness::sharpness;
use super::{Derived, density};
use crate::detect::fold::{CrossSection, Fold};
use crate::detect::normals::{Normals, inner, normals};
use crate::math::eigen3::{Eigen3, eigen3};
use crate::math::tensor::add_product;
use crate::math::vec3::{add, add_scaled, dot, norm, scale, sub};
use crate::measure::{Direction, Measure, Penalties, Row};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::params::PenaltyParams;
use crate::resolution::Resolution;
use rayon::prelude::*;

/// Points that a thread takes at a time.
const BLOCK: usize = 1024;
/// Crease candidates have a smaller curvature penalty than this.
const MOST_PENALTY: f64 = 0.75;
/// Sine of half the fold from which on one face hides the other, and an opening is none: 108 degrees.
const ACUTE: f64 = 0.809;
/// Evidence at which a single point is known to lie on a round, whatever the rest of its chain says.
pub(crate) const CLEARLY_SMOOTH: f32 = -4.0;

/// What every point needs to know.
pub(crate) struct Context<'a> {
    pub(crate) points: &'a [[f64; 3]],
    pub(crate) graph: &'a Neighbors,
    pub(crate) normals: Normals,
    pub(crate) resolution: Resolution,
    pub(crate) hops: usize,
    /// Sine of half the fold at which a crease becomes one.
    pub(crate) least_fold: f64,
}

/// The surface around a point: the correlation tensor of its normals, what pulls the point on to their planes, and the two sides
/// that were looked at where there are more.
pub(crate) struct Sides {
    pub(crate) tensor: Eigen3,
    pub(crate) pull: [f64; 3],
    pub(crate) pair: Option<Pair>,
}

/// What a block of points yields: a row each, and the candidates among them.
#[derive(Default)]
struct Block {
    density: Vec<f32>,
    score: Vec<f32>,
    crease: Vec<(u32, Row)>,
    border: Vec<(u32, Row)>,
}

/// Buffers that serve one point after the other.
#[derive(Default)]
struct Buffers {
    scratch: Scratch,
    angles: Vec<f64>,
    section: CrossSection,
}

/// Robust penalties of every point.
pub fn penalties(
    points: &[[f64; 3]],
    graph: &Neighbors,
    resolution: Resolution,
    params: &PenaltyParams,
    derived: Derived,
) -> Measure {
    let context = Context {
        points,
        graph,
        normals: normals(points, graph, derived.hops, resolution),
        resolution,
        hops: derived.hops,
        least_fold: (0.5 * params.fold_deg.to_radians()).sin(),
    };
    let blocks: Vec<Block> = (0..points.len().div_ceil(BLOCK))
        .into_par_iter()
        .map_init(Buffers::default, |buffers, b| {
            let mut block = Block::default();
            for i in b * BLOCK..((b + 1) * BLOCK).min(points.len()) {
                context.point(i, buffers, &mut block);
            }
            block
        })
        .collect();
    let mut measure = Measure {
        crease: Penalties { share: derived.alpha, direction: Direction::Across, ..Default::default() },
        border: Penalties { share: params.gamma, direction: Direction::Across, ..Default::default() },
        ..Default::default()
    };
    for block in blocks {
        measure.density.extend(block.density);
        measure.score.extend(block.score);
        block.crease.into_iter().for_each(|(i, row)| measure.crease.push(i, row));
        block.border.into_iter().for_each(|(i, row)| measure.border.push(i, row));
    }
    // Feet scatter with the noise, and a band of them is as wide; the row of points behind a border is ragged without any.
    let (unit, blur) = (resolution.unit(), (4.0 * resolution.noise).min(2.0 * resolution.unit()));
    align(graph, &mut measure.crease, derived.hops.max(2), blur, blur);
    align(graph, &mut measure.border, 2, 2.0 * unit, 2.0 * unit);
    measure.normal = context.normals.vectors;
    measure
}

impl Context<'_> {
    fn point(&self, i: usize, buffers: &mut Buffers, block: &mut Block) {
        let Buffers { scratch, angles, section } = buffers;
        let near = inner(self.graph, i, self.hops, scratch);
        let sides = self.sides(i, near);
        let fold = sides.tensor.values[1].max(0.0).sqrt();
        let penalty = 1.0 - fold / (2.0 * self.least_fold);
        let folded = penalty < MOST_PENALTY;
        let open = fold < ACUTE && may_be_border(self.points, i, self.graph.of(i));
        block.density.push(density(self.points, self.graph, i) as f32);
        block.score.push((fold / (2.0 * self.least_fold)).min(1.0) as f32);
        if !folded && !open {
            return;
        }
        let wide = self.graph.hops(i, self.hops.max(2), scratch);
        if folded {
            let row = self.crease(i, &sides, penalty.max(0.0), wide, section);
            if row.evidence > CLEARLY_SMOOTH {
                block.crease.push((i as u32, row));
            }
        }
        if open && let Some(row) = border(self.points, i, wide, self.resolution, angles) {
            block.border.push((i as u32, row));
        }
    }

    /// The tensor of all neighbours, or where these have more than two sides that of two of them.
    pub(crate) fn sides(&self, i: usize, near: &[u32]) -> Sides {
        let (tensor, pull) = self.normal_tensor(i, near);
        let [least, middle, _] = tensor.values.map(|x| x.max(0.0));
        let folded = middle.sqrt() > 2.0 * self.least_fold * (1.0 - MOST_PENALTY);
        if !folded || least.sqrt() > self.least_fold {
            return Sides { tensor, pull, pair: None };
        }
        let foot = add(self.points[i], shift(&tensor, pull, 1));
        let Some(pair) = pair(self, i, near, foot) else { return Sides { tensor, pull, pair: None } };
        let holds =
            |&&j: &&u32| pair.holds(self.points[j as usize], self.normals.vectors[j as usize].map(f64::from));
        let some: Vec<u32> = near.iter().filter(holds).copied().collect();
        let (tensor, pull) = self.normal_tensor(i, &some);
        Sides { tensor, pull, pair: Some(pair) }
    }

    /// Correlation tensor of the normals around point `i`, and `sum w n (n . (q - p))`, both over the sum of weights.
    pub(crate) fn normal_tensor(&self, i: usize, near: &[u32]) -> (Eigen3, [f64; 3]) {
        let (mut tensor, mut pull, mut total) = ([0.0; 6], [0.0; 3], 0.0);
        for j in near.iter().map(|&j| j as usize).chain([i]) {
            let normal = self.normals.vectors[j].map(f64::from);
            let weight = f64::from(self.normals.support[j]);
            let offset = dot(normal, sub(self.points[j], self.points[i]));
            add_product(&mut tensor, normal, weight);
            pull = add_scaled(pull, normal, weight * offset);
            total += weight;
        }
        let inverse = if total > 0.0 { 1.0 / total } else { 0.0 };
        (eigen3(&tensor.map(|x| x * inverse)), scale(pull, inverse))
    }

    pub(crate) fn crease(
        &self,
        i: usize,
        sides: &Sides,
        penalty: f64,
        wide: &[u32],
        section: &mut CrossSection,
    ) -> Row {
        let Sides { tensor, pull, pair } = sides;
        let [least, middle, _] = tensor.values.map(|x| x.max(0.0));
        let corner = least.sqrt() > self.least_fold;
        let shift = shift(tensor, *pull, if corner { 0 } else { 1 });
        let reach = 2.0 * self.resolution.unit() + 2.0 * self.resolution.noise;
        let foot = if norm(shift) <= reach { add(self.points[i], shift) } else { self.points[i] };
        let certainty = if middle > 0.0 { 1.0 - (least / middle).sqrt() } else { 0.0 };
        // At a corner there is no one cross-section: that says nothing.
        let sharp = if corner {
            Fold::default()
        } else {
            let seen = |&j: &usize| {
                pair.is_none_or(|s| s.holds(self.points[j], self.normals.vectors[j].map(f64::from)))
            };
            let near = wide.iter().map(|&j| j as usize).filter(seen).chain([i]).map(|j| self.points[j]);
            sharpness(near, tensor, foot, self.resolution, section)
        };
        Row {
            scalar: penalty as f32,
            vector: scale(tensor.vectors[0], certainty).map(|x| x as f32),
            corner: (1.0 - (least.sqrt() / self.least_fold).min(1.0)) as f32,
            foot,
            evidence: sharp.evidence as f32,
            expected: sharp.expected as f32,
            fold: sharp.angle.abs() as f32,
        }
    }
}

/// From a point to the place nearest to all tangent planes, along the axes of the tensor from `first` on.
fn shift(tensor: &Eigen3, pull: [f64; 3], first: usize) -> [f64; 3] {
    (first..3).fold([0.0; 3], |shift, k| {
        let along = dot(tensor.vectors[k], pull) / tensor.values[k].max(1e-12);
        add_scaled(shift, tensor.vectors[k], along)
    })
}
