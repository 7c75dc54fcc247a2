//! The projected distance at each point's best scale.
//!
//! T.-T. Tran, S. Ali and D. Laurendeau, *Automatic Sharp Feature Extraction from Point Clouds with Optimal Neighborhood
//! Size*, MVA 2013. On a smooth surface a point lies in the plane of its neighbourhood; on an edge it is displaced from the
//! centroid along the normal. [`scales`] measures this displacement at seven sizes of neighbourhood (sections 2.1 and 2.2),
//! `choice` finds the optimal size by the rate of change (2.3), and Otsu's threshold on the histogram of the result marks
//! points (2.4).
//!
//! Details that the paper leaves open, and departures:
//! * The final value is the distance divided by the radius of its neighbourhood, so that sparse places do not outweigh dense
//!   ones.
//! * The paper does not give the resolution of the histogram; here it has 256 bins.
//! * In figure 5 one cut tells smooth points from potential edges and corners. The neighbourhoods of points within a spacing of
//!   an edge hold it too, so their values lie between: Otsu's method for three classes tells all three apart and marks the two
//!   upper ones, unless these are most of the cloud (see [`Marks::new`]). With `projection.classes=2` there is one cut, the
//!   paper's, and marks lie on the edge.
//! * Distances that are rounding or noise are not edges, and their ratios do not count: see `choice`.
//!
//! The paper ends with marked points; `candidates` prepares them for a linker.

pub(crate) mod candidates;
mod choice;
pub mod marks;
pub mod scales;
pub mod steps;

pub(crate) use choice::floor_spacings;

use std::f64::consts::PI;

use crate::params::ProjectionParams;
use crate::resolution::Resolution;
use marks::{Floor, Marks};
use scales::{SCALES, at_every_scale};

/// The method's results for every point, canonical order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Projection {
    /// Projected distances at the best scales divided by the radii, normalised, with the threshold.
    pub marks: Marks,
    /// `(N)` the best scale: a number of neighbours.
    pub scale: Vec<u8>,
    /// `(N, 3)` unit normals at that scale, without orientation.
    pub normal: Vec<[f32; 3]>,
}

/// Noise, in spacings, above which a quarter of the marks or more are wrong or missing; measured on a part with known edges (the
/// bench `projection`), where F1 falls from .93 to .77 at this noise.
pub const NOISE_LIMIT: f64 = 0.15;

/// Greatest projected distance, in spacings, of a point near an edge but not on it (the paper's table 1: less than 0.1).
const NEAR_SHARP: f64 = 0.1;

/// Projected distances of all points at their best scales, with the marks. `points` in canonical order, local frame.
pub fn project(points: &[[f64; 3]], resolution: Resolution, params: &ProjectionParams) -> Projection {
    let floor = choice::floor(resolution, params);
    let standard = choice::standard(resolution);
    let rows = at_every_scale(points, |_, _, scales| {
        let best = choice::best_scale(scales, floor, params.jump, standard);
        let at = scales[best];
        (
            (at.distance / at.radius.max(f64::MIN_POSITIVE)) as f32,
            SCALES[best] as u8,
            at.normal.map(|x| x as f32),
        )
    });
    let mut projection = Projection::default();
    let mut distances = Vec::with_capacity(rows.len());
    for (distance, scale, normal) in rows {
        distances.push(distance);
        projection.scale.push(scale);
        projection.normal.push(normal);
    }
    // The radius of a disc with one point for each square spacing.
    let radius = ((SCALES[standard] + 1) as f64 / PI).sqrt() * resolution.spacing;
    let floor = Floor { mark: floor / radius, beside: NEAR_SHARP * resolution.spacing / radius };
    projection.marks = Marks::new(distances, floor, params);
    projection
}

/// The warning for a cloud with too much noise for this method; `None` for others.
pub fn warning(resolution: Resolution) -> Option<String> {
    let ratio = resolution.noise / resolution.spacing;
    (ratio > NOISE_LIMIT).then(|| {
        format!(
            "noise of {ratio:.2} spacings: above {NOISE_LIMIT} the projected distance marks smooth points too; \
             the method `penalty` stands more"
        )
    })
}
