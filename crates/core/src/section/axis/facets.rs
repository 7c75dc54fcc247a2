//! A sample of a surface: places with their normals.

use super::super::plane::{Around, FIRST, MOST};
use super::super::tile::good;
use crate::math::vec3;
use crate::neighbors::{Index, WIDTH, nearest_leaves};

/// Points that are looked at.
const SAMPLE: usize = 8_000;
/// Residual, in spacings, that the bend of a bore adds to that of noise.
const BENT: f64 = 0.05;
/// How far, in standard deviations of all places, an axis may pass from a face that is turned about it.
const FAR: f64 = 3.0;
/// How far normals may be off, degrees: without noise, and what noise (in spacings) adds.
const OFF_DEG: (f64, f64) = (2.0, 12.0);

/// A place on a face.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet {
    pub at: [f64; 3],
    /// Of either sign.
    pub normal: [f64; 3],
    /// The area that it stands for.
    pub area: f64,
    pub spacing: f64,
}

/// Evenly spread places that lie clear of edges.
pub(super) struct Facets {
    pub all: Vec<Facet>,
    /// How far normals may be off, radians.
    pub off: f64,
    /// Area of all of them.
    pub area: f64,
    /// Distance from an axis within which faces may be turned about it.
    pub reach: f64,
    middle: [f64; 3],
}

impl Facets {
    pub(super) fn of(points: &[[f64; 3]], index: &Index, noise: f64) -> Self {
        let step = index.leaves.len().div_ceil(SAMPLE / WIDTH).max(1);
        let leaves: Vec<u32> = (0..index.leaves.len() as u32).step_by(step).collect();
        let around = ((12.0 + 50.0 * noise) as usize).clamp(FIRST, MOST) - 1;
        let width = around.min(points.len().saturating_sub(1));
        let visit = |first: usize, lists: &[u32]| {
            let lists = lists.chunks(WIDTH * width).zip(&leaves[first..]);
            let facets = lists.flat_map(|(lists, &leaf)| {
                let ids = index.leaves[leaf as usize].ids().zip(lists.chunks(width));
                ids.filter_map(|(i, near)| facet(points, i, near, noise))
            });
            facets.collect::<Vec<Facet>>()
        };
        let all = nearest_leaves(index, points, around, &leaves, visit).concat();
        let off = (OFF_DEG.0 + OFF_DEG.1 * noise).to_radians();
        let area: f64 = all.iter().map(|f| f.area).sum();
        let middle = [0, 1, 2].map(|k| all.iter().map(|f| f.area * f.at[k]).sum::<f64>() / area);
        let mut facets = Self { all, off, area, reach: 0.0, middle };
        let [xx, _, _, yy, _, zz] = facets.tensor(|f| facets.off_middle(f));
        facets.reach = FAR * ((xx + yy + zz) / area).sqrt();
        facets
    }

    /// The area-weighted sums of the products of vectors: xx, xy, xz, yy, yz, zz.
    pub(super) fn tensor(&self, of: impl Fn(&Facet) -> [f64; 3]) -> [f64; 6] {
        let mut sums = [0.0; 6];
        for f in &self.all {
            let [x, y, z] = of(f);
            let products = [x * x, x * y, x * z, y * y, y * z, z * z];
            sums.iter_mut().zip(products).for_each(|(sum, p)| *sum += f.area * p);
        }
        sums
    }

    /// A place from the middle of all of them.
    pub(super) fn off_middle(&self, f: &Facet) -> [f64; 3] {
        vec3::sub(f.at, self.middle)
    }

    /// The variance of the places along an axis.
    pub(super) fn variance(&self, axis: [f64; 3]) -> f64 {
        let along = |f: &Facet| vec3::dot(self.off_middle(f), axis);
        self.all.iter().map(|f| f.area * along(f).powi(2)).sum::<f64>() / self.area
    }
}

/// The facet at a point, unless its neighbours lie on no plane.
fn facet(points: &[[f64; 3]], i: u32, near: &[u32], noise: f64) -> Option<Facet> {
    let mut around = Around::gather(points, i, near);
    let first = around.plain();
    let patch = around.anchored(&first, noise);
    let flat = patch.residual <= (good(noise) + BENT) * patch.spacing && patch.normal != [0.0; 3];
    let (spacing, at) = (patch.spacing, points[i as usize]);
    flat.then_some(Facet { at, normal: patch.normal, area: spacing * spacing, spacing })
}
