//! The robust segmentation, by normals that keep to their side of a crease (ours).

use super::absorb::absorb;
use super::segmentation::Segmentation;
use super::segmented::{Segmented, angle};
use crate::measure::Measure;
use crate::neighbors::Neighbors;
use crate::params::SegmentParams;
use crate::resolution::Resolution;
use std::time::Instant;

/// The segmentation of a cloud by the normals and scores of `measure`.
pub(crate) fn robust(
    points: &[[f64; 3]],
    graph: &Neighbors,
    resolution: Resolution,
    params: &SegmentParams,
    measure: &Measure,
) -> Segmented {
    let start = Instant::now();
    // Points on folds are left out: a single one with a normal in between would join two faces.
    let sharp = |i: usize| measure.score[i] > params.fold_score as f32;
    let radians = angle(params, resolution).to_radians();
    let segments = Segmentation::grow(graph, &measure.normal, radians, params.face_points as u32, sharp);
    let segments = absorb(segments, points, &measure.normal, graph);
    Segmented { segments, seconds: vec![("segments", start.elapsed().as_secs_f64())], ..Segmented::default() }
}
