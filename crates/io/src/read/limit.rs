//! The limit on the memory of a compressed input once it is unpacked.

use super::ReadOptions;
use crate::error::{Error, Place};
use crate::source::Source;

/// Bytes that any input may take.
const BASE: u64 = 64 << 20;
/// Bytes that every byte of an input may take.
pub(super) const FACTOR: u64 = 8;

/// Limit on the bytes of the unpacked points.
pub(super) fn bound(source: &Source, options: &ReadOptions) -> u64 {
    options.memory.unwrap_or(BASE.saturating_add(source.size().saturating_mul(FACTOR)))
}

/// Refuses `rows` rows of `bytes` bytes each in memory if that is beyond the bound.
pub(super) fn check(source: &Source, options: &ReadOptions, rows: u64, bytes: usize) -> Result<(), Error> {
    let bound = bound(source, options);
    let needed = rows.saturating_mul(bytes as u64);
    if needed <= bound {
        return Ok(());
    }
    // The claim stands in a header; the place of reading means nothing.
    Err(beyond(source, options, 0, &format!("{rows} points that unpack to {needed} bytes")))
}

/// The error for something at a place that takes more memory than the bound, which it names.
pub(super) fn beyond(source: &Source, options: &ReadOptions, at: u64, what: &str) -> Error {
    let found = format!("{what}, beyond the bound of {}", bound(source, options));
    let advice = "the input may be damaged; if it is whole, raise the bound with --memory";
    source.fault(Place::Byte(at), found, advice)
}
