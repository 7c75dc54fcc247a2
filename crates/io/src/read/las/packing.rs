//! How the records of a LAZ file are packed.

use laz::{DecompressionSelection, LazItem};

/// How the records are packed.
pub(super) struct Packing {
    pub items: Vec<LazItem>,
    pub layered: bool,
    /// Layers of a layered chunk.
    pub layers: usize,
    /// Bytes of a record.
    pub record: usize,
    /// The layers to unpack: without attributes only coordinates.
    pub selection: DecompressionSelection,
}
