//! How well curves and joints are known.

use super::super::feature::Feature;
use super::super::find::Found;
use crate::math::least_squares::inverse;
use crate::network::Network;

/// Standard deviation of a joint without noise, in spacings of the strips that end there.
const JOINT: f64 = 0.5;

/// How well curves and joints are known.
pub(super) struct Doubts {
    /// Standard deviation of each joint on each axis.
    pub joint: Vec<f64>,
    /// For each feature the rows that whiten its observations.
    pub white: Vec<[[f64; 6]; 6]>,
}

/// The doubts of a network of which each strip has points `spacing` apart.
pub(super) fn doubts(network: &Network, found: &Found, spacing: &[f64], noise: f64) -> Doubts {
    let mut joint = vec![0.0_f64; found.joints.places.len()];
    for (s, strip) in network.strips.iter().enumerate() {
        for c in 0..strip.curves.len() {
            for j in found.joints.ends[s][c].into_iter().flatten() {
                joint[j] = joint[j].max(JOINT * spacing[s].hypot(noise));
            }
        }
    }
    // A node without curves has nothing to be moved by: any weight keeps it.
    joint.iter_mut().filter(|j| **j == 0.0).for_each(|j| *j = 1.0);
    Doubts { joint, white: found.features.iter().map(white).collect() }
}

/// The rows `L^T` of the information `L L^T`, the inverse of the covariance.
fn white(feature: &Feature) -> [[f64; 6]; 6] {
    let mut covariance = feature.observed.covariance;
    if feature.round().is_none() {
        // A line has four parameters.
        for k in [2, 3] {
            covariance[k] = [0.0; 6];
            covariance.iter_mut().for_each(|row| row[k] = 0.0);
            covariance[k][k] = 1.0;
        }
    }
    let diagonal = || {
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 1.0 / covariance[i][i] } else { 0.0 }))
    };
    let information: [[f64; 6]; 6] = inverse(covariance).unwrap_or_else(diagonal);
    let mut lower = [[0.0; 6]; 6];
    for i in 0..6 {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
            let left = information[i][j] - sum;
            lower[i][j] = if i == j {
                left.max(0.0).sqrt()
            } else if lower[j][j] > 0.0 {
                left / lower[j][j]
            } else {
                0.0
            };
        }
    }
    std::array::from_fn(|j| std::array::from_fn(|i| lower[i][j]))
}
