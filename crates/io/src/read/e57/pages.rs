//! The pages of an E57 file, each followed by its checksum (ASTM E2807, section 9.2), read as one stream of bytes.

use crate::source::Shared;
use std::io;

/// Bytes of a checksum.
const CHECKSUM: usize = 4;
/// Bytes of pages that are read at once.
const BLOCK: usize = 1 << 16;
/// Pages are powers of two in practice; no larger one is known.
const MOST: u64 = 1 << 20;

/// A reader of the stream at a place of it.
pub(super) struct Pages {
    shared: Shared,
    size: usize,
    /// Bytes of the stream that were read last, and where they lie in it.
    bytes: Vec<u8>,
    first: u64,
    /// The next byte of the stream to read.
    at: u64,
    /// Bytes read so far: no file needs more of them than it has.
    taken: u64,
}

impl Pages {
    /// The pages of an input; `None` if no page can have this size.
    pub fn new(shared: &Shared, size: u64) -> Option<Self> {
        let sound = size > CHECKSUM as u64 && size <= MOST && shared.length().is_multiple_of(size);
        let empty = Self { shared: shared.clone(), size: 0, bytes: Vec::new(), first: 0, at: 0, taken: 0 };
        sound.then_some(Self { size: size as usize, ..empty })
    }

    /// Moves to a byte of the file.
    pub fn seek(&mut self, physical: u64) -> io::Result<()> {
        let (page, inside) = (physical / self.size as u64, physical % self.size as u64);
        if physical >= self.shared.length() || inside >= self.data() as u64 {
            return Err(io::Error::other(format!("there is no byte {physical} between checksums")));
        }
        self.at = page * self.data() as u64 + inside;
        Ok(())
    }

    /// Moves to a byte of the stream.
    pub fn go(&mut self, at: u64) {
        self.at = at;
    }

    /// The next byte of the stream.
    pub fn place(&self) -> u64 {
        self.at
    }

    /// The next `count` bytes.
    pub fn take(&mut self, count: usize) -> io::Result<&[u8]> {
        self.taken += count as u64;
        if self.taken > self.shared.length() {
            return Err(io::Error::other(
                "parts of the file are read more than once: scans share their bytes",
            ));
        }
        let from = self.at.wrapping_sub(self.first);
        if self.at < self.first || from.saturating_add(count as u64) > self.bytes.len() as u64 {
            self.fill(count)?;
        }
        let from = (self.at - self.first) as usize;
        self.at += count as u64;
        self.bytes.get(from..from + count).ok_or_else(|| io::ErrorKind::UnexpectedEof.into())
    }

    /// Bytes of the stream in a page.
    fn data(&self) -> usize {
        self.size - CHECKSUM
    }

    /// Reads the pages that hold the next `count` bytes, as far as they are there.
    fn fill(&mut self, count: usize) -> io::Result<()> {
        let page = self.at / self.data() as u64;
        let there = self.shared.length() / self.size as u64;
        let wanted = (count + self.size + BLOCK).div_ceil(self.data()) as u64;
        let pages = wanted.min(there.saturating_sub(page)) as usize;
        let raw = self.shared.at(page * self.size as u64, pages * self.size)?;
        self.bytes.clear();
        self.first = page * self.data() as u64;
        for (number, raw) in (page..).zip(raw.chunks_exact(self.size)) {
            let (data, sum) = raw.split_at(self.data());
            if crc32c(data).to_be_bytes() != sum {
                return Err(io::Error::other(format!("page {number} does not fit its checksum")));
            }
            self.bytes.extend_from_slice(data);
        }
        Ok(())
    }
}

/// CRC-32C (RFC 3720, appendix B.4), four bytes at a time.
fn crc32c(bytes: &[u8]) -> u32 {
    let mut sum = u32::MAX;
    let (words, rest) = bytes.as_chunks::<4>();
    for word in words {
        sum ^= u32::from_le_bytes(*word);
        let [a, b, c, d] = sum.to_le_bytes().map(usize::from);
        sum = TABLES[3][a] ^ TABLES[2][b] ^ TABLES[1][c] ^ TABLES[0][d];
    }
    for byte in rest {
        sum = TABLES[0][(sum as u8 ^ byte) as usize] ^ (sum >> 8);
    }
    !sum
}

static TABLES: [[u32; 256]; 4] = tables();

const fn tables() -> [[u32; 256]; 4] {
    let mut tables = [[0; 256]; 4];
    let mut i = 0;
    while i < 256 {
        let (mut sum, mut bit) = (i as u32, 0);
        while bit < 8 {
            sum = if sum & 1 == 1 { 0x82f6_3b78 ^ (sum >> 1) } else { sum >> 1 };
            bit += 1;
        }
        tables[0][i] = sum;
        i += 1;
    }
    i = 0;
    while i < 256 {
        let mut table = 1;
        while table < 4 {
            let below = tables[table - 1][i];
            tables[table][i] = tables[0][(below & 0xff) as usize] ^ (below >> 8);
            table += 1;
        }
        i += 1;
    }
    tables
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn checksums_are_those_of_the_standard() {
        // RFC 3720, appendix B.4.
        assert_eq!(crc32c(&[0; 32]), 0x8a91_36aa);
        assert_eq!(crc32c(b"123456789"), 0xe306_9283);
    }
}
