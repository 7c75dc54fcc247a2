//! Lists of neighbours, and graphs, in compressed rows.

/// One list of point indices for each point, in compressed rows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Neighbors {
    /// `(N + 1)` beginning of each list in `indices`, and last the length of `indices`.
    pub offsets: Vec<u64>,
    /// All lists, one after the other.
    pub indices: Vec<u32>,
}

impl Neighbors {
    /// The list of point `i`.
    ///
    /// # Panics
    /// If there is no such point.
    #[inline]
    pub fn of(&self, i: usize) -> &[u32] {
        &self.indices[self.offsets[i] as usize..self.offsets[i + 1] as usize]
    }

    /// The number of points.
    pub fn len(&self) -> usize {
        self.offsets.len().saturating_sub(1)
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
