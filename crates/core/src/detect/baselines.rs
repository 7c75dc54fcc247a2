//! The measures to which Tran 2013 compares the projected distance, each with the same automatic threshold.
//!
//! Section 3.1 of the paper compares it with surface variation, mean curvature and the difference of normals, all cut by
//! Otsu's method. The paper gives no scale for them; here it is 16, which the paper calls the usual size. Two more measures, at
//! the seven scales of Tran, are those of M. Pauly, R. Keiser and M. Gross, *Multi-scale Feature Extraction on Point-Sampled
//! Surfaces*, Computer Graphics Forum 22 (2003).

mod curvature;
mod normal_difference;
mod variation;

use super::projection::marks::{Floor, Marks};
use super::projection::project;
use crate::params::{ProjectionParams, choices};
use crate::resolution::Resolution;

/// Number of neighbours for the measures of one scale, and its index among the scales.
const SCALE: (usize, usize) = (16, 2);

/// Values up to this are rounding: at an edge all of these measures are near one.
const ROUNDING: f64 = 1e-6;

/// A measure that marks points by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detector {
    /// Projected distance at the best scale (Tran 2013).
    Projection,
    /// Surface variation (Pauly 2003, section 2): least eigenvalue over the sum of all.
    SurfaceVariation,
    /// Absolute mean curvature of a fitted quadric.
    MeanCurvature,
    /// Mean angle between the normal of a point and those of its neighbours.
    NormalDifference,
    /// Greatest surface variation over all scales (Pauly 2003, section 2).
    MultiscaleVariation,
    /// Share of the scales at which the surface variation is high (Pauly 2003, section 3).
    Persistence,
}

choices! {
    Detector {
        Projection = "projection",
        SurfaceVariation = "surface-variation",
        MeanCurvature = "mean-curvature",
        NormalDifference = "normal-difference",
        MultiscaleVariation = "multiscale-variation",
        Persistence = "persistence"
    }
}

impl Detector {
    /// Every detector, the paper's first.
    pub const ALL: [Detector; 6] = [
        Detector::Projection,
        Detector::SurfaceVariation,
        Detector::MeanCurvature,
        Detector::NormalDifference,
        Detector::MultiscaleVariation,
        Detector::Persistence,
    ];

    /// The detector of that name.
    pub fn named(name: &str) -> Option<Detector> {
        crate::params::ParamValue::parse(name)
    }

    /// The name that [`named`](Self::named) reads.
    pub fn name(self) -> String {
        crate::params::ParamValue::show(&self)
    }
}

/// Scores and marks of one detector. `points` in canonical order, local frame.
pub fn marks(
    points: &[[f64; 3]],
    resolution: Resolution,
    params: &ProjectionParams,
    detector: Detector,
) -> Marks {
    let values = match detector {
        Detector::Projection => return project(points, resolution, params).marks,
        Detector::SurfaceVariation => variation::at_scale(points),
        Detector::MeanCurvature => curvature::mean(points, resolution),
        Detector::NormalDifference => normal_difference::mean_angle(points),
        Detector::MultiscaleVariation => variation::greatest(points),
        Detector::Persistence => variation::persistence(points, params.bins),
    };
    Marks::new(values, Floor { mark: ROUNDING, beside: ROUNDING }, params)
}
