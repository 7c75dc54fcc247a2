//! The result of a search: a point and its distance.

/// A point found by a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Squared distance from the query.
    pub distance2: f64,
    /// Index of the point.
    pub index: u32,
}

impl Found {
    /// Order by distance, then by index.
    #[inline]
    pub(super) fn order(&self, other: &Found) -> std::cmp::Ordering {
        self.distance2.total_cmp(&other.distance2).then(self.index.cmp(&other.index))
    }
}
