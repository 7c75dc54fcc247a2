//! Packed bytes for a decoder that calls itself: the `laz` crate follows a change of GPS sequence by recursion, and a
//! damaged chunk of two kilobytes can ask for a hundred thousand changes in a row, which no stack holds and no handler
//! catches. Such a decoder still reads a byte every few hundred changes; the bytes end when the stack has grown too far.

use std::io::{Cursor, Error, Read, Result, Seek, SeekFrom};

/// Growth of the stack, in bytes, that sound data stay far below: threads have two megabytes.
const DEEPEST: usize = 1 << 18;

/// The bytes of a chunk, to be read by calls from not far below where it was made.
pub(super) struct Watched {
    bytes: Cursor<Vec<u8>>,
    /// Where the stack stood.
    base: usize,
}

impl Watched {
    #[inline(never)]
    pub(super) fn new(bytes: Vec<u8>) -> Self {
        Self { bytes: Cursor::new(bytes), base: stack() }
    }
}

/// About where the stack stands.
#[inline(always)]
fn stack() -> usize {
    let here = 0u8;
    std::ptr::from_ref(std::hint::black_box(&here)).addr()
}

impl Read for Watched {
    #[inline]
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        if self.base.abs_diff(stack()) > DEEPEST {
            return Err(Error::other("its GPS times change their sequence without end"));
        }
        self.bytes.read(buffer)
    }
}

impl Seek for Watched {
    fn seek(&mut self, to: SeekFrom) -> Result<u64> {
        self.bytes.seek(to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Like the decoder: calls itself a hundred times for each byte.
    fn deep(bytes: &mut Watched, level: usize) -> Result<usize> {
        let mut byte = [0];
        if level.is_multiple_of(100) && bytes.read(&mut byte)? == 0 {
            return Ok(level);
        }
        std::hint::black_box(&byte);
        deep(bytes, level + 1).map(|deepest| deepest.max(level))
    }

    #[test]
    fn a_reader_that_calls_itself_without_end_is_stopped() {
        assert!(deep(&mut Watched::new(vec![0; 1 << 20]), 0).unwrap_err().to_string().contains("GPS"));
        assert_eq!(deep(&mut Watched::new(vec![0; 2]), 0).unwrap(), 200);
    }
}
