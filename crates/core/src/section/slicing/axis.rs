//! The axis that a part is best cut across, from the normals of its faces.
//!
//! A face is explained by an axis if it stands along it, lies across it, or is turned about it, as the faces of an extrusion, a hole or a
//! revolution are. The axis that explains most of the surface is taken; of those that explain about as much the one
//! along which the section changes least often, since a face that lies across is a change; of those the one along which the
//! cloud extends furthest. So a bent sheet is cut across its profile, a plate with holes and a storey of a house along their
//! outlines, and a block across its length.

mod candidates;
mod facets;
mod pose;

use crate::math::vec3;
use crate::neighbors::Index;
use facets::Facets;
use pose::Pose;

/// Noise, in spacings, above which points show no surface: those strewn through a volume seem to have half a spacing.
const NO_SURFACE: f64 = 0.4;
/// Share of the surface that must hold an axis against turning.
const HELD_SHARE: f64 = 0.05;
/// Difference in the share of the surface up to which axes are equally good.
const AS_GOOD: f64 = 0.02;
/// Greatest number of changes of the section along an axis that counts as good, as a multiple of the least number.
const OFTEN: f64 = 1.25;

/// The axis of the faces, a unit vector of either sign; `None` where none explains this `share` of the surface (chance
/// explains a tenth).
pub(crate) fn of_faces(points: &[[f64; 3]], index: &Index, noise: f64, share: f64) -> Option<[f64; 3]> {
    if noise > NO_SURFACE {
        return None;
    }
    let facets = Facets::of(points, index, noise);
    let mut poses: Vec<(Pose, f64)> = candidates::directions(&facets)
        .into_iter()
        .map(|axis| Pose::along(axis, &facets))
        .filter(|pose| pose.held(&facets) >= HELD_SHARE)
        .map(|pose| (pose, pose.explained(&facets)))
        .collect();
    let most = poses.iter().map(|p| p.1).fold(0.0, f64::max);
    if most < share {
        return None;
    }
    poses.retain(|p| p.1 >= most - AS_GOOD);
    // Of those about one axis the best.
    poses.sort_by(|a, b| b.1.total_cmp(&a.1));
    let near = |a: [f64; 3], b: [f64; 3]| vec3::dot(a, b).abs() >= (2.0 * facets.off).cos();
    let mut kept: Vec<Pose> = Vec::new();
    for (pose, _) in poses {
        if !kept.iter().any(|k| near(k.axis, pose.axis)) {
            kept.push(pose);
        }
    }
    let changes: Vec<f64> = kept.iter().map(|p| p.changes(&facets)).collect();
    let fewest = changes.iter().copied().fold(f64::INFINITY, f64::min);
    let steady = kept.iter().zip(&changes).filter(|(_, c)| **c <= OFTEN * fewest).map(|(p, _)| p);
    let longest = steady.max_by(|a, b| facets.variance(a.axis).total_cmp(&facets.variance(b.axis)));
    longest.map(|pose| snapped(pose.axis, pose.uncertainty(&facets)))
}

/// The coordinate axis within an angle of an axis, radians; else the axis itself.
pub(crate) fn snapped(axis: [f64; 3], within: f64) -> [f64; 3] {
    let unit = |k: usize| std::array::from_fn(|a| if a == k { axis[k].signum() } else { 0.0 });
    (0..3).map(unit).find(|&to| vec3::norm(vec3::cross(axis, to)) <= within.sin()).unwrap_or(axis)
}
