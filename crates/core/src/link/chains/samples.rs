//! Samples along lines, near enough to each other to stand for the lines in searches.

use crate::math::vec3::{add_scaled, distance, scale, sub};
use crate::neighbors::Index;

/// Distance between samples, in spacings.
const STEP: f64 = 0.1;

/// Samples with the unit directions of their lines.
pub(super) struct Samples {
    pub(super) places: Vec<[f64; 3]>,
    pub(super) along: Vec<[f64; 3]>,
    pub(super) index: Index,
}

impl Samples {
    /// Samples of segments, each given by its ends and the spacing of the cloud there.
    pub(super) fn new(segments: impl Iterator<Item = ([f64; 3], [f64; 3], f64)>) -> Samples {
        let (mut places, mut along) = (Vec::new(), Vec::new());
        for (from, to, spacing) in segments {
            let length = distance(from, to);
            let steps = (length / (STEP * spacing)).ceil().max(1.0);
            for k in 0..=steps as usize {
                places.push(add_scaled(from, sub(to, from), k as f64 / steps));
                along.push(scale(sub(to, from), 1.0 / length.max(f64::MIN_POSITIVE)));
            }
        }
        let index = Index::build(&places);
        Samples { places, along, index }
    }

    /// The sample nearest to `place` within `reach` that `accept` takes.
    pub(super) fn nearest(
        &self,
        place: [f64; 3],
        reach: f64,
        accept: impl Fn(usize) -> bool,
    ) -> Option<usize> {
        let mut best: Option<(f64, usize)> = None;
        self.index.around(place, reach, |f| {
            let found = (f.distance2, f.index as usize);
            let nearer = best.is_none_or(|b| found.0 < b.0 || (found.0 == b.0 && found.1 < b.1));
            if nearer && accept(found.1) {
                best = Some(found);
            }
        });
        best.map(|b| b.1)
    }
}
