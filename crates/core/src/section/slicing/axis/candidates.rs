//! Directions that may be the axis: the most common normals, the directions square to two of them, and the principal
//! axes of normals and of places, which a turned part without any plane face shows.

use super::facets::{Facet, Facets};
use crate::math::eigen3::eigen3;
use crate::math::vec3;

/// Facets that stand for all while normals are gathered.
const SAMPLE: usize = 1_000;
/// Most common normals.
const MOST_NORMALS: usize = 10;
/// Share of the surface below which a normal is not common.
const COMMON_SHARE: f64 = 0.01;
/// Sine of the angle below which two directions are one.
const SAME_SINE: f64 = 0.1;

/// Unit vectors of either sign, no two of them alike.
pub(crate) fn directions(facets: &Facets) -> Vec<[f64; 3]> {
    let common = common_normals(facets);
    let mut found = common.clone();
    for (i, &a) in common.iter().enumerate() {
        found.extend(
            common[..i]
                .iter()
                .map(|&b| vec3::cross(a, b))
                .filter(|c| vec3::norm(*c) > SAME_SINE)
                .map(vec3::unit),
        );
    }
    found.extend(eigen3(&facets.tensor(|f| f.normal)).vectors);
    found.extend(eigen3(&facets.tensor(|f| facets.off_middle(f))).vectors);
    let mut unlike: Vec<[f64; 3]> = Vec::new();
    for axis in found {
        if unlike.iter().all(|u| vec3::norm(vec3::cross(*u, axis)) > 0.5 * facets.off) {
            unlike.push(axis);
        }
    }
    unlike
}

/// The normals that most of the surface has, one after the other.
fn common_normals(facets: &Facets) -> Vec<[f64; 3]> {
    let step = facets.all.len().div_ceil(SAMPLE).max(1);
    let mut left: Vec<Facet> = facets.all.iter().step_by(step).copied().collect();
    let area: f64 = left.iter().map(|f| f.area).sum();
    let near = facets.off.cos();
    let mut found = Vec::new();
    while found.len() < MOST_NORMALS {
        let share = |n: [f64; 3]| {
            left.iter().filter(|f| vec3::dot(f.normal, n).abs() >= near).map(|f| f.area).sum::<f64>()
        };
        let shares = left.iter().map(|f| (share(f.normal), f.normal));
        let Some((most, normal)) = shares.max_by(|a, b| a.0.total_cmp(&b.0)) else { break };
        if most < COMMON_SHARE * area {
            break;
        }
        let mean =
            left.iter().filter(|f| vec3::dot(f.normal, normal).abs() >= near).fold([0.0; 3], |sum, f| {
                vec3::add_scaled(sum, f.normal, f.area * vec3::dot(f.normal, normal).signum())
            });
        found.push(vec3::unit(mean));
        left.retain(|f| vec3::dot(f.normal, normal).abs() < (2.0 * facets.off).cos());
    }
    found
}
