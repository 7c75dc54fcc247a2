//! Thins rows: scan lines along which the sampling is far denser than across them.
//!
//! Where all nearest neighbours of a point lie in its own scan line, they do not show the surface between the lines, and every
//! line looks like a crease or a border. The points along it are then thinned, in canonical order, to half the distance between
//! the lines. Each point left out is represented by the kept one beside it.

use super::support::Plane;
use crate::math::vec3::{add_scaled, dot, norm, sub};
use crate::neighbors::{Index, Neighbors};
use rayon::prelude::*;

/// Ratio of the axes of a neighbourhood in its plane above which it is a piece of a row.
const ELONGATED: f32 = 3.0;
/// Number of neighbours among which a point of the next row is searched.
const SEARCHED: usize = 64;
/// Least distance of the next row from the line through the point along its own, spacings.
const BESIDE: f64 = 1.5;
/// Greatest distance of the next row, spacings: farther rows are another surface.
const FARTHEST: f64 = 24.0;
/// Distance between kept points, as a share of the distance between rows.
const STAY: f64 = 0.5;

/// `(N)` representative of each point: itself, or the kept point beside it where a row is thinned; and `(N)` whether each lies in
/// a row with another row beside it.
pub(super) fn thin(
    points: &[[f64; 3]],
    nearest: &Neighbors,
    planes: &[Plane],
    spacing: &[f32],
) -> (Vec<u32>, Vec<bool>) {
    let long: Vec<bool> = planes.par_iter().map(|p| p.elongation > ELONGATED).collect();
    let row = |&i: &u32| {
        let near = nearest.of(i as usize);
        2 * near.iter().filter(|&&j| long[j as usize]).count() > near.len()
    };
    let rows: Vec<u32> = (0..points.len() as u32).into_par_iter().filter(row).collect();
    let mut stands: Vec<u32> = (0..points.len() as u32).collect();
    if rows.is_empty() {
        return (stands, vec![false; points.len()]);
    }
    let index = Index::build(points);
    let gaps: Vec<f64> = rows
        .par_iter()
        .map_init(Vec::new, |found, &i| gap(points, &index, planes, spacing, i, found))
        .collect();
    let reach = smoothed(points.len(), nearest, &rows, &gaps);
    let mut found = Vec::new();
    for &i in &rows {
        if stands[i as usize] != i || reach[i as usize] == 0.0 {
            continue;
        }
        index.within(points[i as usize], STAY * f64::from(reach[i as usize]), &mut found);
        for j in found.iter().map(|f| f.index).filter(|&j| j > i && reach[j as usize] > 0.0) {
            if stands[j as usize] == j {
                stands[j as usize] = i;
            }
        }
    }
    (stands, reach.iter().map(|&r| r > 0.0).collect())
}

/// The distance from point `i` to the next row; zero if there is none.
fn gap(
    points: &[[f64; 3]],
    index: &Index,
    planes: &[Plane],
    spacing: &[f32],
    i: u32,
    found: &mut Vec<crate::neighbors::Found>,
) -> f64 {
    let i = i as usize;
    let (along, unit) = (planes[i].along.map(f64::from), f64::from(spacing[i]));
    index.nearest(points[i], SEARCHED, found);
    let beside = found.iter().map(|f| sub(points[f.index as usize], points[i])).find(|&d| {
        let across = norm(add_scaled(d, along, -dot(d, along)));
        across > BESIDE * unit && across > 0.7 * norm(d)
    });
    beside.map_or(0.0, norm).min(FARTHEST * unit)
}

/// `(N)` median of the gaps over the neighbours in rows; zero for points in no row.
fn smoothed(count: usize, nearest: &Neighbors, rows: &[u32], gaps: &[f64]) -> Vec<f32> {
    let mut own = vec![0.0_f32; count];
    rows.iter().zip(gaps).for_each(|(&i, &g)| own[i as usize] = g as f32);
    let median = |near: &mut Vec<f32>, &i: &u32| {
        near.clear();
        near.extend(nearest.of(i as usize).iter().chain([&i]).map(|&j| own[j as usize]).filter(|&g| g > 0.0));
        if near.is_empty() {
            return 0.0;
        }
        let middle = near.len() / 2;
        *near.select_nth_unstable_by(middle, f32::total_cmp).1
    };
    let medians: Vec<f32> = rows.par_iter().map_init(Vec::new, median).collect();
    let mut smoothed = vec![0.0; count];
    rows.iter().zip(medians).for_each(|(&i, m)| smoothed[i as usize] = m);
    smoothed
}

#[cfg(test)]
mod tests {
    use crate::neighbors::all_nearest;
    use crate::resolution::Resolution;
    use crate::surface::standing;

    /// Kept points of a plane of rows `gap` apart, the points of a row one apart.
    fn kept(gap: f64) -> f64 {
        let at = |k: i32| {
            [f64::from(k % 200) + 0.3 * f64::from(k * 37 % 11) / 11.0, gap * f64::from(k / 200), 0.0]
        };
        let points: Vec<[f64; 3]> = (0..4000).map(at).collect();
        let stands = standing(&points, &all_nearest(&points, 12), Resolution { spacing: 1.0, noise: 0.01 });
        assert!(
            stands.iter().all(|&s| stands.get(s as usize) == Some(&s)),
            "what stands for another stands for itself"
        );
        let stay = stands.iter().zip(0..).filter(|&(&s, i)| s == i).count();
        if stands.is_empty() { 1.0 } else { stay as f64 / stands.len() as f64 }
    }

    #[test]
    fn rows_are_thinned_to_half_their_distance_and_even_sampling_is_not() {
        assert_eq!(kept(1.0), 1.0);
        for gap in [6.0, 10.0] {
            let share = kept(gap);
            assert!(share < 2.6 / gap && share > 1.2 / gap, "gap {gap}: {share}");
        }
    }
}
