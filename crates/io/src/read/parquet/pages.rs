//! The pages of a Parquet column, checked before the decoder sees them, as it takes memory by the claims of their headers and
//! time by their unpacked size.

use super::page::Page;
use super::thrift::Thrift;
use super::unpack;
use crate::error::{Error, Place};
use crate::read::{ReadOptions, limit};
use crate::source::{Shared, Source};
use ::parquet::basic::Compression;
use ::parquet::file::metadata::ColumnChunkMetaData;
use std::io;

/// Bytes of a header beyond which it is not read.
const MAX_HEADER: u64 = 1 << 16;
/// Bytes of a header that are looked at first: most are no longer.
const USUAL_HEADER: u64 = 1 << 9;
/// Bytes that a page counts for beside those it unpacks to, for the time that the decoder takes to begin one.
const PAGE: u64 = 1 << 10;
/// The least bytes of a value in a dictionary of numbers.
const LEAST_VALUE: i64 = 4;

/// Limits of the unpacked size of pages: of each in memory, and of all together, since row groups may share their pages.
pub(super) struct Room {
    pub memory: u64,
    pub total: u64,
}

impl Room {
    /// Takes a page from what all of them may unpack to.
    fn take(&mut self, unpacked: u64) -> Result<(), String> {
        let rest = self.total.checked_sub(unpacked.saturating_add(PAGE));
        self.total = rest.ok_or_else(|| {
            format!("a page of {unpacked} bytes, with which the pages unpack to more than twice that")
        })?;
        Ok(())
    }
}

/// Checks every page of a column against the bytes that are there, and its unpacked size against the `room`.
pub(super) fn check(
    source: &Source,
    options: &ReadOptions,
    shared: &Shared,
    column: &ColumnChunkMetaData,
    room: &mut Room,
) -> Result<(), Error> {
    let codec = column.compression();
    if codec == Compression::LZO {
        let found = format!("column `{}` packed by LZO", column.column_descr().name());
        return Err(source.fault(Place::Byte(0), found, "write it with Zstandard or Snappy"));
    }
    let (mut at, length) = column.byte_range();
    let fail = |at: u64, found: String| {
        Err(source.fault(Place::Byte(at), found, "the file is cut or damaged; get it anew"))
    };
    let Some(end) = at.checked_add(length).filter(|&end| end <= shared.length()) else {
        return fail(at, format!("a column of {length} bytes"));
    };
    let mut held = 0;
    while at < end {
        let Some((page, header)) = header(shared, at, end).map_err(|e| source.io(e))? else {
            return fail(at, "a page without a header".into());
        };
        let (Ok(packed), Ok(unpacked)) = (u64::try_from(page.packed), u64::try_from(page.unpacked)) else {
            return fail(at, format!("a page of {} bytes", page.packed));
        };
        let body = at + header as u64;
        let Some(next) = body.checked_add(packed).filter(|&next| next <= end) else {
            return fail(at, format!("a page of {packed} bytes"));
        };
        if page.dictionary.saturating_mul(LEAST_VALUE) > page.unpacked {
            return fail(at, format!("a dictionary of {} values in {unpacked} bytes", page.dictionary));
        }
        let needed = packed.saturating_add(unpacked).saturating_add(held);
        if needed > room.memory {
            return Err(limit::beyond(source, options, at, &format!("a page of {unpacked} bytes")));
        }
        room.take(unpacked).map_err(|what| limit::beyond(source, options, at, &what))?;
        if !unpack::ends_in_time(shared, codec, &page, body).map_err(|e| source.io(e))? {
            return fail(at, format!("a page that does not unpack to {unpacked} bytes by {codec}"));
        }
        // The bytes of a dictionary and its values stay for the whole column.
        held += if page.dictionary > 0 { 2 * unpacked } else { 0 };
        at = next;
    }
    Ok(())
}

/// The header at a place, and its bytes; `None` if there is none before `end`.
fn header(shared: &Shared, at: u64, end: u64) -> io::Result<Option<(Page, usize)>> {
    for most in [USUAL_HEADER, MAX_HEADER] {
        let found = page(&shared.at(at, (end - at).min(most) as usize)?);
        if found.is_some() {
            return Ok(found);
        }
    }
    Ok(None)
}

/// A header, and its bytes.
fn page(bytes: &[u8]) -> Option<(Page, usize)> {
    let mut page = Page::default();
    let mut thrift = Thrift(bytes);
    thrift.structure(0, 0, &mut |outer, id, value| match (outer, id) {
        (0, 2) => page.unpacked = value,
        (0, 3) => page.packed = value,
        (7, 1) => page.dictionary = value,
        (8, 5) => page.levels[0] = value,
        (8, 6) => page.levels[1] = value,
        (8, 7) => page.plain = value == 0,
        _ => {}
    })?;
    Some((page, bytes.len() - thrift.0.len()))
}
