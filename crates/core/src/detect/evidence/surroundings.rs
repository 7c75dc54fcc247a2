//! A cloud with its normals, and the correlation tensor of the normals around a point.

use super::hops::hops;
use super::normals::Normals;
use crate::math::eigen3::{Eigen3, eigen3};
use crate::math::tensor::add_product;
use crate::math::vec3::{add_scaled, dot, scale, sub};
use crate::neighbors::Neighbors;
use crate::params::Auto;
use crate::surface::Scales;

/// The data from which the evidence at a point is computed: canonical order, local frame.
pub(crate) struct Surroundings<'a> {
    pub(crate) points: &'a [[f64; 3]],
    pub(crate) graph: &'a Neighbors,
    pub(crate) normals: Normals,
    pub(crate) scales: Scales<'a>,
    /// Graph distance of the neighbourhoods, if given; otherwise it follows from the noise at each point.
    hops: Auto<usize>,
    /// Sine of half the least fold of a crease.
    pub(crate) least_fold: f64,
}

impl<'a> Surroundings<'a> {
    /// `fold_deg` is the least fold of a crease, degrees.
    pub(crate) fn new(
        points: &'a [[f64; 3]],
        graph: &'a Neighbors,
        normals: Normals,
        scales: impl Into<Scales<'a>>,
        hops: Auto<usize>,
        fold_deg: f64,
    ) -> Self {
        let least_fold = (0.5 * fold_deg.to_radians()).sin();
        Self { points, graph, normals, scales: scales.into(), hops, least_fold }
    }

    /// Graph distance of the neighbourhood of point `i`.
    pub(crate) fn hops(&self, i: usize) -> usize {
        hops(self.hops, self.scales.at(i))
    }

    /// The normal of point `i`.
    pub(super) fn normal(&self, i: usize) -> [f64; 3] {
        self.normals.vectors[i].map(f64::from)
    }

    /// Correlation tensor of the normals around point `i`, and `sum w n (n . (q - p))`, both over the sum of weights.
    pub(super) fn normal_tensor(&self, i: usize, near: &[u32]) -> (Eigen3, [f64; 3]) {
        let (mut tensor, mut pull, mut total) = ([0.0; 6], [0.0; 3], 0.0);
        for j in near.iter().map(|&j| j as usize).chain([i]) {
            let normal = self.normal(j);
            let weight = f64::from(self.normals.support[j]);
            let offset = dot(normal, sub(self.points[j], self.points[i]));
            add_product(&mut tensor, normal, weight);
            pull = add_scaled(pull, normal, weight * offset);
            total += weight;
        }
        let inverse = if total > 0.0 { 1.0 / total } else { 0.0 };
        (eigen3(&tensor.map(|x| x * inverse)), scale(pull, inverse))
    }
}

/// The vector from a point to the place nearest to all tangent planes, along the axes of the tensor from `first` on: the
/// quadric error of Gumhold 2001, section 4.2.
pub(super) fn shift(tensor: &Eigen3, pull: [f64; 3], first: usize) -> [f64; 3] {
    (first..3).fold([0.0; 3], |shift, k| {
        let along = dot(tensor.vectors[k], pull) / tensor.values[k].max(1e-12);
        add_scaled(shift, tensor.vectors[k], along)
    })
}
