//! An input as one forward stream of bytes: buffered, counted, hashed on the way, with its length if known.

mod window;
mod words;

pub(crate) use window::{Shared, Window};
pub(crate) use words::Word;

use crate::error::{Error, Place, printable};
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{BufReader, Cursor, Read, Seek};
use std::path::{Path, PathBuf};

/// Bytes asked of the system at once: large enough to amortise the call, small enough to stay in cache.
const BLOCK: usize = 1 << 18;

/// An input that can be read at any place.
pub(crate) type Input = Box<dyn ReadSeek>;

/// The parts of an [`Input`].
pub(crate) trait ReadSeek: Read + Seek + Send + Sync {}
impl<T: Read + Seek + Send + Sync> ReadSeek for T {}

/// A forward reader with lookahead. Offsets and lines in errors come from here.
pub(crate) struct Source {
    name: String,
    reader: Box<dyn Read + Send>,
    /// Bytes asked of the system at once.
    block: usize,
    buffer: Vec<u8>,
    start: usize,
    end: usize,
    offset: u64,
    line: u64,
    ended: bool,
    length: Option<u64>,
    terminator: u8,
    /// Whether the line given last had no end, as that of a file that was cut has none.
    open: bool,
    hash: Option<Sha256>,
    path: Option<PathBuf>,
    /// Bytes of a pipe consumed since [`Source::keep`] asked for them.
    kept: Vec<u8>,
    keeping: bool,
}

impl Source {
    /// A source over `reader`; `length` is the number of bytes if the system knows it (`None` for pipes).
    pub fn new(reader: Box<dyn Read + Send>, name: String, length: Option<u64>, hash: bool) -> Self {
        let hash = hash.then(Sha256::new);
        Self {
            name,
            reader,
            block: BLOCK,
            buffer: Vec::new(),
            start: 0,
            end: 0,
            offset: 0,
            line: 0,
            ended: false,
            length,
            terminator: b'\n',
            open: false,
            hash,
            path: None,
            kept: Vec::new(),
            keeping: false,
        }
    }

    /// Asks for so many bytes at once, where not all are to be read.
    pub fn in_steps(self, block: usize) -> Self {
        Self { block, ..self }
    }

    /// Keeps what is consumed from now on if the input cannot be opened again, for [`Source::seekable`].
    pub fn keep(&mut self) {
        self.keeping = self.path.is_none();
    }

    /// Sets the path by which the input can be opened again.
    pub fn at(mut self, path: &Path) -> Self {
        self.path = self.length.map(|_| path.to_path_buf());
        self
    }

    /// The path of the input, if it is a file.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// The whole input for reading at any place: the file once more, or, of a pipe, all its bytes.
    pub fn seekable(&mut self) -> Result<Input, Error> {
        if let Some(path) = &self.path {
            let file = File::open(path);
            let file =
                file.map_err(|source| Error::Io { action: "open", name: self.name.clone(), source })?;
            return Ok(Box::new(BufReader::with_capacity(BLOCK, file)));
        }
        self.keeping = false;
        let mut all = std::mem::take(&mut self.kept);
        loop {
            let here = self.peek(1)?;
            if here.is_empty() {
                return Ok(Box::new(Cursor::new(all)));
            }
            all.extend_from_slice(here);
            let count = here.len();
            self.consume(count);
        }
    }

    /// The error for a failed read of this input.
    pub fn io(&self, source: std::io::Error) -> Error {
        Error::Io { action: "read", name: self.name.clone(), source }
    }

    /// The name for messages.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Bytes consumed so far.
    pub fn offset(&self) -> u64 {
        self.offset
    }

    /// Bytes of the input, or those seen of it so far.
    pub fn size(&self) -> u64 {
        self.length.unwrap_or(self.offset + (self.end - self.start) as u64)
    }

    /// Bytes not yet consumed, if the length of the input is known or its end is in sight.
    pub fn remaining(&self) -> Option<u64> {
        if self.ended {
            return Some((self.end - self.start) as u64);
        }
        self.length.map(|length| length.saturating_sub(self.offset))
    }

    /// At least `count` bytes without consuming them; fewer only where the input ends.
    pub fn peek(&mut self, count: usize) -> Result<&[u8], Error> {
        while self.end - self.start < count && !self.ended {
            self.fill(count)?;
        }
        Ok(&self.buffer[self.start..self.end])
    }

    /// Moves past `count` bytes that were peeked at.
    pub fn consume(&mut self, count: usize) {
        let count = count.min(self.end - self.start);
        if self.keeping {
            self.kept.extend_from_slice(&self.buffer[self.start..self.start + count]);
        }
        self.start += count;
        self.offset += count as u64;
    }

