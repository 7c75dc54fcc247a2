//! A sample of a surface: places with their normals.

use crate::math::vec3;
use crate::neighbors::Index;
use crate::section::surface::plane::{Around, FIRST_NEIGHBORS, MOST_NEIGHBORS};
use crate::section::surface::sample::sampled;
use crate::section::surface::tile::good;

/// Residual, in spacings, that the bend of a bore adds to that of noise.
const BORE_RESIDUAL: f64 = 0.05;
/// Greatest distance between an axis and a face that is turned about it, in standard deviations of all places.
const AXIS_REACH: f64 = 3.0;
/// Greatest error of normals, degrees: without noise, and for each spacing of noise.
const OFF_DEG: (f64, f64) = (2.0, 12.0);

/// A place on a face.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Facet {
    pub at: [f64; 3],
    /// Of either sign.
    pub normal: [f64; 3],
    /// The area that it stands for.
    pub area: f64,
    pub spacing: f64,
}

/// Evenly spread places that lie clear of edges.
pub(crate) struct Facets {
    pub all: Vec<Facet>,
    /// Greatest error of normals, radians.
    pub off: f64,
    /// Area of all of them.
    pub area: f64,
    /// Distance from an axis within which faces may be turned about it.
    pub reach: f64,
    middle: [f64; 3],
}

impl Facets {
    pub(crate) fn of(points: &[[f64; 3]], index: &Index, noise: f64) -> Self {
        let around = ((12.0 + 50.0 * noise) as usize).clamp(FIRST_NEIGHBORS, MOST_NEIGHBORS) - 1;
        let all = sampled(points, index, around, |i, near| facet(points, i, near, noise));
        let off = (OFF_DEG.0 + OFF_DEG.1 * noise).to_radians();
        let area: f64 = all.iter().map(|f| f.area).sum();
        let middle = [0, 1, 2].map(|k| all.iter().map(|f| f.area * f.at[k]).sum::<f64>() / area);
        let mut facets = Self { all, off, area, reach: 0.0, middle };
        let [xx, _, _, yy, _, zz] = facets.tensor(|f| facets.off_middle(f));
        facets.reach = AXIS_REACH * ((xx + yy + zz) / area).sqrt();
        facets
    }

    /// The area-weighted sums of the products of vectors: xx, xy, xz, yy, yz, zz.
    pub(crate) fn tensor(&self, of: impl Fn(&Facet) -> [f64; 3]) -> [f64; 6] {
        let mut sums = [0.0; 6];
        for f in &self.all {
            let [x, y, z] = of(f);
            let products = [x * x, x * y, x * z, y * y, y * z, z * z];
            sums.iter_mut().zip(products).for_each(|(sum, p)| *sum += f.area * p);
        }
        sums
    }

    /// A place from the middle of all of them.
    pub(crate) fn off_middle(&self, f: &Facet) -> [f64; 3] {
        vec3::sub(f.at, self.middle)
    }

    /// The variance of the places along an axis.
    pub(crate) fn variance(&self, axis: [f64; 3]) -> f64 {
        let along = |f: &Facet| vec3::dot(self.off_middle(f), axis);
        self.all.iter().map(|f| f.area * along(f).powi(2)).sum::<f64>() / self.area
    }
}

/// The facet at a point, unless its neighbours lie on no plane.
fn facet(points: &[[f64; 3]], i: u32, near: &[u32], noise: f64) -> Option<Facet> {
    let mut around = Around::gather(points, i, near);
    let first = around.plain();
    let plane = around.anchored(&first, noise);
    let flat = plane.residual <= (good(noise) + BORE_RESIDUAL) * plane.spacing && plane.normal != [0.0; 3];
    let (spacing, at) = (plane.spacing, points[i as usize]);
    flat.then_some(Facet { at, normal: plane.normal, area: spacing * spacing, spacing })
}
