//! Classes of directions: lines, and axes of circles, that are parallel within their covariances.
//!
//! One after the other, the surest first, joins the class whose mean direction is likeliest its own. Classes are looked up in a grid of
//! directions.

use super::feature::{Covariance, Feature, between};
use super::odds;
use crate::math::vec3::{add_scaled, cross, dot, perpendicular, scale, unit};
use std::collections::BTreeMap;

/// Side of a cell of the grid of unit directions; no two directions farther apart are parallel.
const CELL: f64 = 0.1;
/// Density of an axis that has nothing to do with others: one on the half sphere.
const CHANCE: f64 = 1.0 / std::f64::consts::TAU;

/// Directions that are parallel.
#[derive(Clone, Debug)]
pub(super) struct Class {
    /// The features, ascending.
    pub members: Vec<usize>,
    /// The unit mean direction.
    pub direction: [f64; 3],
    /// The covariance of the mean.
    pub turn: Covariance,
    /// Probability of the least likely member; 1 of one alone.
    pub likelihood: f64,
    /// Root mean square angle of the members from the mean.
    pub deviation: f64,
}

/// A class that grows: the weighted mean in the tangent plane of its first member.
struct Growing {
    members: Vec<usize>,
    axes: [[f64; 3]; 3],
    information: [[f64; 2]; 2],
    sum: [f64; 2],
    likelihood: f64,
}

fn inverse([[a, b], [_, c]]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let determinant = a * c - b * b;
    [[c / determinant, -b / determinant], [-b / determinant, a / determinant]]
}

impl Growing {
    fn new(direction: [f64; 3]) -> Self {
        let u = perpendicular(direction);
        let axes = [u, cross(direction, u), direction];
        Self { members: Vec::new(), axes, information: [[0.0; 2]; 2], sum: [0.0; 2], likelihood: 1.0 }
    }

    /// A direction in the tangent plane, with its covariance there.
    fn seen(&self, feature: &Feature) -> ([f64; 2], [[f64; 2]; 2]) {
        let [u, v, w] = self.axes;
        let along = dot(feature.direction, w);
        let at = [dot(feature.direction, u) / along, dot(feature.direction, v) / along];
        let turn = |a, b| between(a, &feature.turn, b);
        (at, [[turn(u, u), turn(u, v)], [turn(u, v), turn(v, v)]])
    }

    fn mean(&self) -> ([f64; 2], [[f64; 2]; 2]) {
        let covariance = inverse(self.information);
        let mean = covariance.map(|row| row[0] * self.sum[0] + row[1] * self.sum[1]);
        (mean, covariance)
    }

    fn likelihood(&self, feature: &Feature, chance: f64) -> f64 {
        let ((at, own), (mean, shared)) = (self.seen(feature), self.mean());
        let sum = [0, 1].map(|i| [0, 1].map(|j| own[i][j] + shared[i][j]));
        odds::of_pair([at[0] - mean[0], at[1] - mean[1]], sum, chance)
    }

    fn add(&mut self, index: usize, feature: &Feature, likelihood: f64) {
        let (at, covariance) = self.seen(feature);
        let weight = inverse(covariance);
        for i in 0..2 {
            for j in 0..2 {
                self.information[i][j] += weight[i][j];
                self.sum[i] += weight[i][j] * at[j];
            }
        }
        self.likelihood = self.likelihood.min(likelihood);
        self.members.push(index);
    }

    fn done(mut self, features: &[Feature]) -> Class {
        let ([x, y], covariance) = self.mean();
        let [u, v, w] = self.axes;
        let direction = unit(add_scaled(add_scaled(w, u, x), v, y));
        let mut turn = [[0.0; 3]; 3];
        for (i, a) in [u, v].into_iter().enumerate() {
            for (j, b) in [u, v].into_iter().enumerate() {
                (0..3).for_each(|k| (0..3).for_each(|l| turn[k][l] += a[k] * covariance[i][j] * b[l]));
            }
        }
        self.members.sort_unstable();
        let sine2 = |&i: &usize| {
            let d = cross(features[i].direction, direction);
            dot(d, d)
        };
        let squares: f64 = self.members.iter().map(sine2).sum();
        let deviation = (squares / self.members.len() as f64).sqrt();
        Class { members: self.members, direction, turn, likelihood: self.likelihood, deviation }
    }
}

fn cell(direction: [f64; 3]) -> [i32; 3] {
    direction.map(|x| (x / CELL).floor() as i32)
}

/// The classes of all features, those with most members first. Members are at least `least` likely.
pub(super) fn classes(features: &[Feature], least: f64) -> Vec<Class> {
    let mut order: Vec<usize> = (0..features.len()).collect();
    order.sort_by(|&a, &b| features[a].doubt().total_cmp(&features[b].doubt()).then(a.cmp(&b)));
    let mut grid: BTreeMap<[i32; 3], Vec<usize>> = BTreeMap::new();
    let mut growing: Vec<Growing> = Vec::new();
    for i in order {
        let feature = &features[i];
        let chance = CHANCE * growing.len() as f64;
        let [x, y, z] = cell(feature.direction);
        let cells = (0..27).map(|k| [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1]);
        let near = cells.filter_map(|c| grid.get(&c)).flatten().copied();
        let best = near
            .map(|c| (growing[c].likelihood(feature, chance), c))
            .max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
        match best.filter(|b| b.0 >= least) {
            Some((likelihood, class)) => growing[class].add(i, feature, likelihood),
            None => {
                for d in [feature.direction, scale(feature.direction, -1.0)] {
                    grid.entry(cell(d)).or_default().push(growing.len());
                }
                let mut alone = Growing::new(feature.direction);
                alone.add(i, feature, 1.0);
                growing.push(alone);
            }
        }
    }
    let mut classes: Vec<Class> = growing.into_iter().map(|g| g.done(features)).collect();
    classes.sort_by(|a, b| b.members.len().cmp(&a.members.len()).then(a.members.cmp(&b.members)));
    classes
}
