//! The steps of the method `segments` that look at points: rings, normals, segmentation; each with its time.

use super::smoothing::{ROUNDS, smoothed, too_noisy, wide_normals};
use super::{Segmentation, absorb};
use crate::measure::{Direction, Measure, Penalties};
use crate::neighbors::{Neighbors, all_nearest, delaunay_ring::one_rings};
use crate::params::{Auto, SegmentForm, SegmentParams};
use crate::resolution::Resolution;
use std::time::Instant;

/// The angle of the paper, degrees.
const ANGLE_DEG: f64 = 8.0;
/// A face has at least this many points (robust form).
const LEAST_FACE: u32 = 12;

/// Small clusters wider than this, spacings, are taken apart (paper form).
const APART: f64 = 2.5;
/// Score from which on a point belongs to a fold and not to a face (robust form): single linkage would need only one point
/// with a normal in between to run from face to face.
const SHARP: f32 = 0.5;

/// A segmented cloud.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Segmented {
    /// The clusters.
    pub segments: Segmentation,
    /// The one-rings (paper form; empty in the robust form, which uses the neighbour graph).
    pub rings: Neighbors,
    /// Positions after smoothing, where the noise called for it; else empty.
    pub smoothed: Vec<[f64; 3]>,
    /// How often the points were smoothed.
    pub rounds: usize,
    /// Steps with seconds.
    pub seconds: Vec<(&'static str, f64)>,
}

/// One-rings and the segmentation by their normals, as printed; fills the normals of the measure.
pub fn paper(
    points: &[[f64; 3]],
    resolution: Resolution,
    params: &SegmentParams,
    measure: &mut Measure,
) -> Segmented {
    let start = Instant::now();
    let nearest = all_nearest(points, params.k);
    let neighbors = start.elapsed().as_secs_f64();
    let (rings, normals) = one_rings(points, &nearest);
    let ringed = start.elapsed().as_secs_f64();
    let grow = |normals: &[[f32; 3]]| {
        Segmentation::grow(&rings, normals, params.angle_deg.or(|| ANGLE_DEG).to_radians(), 1, |_| false)
    };
    let mut segments = grow(&normals);
    let (mut normals, mut positions, mut rounds) = (normals, Vec::new(), 0);
    while rounds < ROUNDS && too_noisy(&segments, params.k) {
        positions = smoothed(if rounds == 0 { points } else { &positions }, &nearest);
        rounds += 1;
        normals = wide_normals(&positions, &rings, rounds + 1);
        segments = grow(&normals);
    }
    let segments = segments.take_apart(points, APART * resolution.spacing);
    let grown = start.elapsed().as_secs_f64();
    measure.normal = normals;
    measure.score =
        segments.label.iter().map(|&c| if segments.large[c as usize] { 0.0 } else { 1.0 }).collect();
    measure.density = vec![0.0; points.len()];
    let penalties = || Penalties { direction: Direction::Across, ..Default::default() };
    (measure.crease, measure.border) = (penalties(), penalties());
    let seconds = vec![
        ("neighbors", neighbors),
        ("rings and normals", ringed - neighbors),
        ("segments", grown - ringed),
    ];
    Segmented { segments, rings, smoothed: positions, rounds, seconds }
}

/// The segmentation by the normals of a measure, which keep to their side of a crease.
pub fn robust(
    points: &[[f64; 3]],
    graph: &Neighbors,
    resolution: Resolution,
    params: &SegmentParams,
    measure: &Measure,
) -> Segmented {
    let start = Instant::now();
    let sharp = |i: usize| measure.score[i] > SHARP;
    let radians = angle(params, resolution).to_radians();
    let segments = Segmentation::grow(graph, &measure.normal, radians, LEAST_FACE, sharp);
    let segments = absorb(segments, points, &measure.normal, graph);
    Segmented { segments, seconds: vec![("segments", start.elapsed().as_secs_f64())], ..Segmented::default() }
}

/// The segmentation's angle, degrees: the paper's 8, and up to twice that where noise tilts the normals.
pub fn angle(params: &SegmentParams, resolution: Resolution) -> f64 {
    params.angle_deg.or(|| match params.form {
        SegmentForm::Paper => ANGLE_DEG,
        SegmentForm::Robust => ANGLE_DEG * (1.0 + (2.0 * resolution.noise / resolution.spacing).min(1.0)),
    })
}

impl Segmented {
    /// What the noise changed, for the summary.
    pub fn note(&self, params: &SegmentParams, resolution: Resolution, hops: usize) -> Option<String> {
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