    /// Moves past `count` bytes, peeked at or not; gives how many of them were there.
    pub fn skip(&mut self, count: u64) -> Result<u64, Error> {
        let mut left = count;
        while left > 0 {
            let here = self.peek(1)?.len() as u64;
            if here == 0 {
                break;
            }
            let step = here.min(left);
            self.consume(step as usize);
            left -= step;
        }
        Ok(count - left)
    }

    /// Reads on to the end, for the hash and the number of bytes.
    pub fn drain(&mut self) -> Result<u64, Error> {
        self.skip(u64::MAX)
    }

    /// Lines end with a line feed unless the beginning shows bare carriage returns, as old Macintosh files do.
    pub fn detect_terminator(&mut self) -> Result<(), Error> {
        let start = self.peek(4096)?;
        let first = start.iter().position(|&b| b == b'\r' || b == b'\n');
        let bare = first.is_some_and(|i| start[i] == b'\r' && start.get(i + 1) != Some(&b'\n'));
        self.terminator = if bare { b'\r' } else { b'\n' };
        Ok(())
    }

    /// The next line without its end, or `None` at the end of the input. A last line needs no end.
    pub fn line(&mut self) -> Result<Option<&[u8]>, Error> {
        let mut searched = 0;
        let length = loop {
            let here = &self.buffer[self.start..self.end];
            if let Some(at) = memchr::memchr(self.terminator, &here[searched..]) {
                break searched + at + 1;
            }
            searched = here.len();
            if self.ended {
                break searched;
            }
            self.fill(searched + 1)?;
        };
        if length == 0 {
            return Ok(None);
        }
        let from = self.start;
        self.consume(length);
        self.line += 1;
        let line = &self.buffer[from..from + length];
        self.open = line.last() != Some(&self.terminator);
        let line = line.strip_suffix(&[self.terminator]).unwrap_or(line);
        Ok(Some(line.strip_suffix(b"\r").unwrap_or(line)))
    }

    /// A warning if the last line has no end though the input has as many rows as it announces: the file may have been cut within
    /// the last number.
    pub fn open_end(&self) -> Option<String> {
        let text = "the last line has no end: if the file was cut there, its last number is not whole";
        self.open.then(|| text.into())
    }

    /// The SHA-256 of what was consumed and buffered, in hexadecimal; `None` if it was not asked for.
    pub fn sha256(&mut self) -> Option<String> {
        let digest = self.hash.take()?.finalize();
        Some(digest.iter().map(|byte| format!("{byte:02x}")).collect())
    }

    /// A fault at the current byte.
    pub fn malformed(&self, found: impl Into<String>, advice: impl Into<String>) -> Error {
        self.fault(Place::Byte(self.offset), found, advice)
    }

    /// A fault in the line given last.
    pub fn malformed_line(&self, found: impl Into<String>, advice: impl Into<String>) -> Error {
        self.fault(Place::Line(self.line), found, advice)
    }

    /// A fault at a stated place.
    pub fn fault(&self, place: Place, found: impl Into<String>, advice: impl Into<String>) -> Error {
        Error::Malformed {
            name: self.name.clone(),
            place,
            found: printable(&found.into()),
            advice: advice.into(),
        }
    }

    /// The error for an input that ends before its announced length.
    pub fn ends_early(&self, unit: impl Into<String>, expected: u64, read: u64) -> Error {
        let place = Place::Byte(self.size());
        Error::EndsEarly { name: self.name.clone(), place, unit: printable(&unit.into()), expected, read }
    }

    /// Brings more bytes into the buffer, which grows when `wanted` do not fit.
    fn fill(&mut self, wanted: usize) -> Result<(), Error> {
        self.buffer.copy_within(self.start..self.end, 0);
        self.end -= self.start;
        self.start = 0;
        if self.buffer.len() < wanted.max(self.end + 1) {
            let more = self.buffer.len() / 2;
            self.buffer.resize(wanted.max(self.end + more).max(self.block), 0);
        }
        let got = loop {
            match self.reader.read(&mut self.buffer[self.end..]) {
                Err(error) if error.kind() == std::io::ErrorKind::Interrupted => continue,
                other => break other,
            }
        };
        let got = got.map_err(|source| Error::Io { action: "read", name: self.name.clone(), source })?;
        if let Some(hash) = &mut self.hash {
            hash.update(&self.buffer[self.end..self.end + got]);
        }
        self.end += got;
        self.ended = got == 0;
        let seen = self.offset + (self.end - self.start) as u64;
        match self.length.filter(|&length| self.ended && self.path.is_some() && seen < length) {
            // The file was longer when it was opened: it became shorter meanwhile.
            Some(length) => Err(self.ends_early("bytes", length, seen)),
            None => Ok(()),
        }
    }
}
