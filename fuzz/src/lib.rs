//! The common body of the fuzz targets: read an input in every way, and check the promises of the readers.

mod archive;
mod framed;
mod pipeline;
mod promise;

pub use archive::with_entry_checksums;
pub use framed::{E57, Gltf, Npz, Parquet};
pub use pipeline::round_trip;
pub use promise::{reads, with_checksums};
