//! The points of a scan: packets in which every field has a stream of bits of its own (ASTM E2807, section 9.3). A field
//! whose least and greatest values are the same takes no bits; streams may run ahead of each other.

use super::pages::Pages;
use e57::RecordDataType;
use std::io;

/// Bytes of the header of the section, and of a data packet.
const SECTION: usize = 32;
const PACKET: usize = 6;
/// Kinds of packets.
const INDEX: u8 = 0;
const DATA: u8 = 1;
const EMPTY: u8 = 2;

/// The bits of a field that are not yet values.
struct Stream {
    kind: RecordDataType,
    bits: u32,
    bytes: Vec<u8>,
    /// Bits that are values already.
    done: usize,
}

/// All streams of a scan.
pub(super) struct Packets<'a> {
    pages: &'a mut Pages,
    streams: Vec<Stream>,
}

impl<'a> Packets<'a> {
    /// Stands before the first packet of the section at a byte of the file.
    pub fn new(pages: &'a mut Pages, at: u64, kinds: Vec<RecordDataType>) -> io::Result<Self> {
        pages.seek(at)?;
        let header = pages.take(SECTION)?;
        let first = header[16..24].first_chunk().map_or(0, |bytes| u64::from_le_bytes(*bytes));
        if header[0] != 1 {
            return Err(io::Error::other(format!("a section of kind {}", header[0])));
        }
        pages.seek(first)?;
        let stream = |kind| Stream { bits: bits(&kind), kind, bytes: Vec::new(), done: 0 };
        Ok(Self { pages, streams: kinds.into_iter().map(stream).collect() })
    }

    /// Rows that all streams have values for; `None` if no field takes bits, so that there are as many as one wants.
    pub fn available(&self) -> Option<u64> {
        self.streams.iter().filter(|s| s.bits > 0).map(Stream::available).min()
    }

    /// Reads the next packet.
    pub fn advance(&mut self) -> io::Result<()> {
        let start = self.pages.place();
        let head = self.pages.take(4)?;
        let (kind, length) = (head[0], u64::from(u16::from_le_bytes([head[2], head[3]])) + 1);
        match kind {
            DATA => self.data(length)?,
            INDEX | EMPTY => {}
            other => return Err(io::Error::other(format!("a packet of kind {other}"))),
        }
        self.pages.go(start + length.max(4).next_multiple_of(4));
        Ok(())
    }

    /// Reads a packet of values, behind the four bytes that tell its length.
    fn data(&mut self, length: u64) -> io::Result<()> {
        let count = self.pages.take(2)?;
        let count = usize::from(u16::from_le_bytes([count[0], count[1]]));
        if count != self.streams.len() {
            return Err(io::Error::other(format!("{count} streams for {} fields", self.streams.len())));
        }
        let sizes = self.pages.take(2 * count)?;
        let sizes: Vec<usize> =
            sizes.chunks_exact(2).map(|b| usize::from(u16::from_le_bytes([b[0], b[1]]))).collect();
        let needed = PACKET + 2 * count + sizes.iter().sum::<usize>();
        if needed as u64 > length {
            return Err(io::Error::other(format!("streams of {needed} bytes in a packet of {length}")));
        }
        for (stream, size) in self.streams.iter_mut().zip(sizes) {
            stream.push(self.pages.take(size)?);
        }
        Ok(())
    }

    /// The next `count` values of a field, of which there must be as many.
    pub fn values(&mut self, field: usize, count: usize, out: &mut Vec<f64>) {
        out.clear();
        let stream = &mut self.streams[field];
        out.extend((0..count).map(|_| stream.next()));
    }

    /// Passes over `count` values of a field.
    pub fn skip(&mut self, field: usize, count: usize) {
        let stream = &mut self.streams[field];
        stream.done += stream.bits as usize * count;
    }
}

impl Stream {
    fn available(&self) -> u64 {
        ((8 * self.bytes.len() - self.done) / self.bits as usize) as u64
    }

    fn push(&mut self, bytes: &[u8]) {
        // Only once half of the bytes are of no use, so that each is moved once at most.
        if self.done / 8 > self.bytes.len() / 2 {
            self.bytes.drain(..self.done / 8);
            self.done %= 8;
        }
        self.bytes.extend_from_slice(bytes);
    }

    /// The next value; a missing one is zero bits.
    fn next(&mut self) -> f64 {
        let mut around = [0; 16];
        let rest = self.bytes.get(self.done / 8..).unwrap_or(&[]);
        let some = rest.len().min(9);
        around[..some].copy_from_slice(&rest[..some]);
        let mask = u64::MAX.checked_shr(64 - self.bits).unwrap_or(0);
        let raw = (u128::from_le_bytes(around) >> (self.done % 8)) as u64 & mask;
        self.done += self.bits as usize;
        let integer = |least: i64| (i128::from(raw) + i128::from(least)) as i64 as f64;
        match self.kind {
            RecordDataType::Single { .. } => f32::from_bits(raw as u32).into(),
            RecordDataType::Double { .. } => f64::from_bits(raw),
            RecordDataType::ScaledInteger { min, scale, offset, .. } => integer(min) * scale + offset,
            RecordDataType::Integer { min, .. } => integer(min),
        }
    }
}

/// Bits of a value.
fn bits(kind: &RecordDataType) -> u32 {
    match kind {
        RecordDataType::Single { .. } => 32,
        RecordDataType::Double { .. } => 64,
        RecordDataType::ScaledInteger { min, max, .. } | RecordDataType::Integer { min, max } => {
            (i128::from(*max) - i128::from(*min)).checked_ilog2().map_or(0, |bits| bits + 1)
        }
    }
}
