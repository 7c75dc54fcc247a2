//! The first-order segmentation as printed (Demarsin et al. 2007, section 2.2): one-rings, their normals, region growing.

use super::segmentation::Segmentation;
use super::segmented::{Segmented, angle};
use super::smoothing::{ROUNDS, smoothed, too_noisy, wide_normals};
use crate::neighbors::{all_nearest, delaunay_ring::one_rings};
use crate::params::SegmentParams;
use crate::resolution::Resolution;
use std::time::Instant;

/// Width above which small clusters are taken apart, spacings.
const WIDE_CLUSTER: f64 = 2.5;

/// The segmentation with its one-rings, and their normals.
pub(crate) fn as_printed(
    points: &[[f64; 3]],
    resolution: Resolution,
    params: &SegmentParams,
) -> (Segmented, Vec<[f32; 3]>) {
    let start = Instant::now();
    let nearest = all_nearest(points, params.k);
    let neighbors = start.elapsed().as_secs_f64();
    let (rings, mut normals) = one_rings(points, &nearest);
    let ringed = start.elapsed().as_secs_f64();
    let radians = angle(params, resolution).to_radians();
    let grow = |normals: &[[f32; 3]]| Segmentation::grow(&rings, normals, radians, 1, |_| false);
    let mut segments = grow(&normals);
    let (mut positions, mut rounds) = (Vec::new(), 0);
    while rounds < ROUNDS && too_noisy(&segments, params.k) {
        positions = smoothed(if rounds == 0 { points } else { &positions }, &nearest);
        rounds += 1;
        normals = wide_normals(&positions, &rings, rounds + 1);
        segments = grow(&normals);
    }
    let segments = segments.take_apart(points, WIDE_CLUSTER * resolution.spacing);
    let grown = start.elapsed().as_secs_f64();
    let seconds = vec![
        ("neighbors", neighbors),
        ("rings and normals", ringed - neighbors),
        ("segments", grown - ringed),
    ];
    (Segmented { segments, rings, smoothed: positions, rounds, seconds }, normals)
}
