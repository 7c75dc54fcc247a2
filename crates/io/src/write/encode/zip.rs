//! Writing archives of stored entries, with sizes of 64 bits throughout.

use crate::read::zip::{CENTRAL, END, END_64, LOCAL, LOCATOR};
use std::io::{self, Write};

/// Version of the format that ZIP64 needs, and the date 1980-01-01: the time of writing would make bytes differ.
const VERSION: u16 = 45;
const DATE: u16 = 0x21;

/// Writes the bytes of an entry, the same whenever it is called.
pub(in crate::write) type Content<'a> = &'a dyn Fn(&mut dyn Write) -> io::Result<()>;

/// Checksum and size of an entry, counted before it is written.
#[derive(Default)]
struct Counted {
    sum: crc32fast::Hasher,
    size: u64,
}

impl Write for Counted {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.sum.update(bytes);
        self.size += bytes.len() as u64;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// An archive in the making.
pub(in crate::write) struct ZipWriter<'a> {
    out: &'a mut dyn Write,
    at: u64,
    directory: Vec<u8>,
    entries: u64,
}

/// Little endian numbers one after the other.
macro_rules! numbers {
    ($($value:expr),*) => {{
        let mut bytes: Vec<u8> = Vec::new();
        $(bytes.extend_from_slice(&$value.to_le_bytes());)*
        bytes
    }};
}

impl<'a> ZipWriter<'a> {
    pub fn new(out: &'a mut dyn Write) -> Self {
        Self { out, at: 0, directory: Vec::new(), entries: 0 }
    }

    /// Adds a file, as it is. `content` gives its bytes, and is asked for them twice: the checksum stands before them.
    pub fn add(&mut self, name: &str, content: Content) -> io::Result<()> {
        let length = u16::try_from(name.len()).map_err(io::Error::other)?;
        let mut counted = Counted::default();
        content(&mut counted)?;
        let (sum, size, narrow) = (counted.sum.finalize(), counted.size, u32::MAX);
        // Bit 11: the name is UTF-8. Method 0: stored.
        let common = numbers![1u16 << 11, 0u16, 0u16, DATE, sum, narrow, narrow, length];
        let head = [LOCAL, &numbers![VERSION], &common, &numbers![20u16]].concat();
        let start = self.at;
        self.put(&[&head, name.as_bytes(), &numbers![1u16, 16u16, size, size]])?;
        content(self.out)?;
        self.at += size;
        self.directory.extend([CENTRAL, &numbers![VERSION, VERSION], &common].concat());
        // Extra fields of 28 bytes, no comment, disk 0, no attributes.
        self.directory.extend(numbers![28u16, 0u16, 0u16, 0u16, 0u32, narrow]);
        self.directory.extend(name.as_bytes());
        self.directory.extend(numbers![1u16, 24u16, size, size, start]);
        self.entries += 1;
        Ok(())
    }

    /// Writes the directory.
    pub fn finish(mut self) -> io::Result<()> {
        let (start, size, count) = (self.at, self.directory.len() as u64, self.entries);
        let directory = std::mem::take(&mut self.directory);
        self.put(&[&directory])?;
        let end = self.at;
        self.put(&[END_64, &numbers![44u64, VERSION, VERSION, 0u32, 0u32, count, count, size, start]])?;
        self.put(&[LOCATOR, &numbers![0u32, end, 1u32]])?;
        self.put(&[END, &numbers![0u16, 0u16, u16::MAX, u16::MAX, u32::MAX, u32::MAX, 0u16]])
    }

    fn put(&mut self, parts: &[&[u8]]) -> io::Result<()> {
        for part in parts {
            self.out.write_all(part)?;
            self.at += part.len() as u64;
        }
        Ok(())
    }
}
