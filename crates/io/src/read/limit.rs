//! The bound on what a compressed input may take in memory.

use super::ReadOptions;
use crate::error::Error;
use crate::source::Source;

/// Bytes that any input may take.
const BASE: u64 = 64 << 20;
/// Bytes that every byte of an input may take.
const FACTOR: u64 = 8;

/// Refuses `rows` rows of `bytes` bytes each in memory if that is beyond the bound.
pub(super) fn check(source: &Source, options: &ReadOptions, rows: u64, bytes: usize) -> Result<(), Error> {
    let bound = options.memory.unwrap_or(BASE.saturating_add(source.size().saturating_mul(FACTOR)));
    let needed = rows.saturating_mul(bytes as u64);
    if needed <= bound {
        return Ok(());
    }
    let found = format!("{rows} points unpack to {needed} bytes, beyond the bound of {bound}");
    Err(source.malformed(found, "the input may be damaged; if it is whole, raise the bound with --memory"))
}
