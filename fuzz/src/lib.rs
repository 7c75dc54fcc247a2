//! What the fuzz targets do with an input: read it in every way, and hold the readers to their promises.

mod pipeline;
mod promise;

pub use pipeline::round_trip;
pub use promise::{reads, with_checksums};
