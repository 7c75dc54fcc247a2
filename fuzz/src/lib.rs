//! What the fuzz targets do with an input: read it in every way, and hold the readers to their promises.

mod archive;
mod pipeline;
mod promise;

pub use archive::with_entry_checksums;
pub use pipeline::round_trip;
pub use promise::{reads, with_checksums};
