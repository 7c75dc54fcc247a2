//! Rows: places sampled far more densely along the scan lines than across them.
//!
//! Where all nearest neighbours of a point lie in its own scan line, they do not show the surface between the lines, and every
//! line looks like a crease or a border.

use super::support::{Plane, fitted};
use crate::math::tensor::ellipsoid;
use crate::math::vec3::{add_scaled, dot, norm, sub};
use crate::neighbors::{Found, Index, Neighbors};
use crate::parallel;

/// Ratio of the axes of a neighbourhood in its plane above which it is a piece of a row.
const ELONGATED: f32 = 3.0;
/// Number of neighbours among which a point of the next row is searched.
const SEARCHED: usize = 64;
/// Least distance of the next row from the line through the point along its own, spacings.
const BESIDE: f64 = 1.5;
/// Greatest distance of the next row, spacings: the surface between rows farther apart is unknown.
pub(super) const FARTHEST: f64 = 12.0;

/// `(N)` distance from each point to the next row, smoothed; zero for points outside of rows, and in rows without another beside
/// them.
pub(super) fn gaps(points: &[[f64; 3]], nearest: &Neighbors, planes: &[Plane], spacing: &[f32]) -> Vec<f32> {
    let rows = in_rows(nearest, planes);
    if rows.is_empty() {
        return vec![0.0; points.len()];
    }
    let index = Index::build(points);
    let gaps = parallel::map_with(rows.len(), parallel::SLOW, |found, r| {
        gap(points, &index, nearest, spacing, rows[r], found)
    });
    smoothed(points.len(), nearest, &rows, &gaps)
}

/// The points in rows, ascending.
pub(super) fn in_rows(nearest: &Neighbors, planes: &[Plane]) -> Vec<u32> {
    let long = parallel::map(planes.len(), parallel::QUICK, |i| planes[i].elongation > ELONGATED);
    let row = |i: usize| {
        let near = nearest.of(i);
        2 * near.iter().filter(|&&j| long[j as usize]).count() > near.len()
    };
    parallel::flat_map(nearest.len(), parallel::QUICK, |i, rows| rows.extend(row(i).then_some(i as u32)))
}

/// The number of points in rows, and the medians of the ratio of their distances across and along the rows, and of the distance
/// across. `raw` is the mean distance to the six nearest: three on either side in the row, on average two steps away.
pub(super) fn summary(gaps: &[f32], raw: &[f32]) -> (usize, f64, f64) {
    let in_rows = || gaps.iter().zip(raw).filter(|&(&gap, _)| gap > 0.0);
    let median = |mut values: Vec<f32>| {
        let middle = values.len() / 2;
        if values.is_empty() {
            0.0
        } else {
            f64::from(*values.select_nth_unstable_by(middle, f32::total_cmp).1)
        }
    };
    let ratio = median(in_rows().map(|(gap, raw)| 2.0 * gap / raw).collect());
    (in_rows().count(), ratio, median(in_rows().map(|(&gap, _)| gap).collect()))
}

/// The distance from point `i` to the next row; zero if there is none.
fn gap(
    points: &[[f64; 3]],
    index: &Index,
    nearest: &Neighbors,
    spacing: &[f32],
    i: u32,
    found: &mut Vec<Found>,
) -> f64 {
    let i = i as usize;
    let along = ellipsoid(points, i, fitted(nearest, i)).axes.vectors[2];
    let unit = f64::from(spacing[i]);
    index.nearest(points[i], SEARCHED, found);
    let beside = found.iter().map(|f| sub(points[f.index as usize], points[i])).find(|&d| {
        let across = norm(add_scaled(d, along, -dot(d, along)));
        across > BESIDE * unit && across > 0.7 * norm(d)
    });
    beside.map(norm).filter(|&gap| gap <= FARTHEST * unit).unwrap_or(0.0)
}

/// `(N)` median of the gaps over the neighbours in rows; zero for points in no row.
fn smoothed(count: usize, nearest: &Neighbors, rows: &[u32], gaps: &[f64]) -> Vec<f32> {
    let mut own = vec![0.0_f32; count];
    rows.iter().zip(gaps).for_each(|(&i, &g)| own[i as usize] = g as f32);
    let medians = parallel::map_with(rows.len(), parallel::SLOW, |near: &mut Vec<f32>, r| {
        let i = rows[r];
        near.clear();
        near.extend(nearest.of(i as usize).iter().chain([&i]).map(|&j| own[j as usize]).filter(|&g| g > 0.0));
        if near.is_empty() {
            return 0.0;
        }
        let middle = near.len() / 2;
        *near.select_nth_unstable_by(middle, f32::total_cmp).1
    });
    let mut smoothed = vec![0.0; count];
    rows.iter().zip(medians).for_each(|(&i, m)| smoothed[i as usize] = m);
    smoothed
}
