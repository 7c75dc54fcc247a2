//! The correlation tensor of the normals around a point: of all of them, or of two sides alone.

use super::pair::{Pair, pair};
use super::surroundings::{Surroundings, shift};
use crate::math::eigen3::Eigen3;
use crate::math::vec3::add;

/// Share of a crease's least fold, both as sines of the half angle, below which a point is not a candidate.
pub(crate) const FOLDED: f64 = 0.5;

/// The surface around a point.
pub(crate) struct Sides {
    /// Correlation tensor of the normals: two faces that fold by `phi` give it a middle eigenvalue of `sin^2(phi / 2)`.
    pub(crate) tensor: Eigen3,
    /// The pull of their tangent planes on the point: `sum w n (n . (q - p))` over the sum of weights.
    pub(crate) pull: [f64; 3],
    /// The two sides that were taken, where there are more.
    pub(crate) pair: Option<Pair>,
}

impl Sides {
    /// The tensor of all neighbours, or of two sides where the neighbours have more.
    pub(crate) fn around(surroundings: &Surroundings, i: usize, near: &[u32]) -> Sides {
        let (tensor, pull) = surroundings.normal_tensor(i, near);
        let [least, middle, _] = tensor.values.map(|x| x.max(0.0));
        let least_fold = surroundings.least_fold;
        if middle.sqrt() <= FOLDED * least_fold || least.sqrt() > least_fold {
            return Sides { tensor, pull, pair: None };
        }
        let foot = add(surroundings.points[i], shift(&tensor, pull, 1));
        let Some(pair) = pair(surroundings, i, near, foot) else {
            return Sides { tensor, pull, pair: None };
        };
        let holds = |&&j: &&u32| pair.holds(surroundings.points[j as usize], surroundings.normal(j as usize));
        let held: Vec<u32> = near.iter().filter(holds).copied().collect();
        let (tensor, pull) = surroundings.normal_tensor(i, &held);
        Sides { tensor, pull, pair: Some(pair) }
    }

    /// Sine of half the angle by which the surface folds.
    pub(crate) fn fold(&self) -> f64 {
        self.tensor.values[1].max(0.0).sqrt()
    }
}
