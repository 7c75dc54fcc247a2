//! Detectors: what every point says of the lines it may lie on.

pub mod baselines;
pub mod consensus;
pub mod fold;
pub mod marks;
pub mod normals;
pub mod open_angle;
pub mod penalty;
pub mod points;
pub mod projection;
pub mod segments;
pub mod tensor;

use crate::measure::Measure;
use crate::neighbors::Neighbors;
use crate::params::{Method, Params};
use crate::resolution::Resolution;

/// What the method asked for says of every point. `points` in canonical order, local frame; `graph` is the Riemannian graph.
pub fn detect(points: &[[f64; 3]], graph: &Neighbors, resolution: Resolution, params: &Params) -> Measure {
    match params.method {
        Method::Penalty => penalty::penalty(points, graph, resolution, &params.penalty),
        // Segmentation belongs to linking: its robust form looks at the penalties first.
        Method::Segments => penalty::penalty(points, graph, resolution, &params.penalty),
        Method::Projection => projection::candidates::measure(points, graph, resolution, params),
    }
}
