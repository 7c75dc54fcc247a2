//! The result of segmentation, and its angle.

use super::segmentation::Segmentation;
use crate::neighbors::Neighbors;
use crate::params::{Auto, SegmentForm, SegmentParams};
use crate::resolution::Resolution;

/// `alpha_max`, the paper's angle, degrees.
const ANGLE_DEG: f64 = 8.0;

/// A segmented cloud.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Segmented {
    /// The clusters.
    pub segments: Segmentation,
    /// The one-rings (as printed; empty in the robust form, which uses the neighbour graph).
    pub rings: Neighbors,
    /// Positions after smoothing; empty if the noise did not require any.
    pub smoothed: Vec<[f64; 3]>,
    /// Number of rounds of smoothing.
    pub rounds: usize,
    /// The steps with their times in seconds.
    pub seconds: Vec<(&'static str, f64)>,
}

/// The segmentation's angle, degrees: the paper's 8, and up to twice that where noise tilts the normals.
pub(crate) fn angle(params: &SegmentParams, resolution: Resolution) -> f64 {
    params.angle_deg.or(|| match params.form {
        SegmentForm::Paper => ANGLE_DEG,
        SegmentForm::Robust => ANGLE_DEG * (1.0 + (2.0 * resolution.noise / resolution.spacing).min(1.0)),
    })
}

impl Segmented {
    /// A note for the summary on changes due to noise; `None` without any.
    pub(crate) fn note(&self, params: &SegmentParams, resolution: Resolution, hops: usize) -> Option<String> {
        let (angle, ratio) = (angle(params, resolution), resolution.noise / resolution.spacing);
        match (params.form, self.rounds) {
            (SegmentForm::Paper, 0) => None,
            (SegmentForm::Paper, rounds) => Some(format!(
                "too noisy for clusters by {angle} degrees: smoothed {rounds} times, normals from rings of {} edges",
                rounds + 1
            )),
            (SegmentForm::Robust, _) if angle > ANGLE_DEG && params.angle_deg == Auto::Auto && hops > 1 => {
                Some(format!(
                    "noise of {ratio:.2} spacings: normals from neighbourhoods of {hops} edges, clusters by \
                     {angle:.1} degrees instead of {ANGLE_DEG}"
                ))
            }
            _ => None,
        }
    }
}
