//! The public header block of LAS.

use crate::columns::{Endian, Number};
use crate::error::{Error, Place};
use crate::source::Source;

/// What the header says of the points.
#[derive(Debug)]
pub(super) struct Header {
    pub minor: u8,
    pub header_size: u64,
    pub points_at: u64,
    pub records: u32,
    /// Where extended records begin, behind the points, and how many there are.
    pub extended: (u64, u32),
    /// Point data record format, 0 to 10.
    pub format: u8,
    pub compressed: bool,
    pub record_length: usize,
    pub points: u64,
    pub scale: [f64; 3],
    pub offset: [f64; 3],
    /// Least and greatest coordinates, as stated.
    pub bounds: ([f64; 3], [f64; 3]),
}

/// How the coordinates of a LAS input are stored, and where on earth they lie: what an output needs to be like its
/// input.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LasFrame {
    /// Factor of the stored integers, a axis.
    pub scale: [f64; 3],
    /// Coordinates of the stored integer 0.
    pub offset: [f64; 3],
    /// Point data record format, 0 to 10.
    pub point_format: u8,
    /// The variable length records, in order.
    pub records: Vec<Record>,
}

/// A variable length record.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Record {
    /// Who defined it, such as `LASF_Projection`.
    pub user: String,
    /// Its number under that name.
    pub id: u16,
    /// Its content.
    pub data: Vec<u8>,
}

/// Bytes of the header that every version has.
const LEAST: usize = 227;
/// Bytes of a version 1.4 header.
const VERSION_1_4: usize = 375;
/// Bytes of a record of each point format without extra bytes.
pub(super) const RECORD_LENGTHS: [usize; 11] = [20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67];

impl Header {
    /// Whether points come with wave packets.
    pub fn has_waves(&self) -> bool {
        matches!(self.format, 4 | 5 | 9 | 10)
    }

    /// Bytes of a record that the point format defines; those after them are extra bytes.
    pub fn standard_length(&self) -> usize {
        RECORD_LENGTHS.get(usize::from(self.format)).copied().unwrap_or(0)
    }
}

/// Reads and checks the header; the source stays at the first byte.
pub(super) fn parse(source: &mut Source) -> Result<Header, Error> {
    let size = source.size();
    let bytes = source.peek(VERSION_1_4)?;
    let bytes = bytes[..bytes.len().min(VERSION_1_4)].to_vec();
    if bytes.len() < LEAST {
        return Err(source.ends_early("bytes of the header", LEAST as u64, bytes.len() as u64));
    }
    let get = |at: usize| Fields(&bytes[at.min(bytes.len())..]);
    let (major, minor) = (bytes[24], bytes[25]);
    let (header_size, points_at) = (u64::from(get(94).number::<u16>()), u64::from(get(96).number::<u32>()));
    let fault = |at: u64, found: String, advice: &str| Err(source.fault(Place::Byte(at), found, advice));
    if major != 1 || minor > 4 {
        return fault(24, format!("version {major}.{minor}"), "versions 1.0 to 1.4 are read");
    }
    if header_size < LEAST as u64 || points_at < header_size {
        let found = format!("a header of {header_size} bytes with points from byte {points_at}");
        return fault(
            94,
            found,
            "a header has at least 227 bytes and the points follow it; the file is damaged",
        );
    }
    if source.remaining().is_some() && points_at > size {
        return fault(
            96,
            format!("points from byte {points_at} of a file of {size}"),
            "the file is cut or damaged",
        );
    }
    let format = bytes[104] & 0x3f;
    let record_length = usize::from(get(105).number::<u16>());
    let Some(&least) = RECORD_LENGTHS.get(usize::from(format)) else {
        return fault(104, format!("point format {format}"), "formats 0 to 10 are read");
    };
    if record_length < least {
        let found = format!("records of {record_length} bytes for point format {format}");
        return fault(105, found, &format!("it needs at least {least}; the file is damaged"));
    }
    let triple = |at: usize| [0, 1, 2].map(|axis| get(at + 8 * axis).number::<f64>());
    let (scale, offset) = (triple(131), triple(155));
    if !scale.iter().all(|s| s.is_finite() && *s != 0.0) || !offset.iter().all(|o| o.is_finite()) {
        let found = format!("coordinate scale {scale:?} and offset {offset:?}");
        return fault(131, found, "they must be finite and the scale not 0; the file is damaged");
    }
    let current = minor >= 4 && header_size >= VERSION_1_4 as u64;
    let large = if current { get(247).number::<u64>() } else { 0 };
    let points = if large > 0 { large } else { get(107).number::<u32>().into() };
    let compressed = bytes[104] & 0xc0 != 0;
    let records = get(100).number();
    let extended = if current { (get(235).number(), get(243).number()) } else { (0, 0) };
    let limit = |at: usize| [0, 1, 2].map(|axis| get(at + 16 * axis).number::<f64>());
    let bounds = (limit(187), limit(179));
    Ok(Header {
        minor,
        header_size,
        points_at,
        records,
        extended,
        format,
        compressed,
        record_length,
        points,
        scale,
        offset,
        bounds,
    })
}

/// Numbers at the beginning of a slice.
pub(super) struct Fields<'a>(pub &'a [u8]);

impl Fields<'_> {
    /// The little endian number that begins here; 0 if the bytes end before.
    pub fn number<T: Number>(&self) -> T {
        T::from_bytes(self.0, Endian::Little)
    }
}
