//! The cross-section of a crease candidate and its sharpness.

use super::fold::{CrossSection, Fold};
use crate::math::eigen3::Eigen3;
use crate::math::vec3::{add, add_scaled, cross, dot, sub, unit};
use crate::resolution::Resolution;

/// Deviation of real faces from the shapes of a cross-section within a neighbourhood, spacings.
const MODEL_ERROR: f64 = 0.04;
/// Half the length of line over which the cross-section is taken, spacings: over more, a curved line would blur it.
const ALONG: f64 = 2.0;
/// Half the width of the cross-section, spacings.
const ACROSS: f64 = 3.0;
/// Ratio of the normal tensor's two greater eigenvalues up to which its axes tell bisector from crossing direction: a fold of
/// 57 degrees.
const DISTINCT: f64 = 0.3;

/// The sharpness of the cross-section through `foot` at right angles to the least axis of the normal tensor. `near` are its
/// points; `section` is scratch. `None` for too few points.
pub fn sharpness(
    near: impl Iterator<Item = [f64; 3]> + Clone,
    tensor: &Eigen3,
    foot: [f64; 3],
    scale: Resolution,
    section: &mut CrossSection,
) -> Option<Fold> {
    let h = scale.unit();
    let along = tensor.vectors[0];
    let (up, across) = frame(near.clone(), tensor, foot);
    section.clear();
    for point in near {
        let d = sub(point, foot);
        let (u, s) = (dot(d, along) / h, dot(d, across) / h);
        if u.abs() <= ALONG && s.abs() <= ACROSS {
            section.push(s, dot(d, up) / h);
        }
    }
    let variance = (scale.noise / h).powi(2) + MODEL_ERROR * MODEL_ERROR;
    section.fold(variance)
}

/// Bisector and crossing direction of the fold.
///
/// Near a right angle the tensor's two great axes are arbitrary; the bisector is then found by the positions of the neighbours.
fn frame(near: impl Iterator<Item = [f64; 3]>, tensor: &Eigen3, foot: [f64; 3]) -> ([f64; 3], [f64; 3]) {
    let [along, middle, most] = tensor.vectors;
    if tensor.values[1] < DISTINCT * tensor.values[2] {
        return (most, middle);
    }
    let sum = near.fold([0.0; 3], |sum, p| add(sum, sub(p, foot)));
    let up = unit(add_scaled(sum, along, -dot(sum, along)));
    (up, cross(along, up))
}
