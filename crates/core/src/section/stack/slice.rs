//! The closed contours of one slice under a tree, for the nearest of them.

use super::profile::Profile;
use crate::math::trees::boxes::{Boxes, Extent};

/// Boxes and distances are as exact as their numbers: this share more is looked at.
const ROUNDING: f64 = 1e-9;

/// Profiles of one slice, solids and holes apart.
pub(super) struct Slice<'a> {
    pub profiles: &'a [Profile],
    /// For solids, and for holes, the profiles of that kind.
    kinds: [(Vec<&'a Profile>, Boxes<2>); 2],
}

impl<'a> Slice<'a> {
    pub(super) fn new(profiles: &'a [Profile]) -> Self {
        let kind = |hole: bool| {
            let own: Vec<&Profile> = profiles.iter().filter(|p| p.hole == hole).collect();
            let boxes = Boxes::new(own.iter().map(|p| Extent::of(p.outline.points().iter().copied())));
            (own, boxes)
        };
        Self { profiles, kinds: [false, true].map(kind) }
    }

    /// Distance of a point from the nearest outline of the kind; infinite without any.
    pub(super) fn off(&self, hole: bool, p: [f64; 2]) -> f64 {
        let (own, boxes) = &self.kinds[usize::from(hole)];
        let mut best = f64::INFINITY;
        boxes.near(p, best, |i| {
            best = best.min(own[i as usize].outline.off(p));
            best * best * (1.0 + ROUNDING)
        });
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::polyline::Polyline;

    /// A square of one at a place.
    fn square(x: f64, hole: bool) -> Profile {
        let corners = [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
        Profile {
            id: (0, 0),
            height: 0.0,
            outline: Polyline::new(&corners, true, 1.0),
            hole,
            area: 1.0,
            signed_area: 1.0,
            length: 4.0,
            centroid: [x + 0.5, 0.5],
            round: None,
            draft_deg: 0.0,
            steepest_deg: 0.0,
        }
    }

    #[test]
    fn the_nearest_of_many_outlines_is_found_without_looking_at_all() {
        // To look at each of 30,000 outlines for each of 60,000 points would take minutes.
        let count = 30_000;
        let profiles: Vec<Profile> = (0..count).map(|k| square(3.0 * f64::from(k), k % 2 == 1)).collect();
        let slice = Slice::new(&profiles);
        for k in 0..count {
            let x = 3.0 * f64::from(k);
            assert_eq!(slice.off(k % 2 == 1, [x + 0.5, 0.75]), 0.25);
            assert_eq!(slice.off(k % 2 == 0, [x + 0.5, 0.5]), 2.5);
        }
        assert_eq!(Slice::new(&profiles[..1]).off(true, [0.0; 2]), f64::INFINITY);
    }
}
