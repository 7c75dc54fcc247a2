//! The steps to the marks for viewers: the distances at every scale (Tran 2013, figure 3) and the histogram with its cuts (figure 5).

use super::scales::{SCALES, at_every_scale};
use super::{Projection, project};
use crate::math::otsu::{histogram, otsu, otsu3};
use crate::params::ProjectionParams;
use crate::resolution::Resolution;

/// The steps of the projected distance, canonical order, local frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Steps {
    /// `(M, 7)` projected distance at each of [`SCALES`].
    pub distances: Vec<[f32; SCALES.len()]>,
    /// `(M, 7)` distance of the farthest neighbour at each.
    pub radii: Vec<[f32; SCALES.len()]>,
    /// Best scales, scores, and the threshold that marks points.
    pub projection: Projection,
    /// Counts of the scores in equal bins over `[0, 1]`.
    pub histogram: Vec<u64>,
    /// Otsu's cut into two classes; `None` if all scores fall into one bin.
    pub cut: Option<f64>,
    /// Otsu's cuts into three classes, the lower first; `None` for scores in fewer than three bins, and if two classes are asked for.
    pub cuts: Option<[f64; 2]>,
}

/// The steps of all points; `points` in canonical order, local frame.
pub(crate) fn steps(points: &[[f64; 3]], resolution: Resolution, params: &ProjectionParams) -> Steps {
    let rows = at_every_scale(points, |_, _, scales| {
        (scales.map(|s| s.distance as f32), scales.map(|s| s.radius as f32))
    });
    let (distances, radii) = rows.into_iter().unzip();
    let projection = project(points, resolution, params);
    let score = &projection.marks.score;
    Steps {
        distances,
        radii,
        histogram: histogram(score, params.bins),
        cut: otsu(score, params.bins).map(|cut| cut.threshold),
        cuts: (params.classes > 2).then(|| otsu3(score, params.bins)).flatten(),
        projection,
    }
}
