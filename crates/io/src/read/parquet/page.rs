//! The header of a Parquet page.

/// Sizes and counts as claimed.
#[derive(Default)]
pub(super) struct Page {
    pub unpacked: i64,
    pub packed: i64,
    /// Values of a dictionary.
    pub dictionary: i64,
    /// Bytes of levels, which stand in front unpacked, in pages of the second version.
    pub levels: [i64; 2],
    /// Whether a page of the second version is not packed at all.
    pub plain: bool,
}
