//! The bound on what a compressed input may take in memory.

use super::ReadOptions;
use crate::error::{Error, Place};
use crate::source::Source;

/// Bytes that any input may take.
const BASE: u64 = 64 << 20;
/// Bytes that every byte of an input may take.
const FACTOR: u64 = 8;

/// Bytes that what is unpacked may take.
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
    let found = format!("{rows} points unpack to {needed} bytes, beyond the bound of {bound}");
    let advice = "the input may be damaged; if it is whole, raise the bound with --memory";
    // The claim stands in a header; where reading has got to says nothing.
    Err(source.fault(Place::Byte(0), found, advice))
}
