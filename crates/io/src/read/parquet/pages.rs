//! The pages of a Parquet column, walked over before the decoder sees them: it takes memory for what their headers
//! claim. Headers are Thrift structures in the compact protocol.

use super::page::Page;
use super::unpack;
use crate::error::{Error, Place};
use crate::read::{ReadOptions, limit};
use crate::source::{Shared, Source};
use ::parquet::basic::Compression;
use ::parquet::file::metadata::ColumnChunkMetaData;

/// Bytes of a header beyond which it is not read.
const MAX_HEADER: u64 = 1 << 16;
/// Structures inside each other beyond which a header is damaged.
const DEPTH: u8 = 12;
/// Stands for the field that a structure is where nothing is asked of it.
const DEEP: i16 = i16::MIN;
/// The least bytes of a value in a dictionary of numbers.
const LEAST_VALUE: i64 = 4;

/// Checks every page of a column against the bytes that are there, and what it unpacks to against the `room` in memory.
pub(super) fn check(
    source: &Source,
    options: &ReadOptions,
    shared: &Shared,
    column: &ColumnChunkMetaData,
    room: u64,
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
        let start = shared.at(at, (end - at).min(MAX_HEADER) as usize).map_err(|e| source.io(e))?;
        let Some((page, header)) = page(&start) else { return fail(at, "a page without a header".into()) };
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
        if needed > room {
            return Err(limit::beyond(source, options, at, &format!("a page of {unpacked} bytes")));
        }
        if !unpack::ends_in_time(shared, codec, &page, body).map_err(|e| source.io(e))? {
            return fail(at, format!("a page that does not unpack to {unpacked} bytes by {codec}"));
        }
        // The bytes of a dictionary and its values stay for the whole column.
        held += if page.dictionary > 0 { 2 * unpacked } else { 0 };
        at = next;
    }
    Ok(())
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

/// Whether bytes begin with a whole structure, in which everything that is counted takes bytes.
pub(super) fn is_structure(bytes: &[u8]) -> bool {
    Thrift(bytes).structure(0, 0, &mut |_, _, _| {}).is_some()
}

/// What is left of a structure.
struct Thrift<'a>(&'a [u8]);

impl Thrift<'_> {
    fn byte(&mut self) -> Option<u8> {
        let (&byte, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(byte)
    }

    fn skip(&mut self, count: u64) -> Option<()> {
        self.0 = self.0.get(usize::try_from(count).ok()?..)?;
        Some(())
    }

    /// An unsigned number, seven bits a byte.
    fn varint(&mut self) -> Option<u64> {
        let mut value = 0;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            value |= u64::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                return Some(value);
            }
        }
        None
    }

    /// A signed number: zigzag.
    fn integer(&mut self) -> Option<i64> {
        let value = self.varint()?;
        Some((value >> 1) as i64 ^ -((value & 1) as i64))
    }

    /// Walks over a structure, which is field `outer` of the one around it, handing out its whole numbers and
    /// booleans.
    fn structure(&mut self, depth: u8, outer: i16, found: &mut dyn FnMut(i16, i16, i64)) -> Option<()> {
        let mut id: i16 = 0;
        loop {
            let head = self.byte()?;
            if head == 0 {
                return Some(());
            }
            id = match head >> 4 {
                0 => i16::try_from(self.integer()?).ok()?,
                delta => id.checked_add(delta.into())?,
            };
            match head & 0xf {
                // Booleans: the type is the value.
                kind @ (1 | 2) => found(outer, id, i64::from(kind == 1)),
                4..=6 => found(outer, id, self.integer()?),
                kind => self.value(kind, depth, id, found)?,
            }
        }
    }

    /// Walks over a value of any type.
    fn value(&mut self, kind: u8, depth: u8, id: i16, found: &mut dyn FnMut(i16, i16, i64)) -> Option<()> {
        match kind {
            1..=3 => self.skip(1),
            4..=6 => self.varint().map(|_| ()),
            7 => self.skip(8),
            8 => {
                let length = self.varint()?;
                self.skip(length)
            }
            9 | 10 => {
                let head = self.byte()?;
                let count = if head >> 4 == 15 { self.varint()? } else { u64::from(head >> 4) };
                // The format has no list of booleans, and the decoder passes over any number of them in no bytes.
                if matches!(head & 0xf, 1 | 2) && count > 0 {
                    return None;
                }
                (0..count).try_for_each(|_| self.value(head & 0xf, depth.checked_add(1)?, DEEP, found))
            }
            // Deeper structures (statistics) have fields of their own under the same numbers.
            12 if depth < DEPTH => self.structure(depth + 1, if depth == 0 { id } else { DEEP }, found),
            _ => None,
        }
    }
}
