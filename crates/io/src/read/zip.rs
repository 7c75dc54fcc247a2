//! The part of the ZIP format (APPNOTE 6.3) that NPZ files need: entries that are stored or deflated, ZIP64 where
//! sizes ask for it.

use crate::columns::{Endian, Number};
use crate::error::{Error, Place};
use crate::source::{Shared, Source, Window};
use flate2::read::DeflateDecoder;
use std::io::{self, BufReader, Read, Take};

/// First bytes of the parts of an archive.
pub(crate) const LOCAL: &[u8] = b"PK\x03\x04";
pub(crate) const CENTRAL: &[u8] = b"PK\x01\x02";
pub(crate) const END: &[u8] = b"PK\x05\x06";
pub(crate) const END_64: &[u8] = b"PK\x06\x06";
pub(crate) const LOCATOR: &[u8] = b"PK\x06\x07";
/// Bytes before the name of an entry.
const HEAD: u64 = 30;
/// Bytes of an end record, and the most that a comment adds.
const END_BYTES: u64 = 22;
const COMMENT: u64 = 65_535;

/// A file in the archive.
#[derive(Debug)]
pub(crate) struct Entry {
    pub name: String,
    /// Bytes unpacked, as stated.
    pub bytes: u64,
    packed: u64,
    method: u16,
    checksum: u32,
    at: u64,
}

/// The number at a place; 0 if the bytes end before.
fn number<T: Number>(bytes: &[u8], at: usize) -> T {
    T::from_bytes(bytes.get(at..).unwrap_or(&[]), Endian::Little)
}

fn damaged(source: &Source, place: u64, found: impl Into<String>) -> Error {
    source.fault(Place::Byte(place), found, "the archive is cut or damaged; get it anew")
}

/// All entries, by the central directory.
pub(crate) fn entries(source: &Source, archive: &Shared) -> Result<Vec<Entry>, Error> {
    let (start, size) = directory(source, archive)?;
    let directory = archive.at(start, size as usize).map_err(|e| source.io(e))?;
    let mut entries = Vec::new();
    let mut rest = directory.as_slice();
    while rest.starts_with(CENTRAL) && rest.len() >= 46 {
        let [name, extra, comment] = [28, 30, 32].map(|at| usize::from(number::<u16>(rest, at)));
        let end = 46 + name + extra + comment;
        if rest.len() < end {
            return Err(damaged(source, start, "a directory that ends in an entry"));
        }
        entries.push(entry(source, start, &rest[..46 + name + extra], name)?);
        rest = &rest[end..];
    }
    if entries.is_empty() || !rest.is_empty() {
        return Err(damaged(
            source,
            start,
            format!("a directory with {} bytes that are no entry", rest.len()),
        ));
    }
    Ok(entries)
}

/// The offset of the central directory, and its length in bytes.
fn directory(source: &Source, archive: &Shared) -> Result<(u64, u64), Error> {
    let length = archive.length();
    let tail_at = length.saturating_sub(END_BYTES + COMMENT);
    let tail = archive.at(tail_at, (length - tail_at) as usize).map_err(|e| source.io(e))?;
    let found = memchr::memmem::rfind(&tail, END).filter(|at| tail.len() - at >= END_BYTES as usize);
    let Some(end) = found else {
        return Err(damaged(source, length, "an archive without its directory, which stands at its end"));
    };
    let place = tail_at + end as u64;
    let (size, start) = (number::<u32>(&tail, end + 12), number::<u32>(&tail, end + 16));
    let (mut size, mut start) = (u64::from(size), u64::from(start));
    if end >= 20 && tail[end - 20..].starts_with(LOCATOR) {
        let at: u64 = number(&tail, end - 12);
        let record =
            archive.at(at, 56).map_err(|_| damaged(source, place, format!("a record at byte {at}")))?;
        if !record.starts_with(END_64) {
            return Err(damaged(source, at, "no end record where the locator says"));
        }
        (size, start) = (number(&record, 40), number(&record, 48));
    }
    if start.checked_add(size).is_none_or(|end| end > place) {
        return Err(damaged(source, place, format!("a directory of {size} bytes at byte {start}")));
    }
    Ok((start, size))
}

