//! The public header block of LAS.

use crate::columns::{Endian, Number};
use crate::error::{Error, Place};
use crate::source::Source;
use serde::{Deserialize, Serialize};

/// The fields of the header that concern points.
#[derive(Debug)]
pub(super) struct Header {
    pub minor: u8,
    /// The global encoding, and the day of the year and the year in which the file was made.
    pub encoding: u16,
    pub created: [u16; 2],
    pub header_size: u64,
    pub points_at: u64,
    pub records: u32,
    /// The offset of extended records, after the points, and their number.
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

/// Storage of the coordinates of a LAS input, and its reference system: all that an output needs to match its input.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LasFrame {
    /// The version, 1.0 to 1.4, behind its point.
    pub minor: u8,
    /// Factor of the stored integers, a axis.
    pub scale: [f64; 3],
    /// Coordinates of the stored integer 0.
    pub offset: [f64; 3],
    /// Point data record format, 0 to 10.
    pub point_format: u8,
    /// The global encoding, of which bit 0 tells the kind of GPS times.
    #[serde(default)]
    pub encoding: u16,
    /// Day of the year and year in which the file was made.
    #[serde(default)]
    pub created: [u16; 2],
    /// The variable length records, in order.
    pub records: Vec<Record>,
}

/// A variable length record.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
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
    let bytes = source.peek(VERSION_1_4)?;
    let bytes = bytes[..bytes.len().min(VERSION_1_4)].to_vec();
    if bytes.len() < LEAST {
        return Err(source.ends_early("bytes of the header", LEAST as u64, bytes.len() as u64));
    }
    let header = fields(&bytes);
    let file = source.remaining().map(|_| source.size());
    let checks = layout(&bytes, &header, file).and_then(|()| values(&header));
    checks.map(|()| header).map_err(|Fault(at, found, advice)| source.fault(Place::Byte(at), found, advice))
}

/// The fields of a header that has the bytes of version 1.0 at least.
fn fields(bytes: &[u8]) -> Header {
    let get = |at: usize| Fields(&bytes[at.min(bytes.len())..]);
    let triple = |at: usize, step: usize| [0, 1, 2].map(|axis| get(at + step * axis).number::<f64>());
    let (minor, header_size) = (bytes[25], u64::from(get(94).number::<u16>()));
    let current = minor >= 4 && header_size >= VERSION_1_4 as u64;
    let large = if current { get(247).number::<u64>() } else { 0 };
    Header {
        minor,
        encoding: get(6).number(),
        created: [get(90).number(), get(92).number()],
        header_size,
        points_at: u64::from(get(96).number::<u32>()),
        records: get(100).number(),
        extended: if current { (get(235).number(), get(243).number()) } else { (0, 0) },
        format: bytes[104] & 0x3f,
        compressed: bytes[104] & 0xc0 != 0,
        record_length: usize::from(get(105).number::<u16>()),
        points: if large > 0 { large } else { get(107).number::<u32>().into() },
        scale: triple(131, 8),
        offset: triple(155, 8),
        bounds: (triple(187, 16), triple(179, 16)),
    }
}

/// A fault of a header: its byte, the finding and the remedy.
struct Fault(u64, String, String);

/// Checks the version and the places of things; `file` is the size of the input where it is known.
fn layout(bytes: &[u8], header: &Header, file: Option<u64>) -> Result<(), Fault> {
    let Header { minor, header_size, points_at, .. } = header;
    let major = bytes[24];
    if major != 1 || *minor > 4 {
        let found = format!("version {major}.{minor}");
        return Err(Fault(24, found, "versions 1.0 to 1.4 are read".into()));
    }
    if *header_size < LEAST as u64 || points_at < header_size {
        let found = format!("a header of {header_size} bytes with points from byte {points_at}");
        let advice = "a header has at least 227 bytes and the points follow it; the file is damaged";
        return Err(Fault(94, found, advice.into()));
    }
    if let Some(size) = file.filter(|size| points_at > size) {
        let found = format!("points from byte {points_at} of a file of {size}");
        return Err(Fault(96, found, "the file is cut or damaged".into()));
    }
    Ok(())
}

/// Checks the point format, the length of its records, scale and offset.
fn values(header: &Header) -> Result<(), Fault> {
    let Header { format, record_length, scale, offset, .. } = header;
    let Some(&least) = RECORD_LENGTHS.get(usize::from(*format)) else {
        return Err(Fault(104, format!("point format {format}"), "formats 0 to 10 are read".into()));
    };
    if *record_length < least {
        let found = format!("records of {record_length} bytes for point format {format}");
        return Err(Fault(105, found, format!("it needs at least {least}; the file is damaged")));
    }
    if !scale.iter().all(|s| s.is_finite() && *s != 0.0) || !offset.iter().all(|o| o.is_finite()) {
        let found = format!("coordinate scale {scale:?} and offset {offset:?}");
        let advice = "they must be finite and the scale not 0; the file is damaged";
        return Err(Fault(131, found, advice.into()));
    }
    Ok(())
}

/// Numbers at the beginning of a slice.
pub(super) struct Fields<'a>(pub &'a [u8]);

impl Fields<'_> {
    /// The little endian number that begins here; 0 if the bytes end before.
    pub fn number<T: Number>(&self) -> T {
        T::from_bytes(self.0, Endian::Little)
    }
}
