//! The projected distance at each point's best scale.
//!
//! T.-T. Tran, S. Ali and D. Laurendeau, *Automatic Sharp Feature Extraction from Point Clouds with Optimal Neighborhood
//! Size*, MVA 2013. A point of a smooth place lies in the plane of its neighbourhood; one on an edge stands off its centroid
//! along the normal. [`scales`] measures that at seven sizes of neighbourhood (sections 2.1 and 2.2), [`choice`] takes the
//! one before the edge comes into sight (2.3), and Otsu's threshold on the histogram of the result marks points (2.4).
//!
//! Two things are said more closely than in the paper. Its histogram has no resolution there: here 256 bins. And ratios of
//! distances that are rounding or noise count as none: see [`choice::floor`].
//!
//! The paper ends with marked points; [`candidates`] prepares them for a linker.

pub mod candidates;
pub mod choice;
pub mod scales;

use super::marks::Marks;
use crate::params::ProjectionParams;
use crate::resolution::Resolution;
use scales::{SCALES, at_every_scale};

/// What the method says of every point, canonical order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Projection {
    /// Normalised projected distances at the best scales, with the threshold.
    pub marks: Marks,
    /// `(N)` the best scale: a number of neighbours.
    pub scale: Vec<u8>,
    /// `(N, 3)` unit normals at that scale, without orientation.
    pub normal: Vec<[f32; 3]>,
}

/// Noise, in spacings, above which the marks are mostly false; measured on a part with known edges.
pub const NOISE_LIMIT: f64 = 0.15;

/// Projected distances of all points at their best scales, and which of them are marked. `points` in canonical order,
/// local frame.
pub fn project(points: &[[f64; 3]], resolution: Resolution, params: &ProjectionParams) -> Projection {
    let floor = choice::floor(resolution, params);
    let rows = at_every_scale(points, |_, _, scales| {
        let best = choice::best_scale(scales, floor, params.jump);
        let at = scales[best];
        (at.distance as f32, SCALES[best] as u8, at.normal.map(|x| x as f32))
    });
    let mut projection = Projection::default();
    let mut distances = Vec::with_capacity(rows.len());
    for (distance, scale, normal) in rows {
        distances.push(distance);
        projection.scale.push(scale);
        projection.normal.push(normal);
    }
    projection.marks = Marks::new(distances, floor, params.bins);
    projection
}

/// What to tell the user when there is too much noise for this method.
pub fn warning(resolution: Resolution) -> Option<String> {
    let ratio = resolution.noise / resolution.spacing;
    (ratio > NOISE_LIMIT).then(|| {
        format!(
            "noise of {ratio:.2} spacings: above {NOISE_LIMIT} the projected distance marks smooth points too; \
             the method `penalty` stands more"
        )
    })
}