/// One entry of the directory, from its header, name and extra fields.
fn entry(source: &Source, place: u64, bytes: &[u8], name: usize) -> Result<Entry, Error> {
    let mut entry = Entry {
        name: String::from_utf8_lossy(&bytes[46..46 + name]).into_owned(),
        bytes: number::<u32>(bytes, 24).into(),
        packed: number::<u32>(bytes, 20).into(),
        method: number(bytes, 10),
        checksum: number(bytes, 16),
        at: number::<u32>(bytes, 42).into(),
    };
    if number::<u16>(bytes, 8) & 1 == 1 || !matches!(entry.method, 0 | 8) {
        let found =
            format!("entry `{}`, which is encrypted or packed by method {}", entry.name, entry.method);
        return Err(source.fault(Place::Byte(place), found, "entries must be stored or deflated"));
    }
    let mut extra = &bytes[46 + name..];
    while extra.len() >= 4 {
        let (id, size) = (number::<u16>(extra, 0), usize::from(number::<u16>(extra, 2)));
        let body = &extra[4..(4 + size).min(extra.len())];
        if id == 1 {
            let mut wide = body.chunks_exact(8).map(|b| number::<u64>(b, 0));
            for field in [&mut entry.bytes, &mut entry.packed, &mut entry.at] {
                if *field == u64::from(u32::MAX) {
                    *field = wide.next().unwrap_or(*field);
                }
            }
        }
        extra = &extra[(4 + size).min(extra.len())..];
    }
    Ok(entry)
}

/// Refuses entries that share bytes: a few of them would unpack to any number of bytes.
pub(crate) fn apart(source: &Source, archive: &Shared, entries: &[Entry]) -> Result<(), Error> {
    let mut places: Vec<(u64, u64)> = entries
        .iter()
        .map(|entry| Ok((entry.at, start(source, archive, entry)? + entry.packed)))
        .collect::<Result<_, Error>>()?;
    places.sort_unstable();
    match places.windows(2).find(|pair| pair[0].1 > pair[1].0) {
        Some(pair) => Err(damaged(source, pair[1].0, "an entry that begins within another one")),
        None => Ok(()),
    }
}

/// The offset of the bytes of an entry, which are checked to be there.
fn start(source: &Source, archive: &Shared, entry: &Entry) -> Result<u64, Error> {
    let outside = || damaged(source, entry.at, format!("entry `{}` of {} bytes", entry.name, entry.packed));
    let head = archive.at(entry.at, HEAD as usize).map_err(|_| outside())?;
    let start = entry.at + HEAD + u64::from(number::<u16>(&head, 26)) + u64::from(number::<u16>(&head, 28));
    let inside = start.checked_add(entry.packed).is_some_and(|end| end <= archive.length());
    if !head.starts_with(LOCAL) || !inside {
        return Err(outside());
    }
    Ok(start)
}

/// A stream of the bytes of an entry, which are checked by their checksum at the end.
pub(crate) fn open(source: &Source, archive: &Shared, entry: &Entry) -> Result<Source, Error> {
    let start = start(source, archive, entry)?;
    let packed = BufReader::with_capacity(1 << 16, archive.window(start, entry.packed));
    let checked = Checked {
        packed: packing(entry, packed).take(entry.bytes),
        sum: crc32fast::Hasher::new(),
        stated: entry.checksum,
        at: entry.at,
    };
    let name = format!("{}: {}", source.name(), entry.name);
    Ok(Source::new(Box::new(checked), name, Some(entry.bytes), false))
}

fn packing(entry: &Entry, packed: BufReader<Window>) -> Box<dyn Read + Send> {
    if entry.method == 8 { Box::new(DeflateDecoder::new(packed)) } else { Box::new(packed) }
}

/// Bytes whose checksum is compared at their end.
struct Checked {
    packed: Take<Box<dyn Read + Send>>,
    sum: crc32fast::Hasher,
    stated: u32,
    /// The offset of the entry in the archive.
    at: u64,
}

impl Read for Checked {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let got = self.packed.read(out)?;
        self.sum.update(&out[..got]);
        if got == 0 && !out.is_empty() && self.sum.clone().finalize() != self.stated {
            let what =
                format!("byte {}: the entry there does not fit its checksum: get the file anew", self.at);
            return Err(io::Error::new(io::ErrorKind::InvalidData, what));
        }
        Ok(got)
    }
}
