//! Thinning of points in excess: where the sampling is so dense that neighbours do not show the surface.
//!
//! Along a scan line far from the next one, all neighbours of a point lie in the line; such points are thinned to half the
//! distance between the lines. Right below a scanner, or where stations overlap, the spacing is below the noise, and normals
//! fitted to neighbours are arbitrary; such points are thinned to a spacing of a few standard deviations of the noise. Points
//! are taken in canonical order, and each point left out is represented by the kept one beside it.

use crate::neighbors::Index;
use crate::resolution::Resolution;

/// Distance between kept points in rows, as a share of the distance between the rows.
const IN_ROWS: f32 = 0.5;
/// Spacing below which noise blurs the surface, standard deviations of the noise.
const NOISY: f64 = 6.0;
/// Share of that spacing below which a place is thinned; and the least distance of kept points, as random points at this
/// distance have about that spacing.
const DENSE: f64 = 0.7;

/// `(N)` distance between kept points at each point; zero where nothing is thinned. `gaps` is the distance of the rows at each
/// point, zero outside of rows; `spacing` is the spacing at each point.
pub(super) fn apart(gaps: &[f32], spacing: &[f32], mean: Resolution) -> Vec<f64> {
    // No place is made coarser than the cloud as a whole, so that a noisy cloud stays as dense as it is.
    let dense = DENSE * (NOISY * mean.noise).min(mean.spacing);
    let apart = |i: usize| match gaps[i] {
        gap if gap > 0.0 => f64::from(IN_ROWS * gap),
        _ if f64::from(spacing[i]) < dense => dense,
        _ => 0.0,
    };
    (0..gaps.len()).map(apart).collect()
}

/// `(N)` representative of each point: itself, or the kept point beside it where a place is thinned. `apart` is the distance
/// between kept points.
pub(super) fn thin(points: &[[f64; 3]], apart: &[f64]) -> Vec<u32> {
    let mut stands: Vec<u32> = (0..points.len() as u32).collect();
    if apart.iter().all(|&d| d == 0.0) {
        return stands;
    }
    let index = Index::build(points);
    let mut found = Vec::new();
    for i in 0..points.len() {
        if stands[i] as usize != i || apart[i] == 0.0 {
            continue;
        }
        index.within(points[i], apart[i], &mut found);
        for j in found.iter().map(|f| f.index as usize).filter(|&j| j > i && apart[j] > 0.0) {
            if stands[j] as usize == j {
                stands[j] = i as u32;
            }
        }
    }
    stands
}

#[cfg(test)]
mod tests {
    use crate::neighbors::all_nearest;
    use crate::resolution::Resolution;
    use crate::surface::sort;

    /// Kept points of a plane of rows `gap` apart, the points of a row one apart.
    fn kept(gap: f64) -> f64 {
        let at = |k: i32| {
            [f64::from(k % 200) + 0.3 * f64::from(k * 37 % 11) / 11.0, gap * f64::from(k / 200), 0.0]
        };
        let points: Vec<[f64; 3]> = (0..4000).map(at).collect();
        let mean = Resolution { spacing: 1.0, noise: 0.01 };
        let stands = sort(&points, &all_nearest(&points, 12), mean).stands;
        assert!(
            stands.iter().all(|&s| stands.get(s as usize) == Some(&s)),
            "what stands for another stands for itself"
        );
        let stay = stands.iter().zip(0..).filter(|&(&s, i)| s == i).count();
        if stands.is_empty() { 1.0 } else { stay as f64 / stands.len() as f64 }
    }

    /// So this stage is not local: see `docs/scale.md`.
    #[test]
    fn which_points_of_a_row_stay_depends_on_its_first() {
        let row: Vec<[f64; 3]> = (0..4).map(|k| [0.6 * f64::from(k), 0.0, 0.0]).collect();
        assert_eq!(super::thin(&row, &[1.0; 4]), [0, 0, 2, 2]);
        assert_eq!(super::thin(&row[1..], &[1.0; 3]), [0, 0, 2]);
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
