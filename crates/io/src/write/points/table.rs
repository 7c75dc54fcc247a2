//! Points with their classes, as the writers take them.

use crate::read::LasFrame;
use lineament::Cloud;

/// Points with their classes and scores.
#[derive(Clone, Copy, Debug)]
pub struct PointTable<'a> {
    /// The points as they were read.
    pub cloud: &'a Cloud,
    /// `(N)` 0 smooth, 1 crease, 2 border, 3 corner, 4 clutter; or nothing, and then no column either.
    pub classes: &'a [u8],
    /// `(N)` scores of the detector, or nothing.
    pub scores: &'a [f32],
    /// How a LAS input stored its coordinates, for LAS outputs: `Scan::las`.
    pub las: Option<&'a LasFrame>,
}

impl PointTable<'_> {
    /// Whether there is a column of classes. Of no points there is one.
    pub(super) fn classified(&self) -> bool {
        !self.classes.is_empty() || self.cloud.is_empty()
    }
}
