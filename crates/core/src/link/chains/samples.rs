//! Samples along lines, near enough to each other to stand for the lines in searches.

use crate::math::vec3::{add_scaled, distance, sub};
use crate::neighbors::Index;

/// Distance between samples, in spacings.
const STEP: f64 = 0.1;

/// Samples of segments.
pub(super) struct Samples(Index);

impl Samples {
    /// Samples of segments, each given by its ends and the spacing of the cloud there.
    pub(super) fn new(segments: impl Iterator<Item = ([f64; 3], [f64; 3], f64)>) -> Samples {
        let mut places = Vec::new();
        for (from, to, spacing) in segments {
            let steps = (distance(from, to) / (STEP * spacing)).ceil().max(1.0);
            places.extend((0..=steps as usize).map(|k| add_scaled(from, sub(to, from), k as f64 / steps)));
        }
        Samples(Index::build(&places))
    }

    /// Whether a sample lies within `reach` of `place`.
    pub(super) fn within(&self, place: [f64; 3], reach: f64) -> bool {
        let mut any = false;
        self.0.around(place, reach, |_| any = true);
        any
    }
}
