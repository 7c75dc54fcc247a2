//! How far the points of a cloud speak for the surface between them.

use crate::math::quantile::quantile;
use crate::neighbors::{Found, Index};
use std::cell::RefCell;
use std::collections::HashMap;

/// Neighbours whose mean distance is a spacing.
const NEIGHBORS: usize = 6;
/// Points near a place, whose median spacing is that of the place.
const POINTS: usize = 8;
/// Greatest distance of a place from the nearest point, spacings.
const REACH: f64 = 2.0;
/// A place is among its points, whatever their spacings, where the farthest lies within so many spacings of the whole cloud and the
/// nearest within this share of it.
const AMONG: (f64, f64) = (3.0, 0.4);

/// The points of a cloud, and the spacings looked at so far: places of a contour follow one another and share their points.
pub(super) struct Reach<'a> {
    index: &'a Index,
    positions: &'a [[f64; 3]],
    /// Median spacing of the cloud.
    typical: f64,
    spacings: RefCell<HashMap<u32, f64>>,
}

impl<'a> Reach<'a> {
    pub(super) fn new(index: &'a Index, positions: &'a [[f64; 3]], typical: f64) -> Self {
        Self { index, positions, typical, spacings: RefCell::default() }
    }

    /// Whether a point lies within two spacings of a place, the spacing being that of the points nearest to it.
    pub(super) fn covers(&self, place: [f64; 3]) -> bool {
        let mut near = Vec::with_capacity(POINTS);
        self.index.nearest(place, POINTS, &mut near);
        let (Some(first), Some(last)) = (near.first(), near.last()) else { return false };
        let (gap, farthest) = (first.distance2.sqrt(), last.distance2.sqrt());
        if farthest <= AMONG.0 * self.typical && gap <= AMONG.1 * farthest {
            return true;
        }
        let mut known = self.spacings.borrow_mut();
        let spacing = |f: &Found| *known.entry(f.index).or_insert_with(|| self.spacing(f.index));
        let mut spacings: Vec<f64> = near.iter().map(spacing).collect();
        gap <= REACH * quantile(&mut spacings, 0.5)
    }

    fn spacing(&self, point: u32) -> f64 {
        let (at, mut around) = (self.positions[point as usize], Vec::with_capacity(NEIGHBORS + 1));
        self.index.nearest(at, NEIGHBORS + 1, &mut around);
        around.iter().map(|f| f.distance2.sqrt()).sum::<f64>() / NEIGHBORS as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_beside_the_points_are_reached_and_those_in_a_gap_are_not() {
        let row = |k: usize| (0..40).map(move |i| [i as f64, if k < 10 { k } else { k + 7 } as f64, 0.0]);
        let points: Vec<[f64; 3]> = (0..20).flat_map(row).collect();
        let index = Index::build(&points);
        let reached = |y: f64| Reach::new(&index, &points, 1.0).covers([20.0, y, 0.0]);
        // The rows end at 9 and begin again at 17; the mean distance of six neighbours is 1.3 steps there.
        assert!(reached(4.4) && reached(11.4) && reached(14.6));
        assert!(!reached(11.8) && !reached(13.0) && !reached(14.2));
    }
}
