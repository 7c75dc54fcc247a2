//! The slicing direction (section 2): as given, or sought among the axes of the faces or of the points ("a transformation
//! of the object that minimizes a target function, e.g. PCA").

use super::axis;
use crate::math::eigen3::{Eigen3, eigen3};
use crate::neighbors::Index;
use crate::params::SectionParams;
use crate::params::section::Axis;
use crate::section::frame::SliceFrame;
use crate::section::surface::spread::Spread;

/// Radians, about 10 degrees, up to which a principal axis snaps to one of the coordinates however little it is determined.
const MOST_OFF: f64 = 0.17;

/// The frame of an axis; automatic ones look at the faces, or at the principal axes of the points.
pub(crate) fn resolve(params: &SectionParams, points: &[[f64; 3]], index: &Index, noise: f64) -> SliceFrame {
    let axis = params.axis;
    let given = SliceFrame::along(axis);
    let faces =
        || if axis == Axis::Faces { axis::of_faces(points, index, noise, params.axis_share) } else { None };
    given
        .or_else(|| SliceFrame::along(Axis::Vector(faces().map_or_else(|| automatic(axis, points), settle))))
        .unwrap_or(SliceFrame { axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] })
}

fn automatic(axis: Axis, points: &[[f64; 3]]) -> [f64; 3] {
    let Some(&origin) = points.first() else { return [0.0, 0.0, 1.0] };
    let spread = Spread::of(points.iter().map(|&p| (p, 1.0)), origin);
    let Eigen3 { values, vectors } = eigen3(&spread.tensor);
    let pick = match axis {
        Axis::Thinnest => thinnest(points, &vectors),
        _ => 2,
    };
    settle(axis::snapped(vectors[pick], uncertainty(values, pick, points.len())))
}

/// How far a principal axis may be off, radians: three standard errors (Anderson, "Asymptotic theory for principal component analysis",
/// 1963) for so many independent points.
fn uncertainty(values: [f64; 3], pick: usize, count: usize) -> f64 {
    let turn = |other: usize| {
        let gap = (values[pick] - values[other]).abs();
        (values[pick] * values[other] / count.max(1) as f64).max(0.0).sqrt() / gap.max(f64::MIN_POSITIVE)
    };
    let most = (0..3).filter(|&k| k != pick).map(turn).fold(0.0, f64::max);
    // Beyond that the axis is not determined at all.
    (3.0 * most).min(MOST_OFF)
}

/// The sign for which the largest component is positive; components that are rounding are 0, so that a cloud that
/// lies square to the coordinates is cut square to them.
fn settle(v: [f64; 3]) -> [f64; 3] {
    let clean = v.map(|x| if x.abs() < 1e-9 { 0.0 } else { x });
    let largest = clean.iter().fold(0.0f64, |m, x| if x.abs() > m.abs() + 1e-9 { *x } else { m });
    if largest < 0.0 { clean.map(|x| -x) } else { clean }
}

/// The index of the axis for which slices project thinnest: a slab's points, projected, fill the fewest cells of a grid as fine
/// as the slabs are thick.
fn thinnest(points: &[[f64; 3]], axes: &[[f64; 3]; 3]) -> usize {
    let filled = |axis: &[f64; 3]| {
        let frame = SliceFrame::along(Axis::Vector(*axis))?;
        let cell = extent(points, &frame) / 64.0;
        let mut cells: Vec<[i64; 3]> =
            points.iter().map(|&p| frame.coordinates(p).map(|x| (x / cell).floor() as i64)).collect();
        cells.sort_unstable();
        cells.dedup();
        Some(cells.len())
    };
    let counts: Vec<usize> = axes.iter().map(|a| filled(a).unwrap_or(usize::MAX)).collect();
    (0..3).min_by_key(|&k| (counts[k], 2 - k)).unwrap_or(2)
}

fn extent(points: &[[f64; 3]], frame: &SliceFrame) -> f64 {
    let bounds = |(low, high): (f64, f64), p: &[f64; 3]| {
        let z = frame.coordinates(*p)[2];
        (low.min(z), high.max(z))
    };
    let (low, high) = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), bounds);
    (high - low).max(f64::MIN_POSITIVE)
}
