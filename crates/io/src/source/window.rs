//! An input that several readers share, each at a place of its own.

use super::Input;
use std::io::{self, Read, Seek, SeekFrom};
use std::sync::{Arc, Mutex, PoisonError};

/// Bytes that are requested from the system at once. Each small read at another place costs one such block.
const BLOCK: usize = 1 << 16;

/// The whole of an input; clones read the same bytes.
#[derive(Clone)]
pub(crate) struct Shared {
    input: Arc<Mutex<Block>>,
    length: u64,
}

/// The input with the bytes that were asked for last, and their place.
struct Block {
    input: Input,
    at: u64,
    bytes: Vec<u8>,
}

/// Bytes of a shared input, from a place to another.
pub(crate) struct Window {
    shared: Shared,
    first: u64,
    at: u64,
    end: u64,
}

impl Shared {
    pub fn new(mut input: Input) -> io::Result<Self> {
        let length = input.seek(SeekFrom::End(0))?;
        Ok(Self { input: Arc::new(Mutex::new(Block { input, at: 0, bytes: Vec::new() })), length })
    }

    /// Bytes of the input.
    pub fn length(&self) -> u64 {
        self.length
    }

    /// The `count` bytes at a place; fewer are an error.
    pub fn at(&self, place: u64, count: usize) -> io::Result<Vec<u8>> {
        if place.checked_add(count as u64).is_none_or(|end| end > self.length) {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        let mut bytes = vec![0; count];
        self.window(place, count as u64).read_exact(&mut bytes)?;
        Ok(bytes)
    }

    /// A reader of so many bytes from a place, or of fewer where the input ends.
    pub fn window(&self, place: u64, count: u64) -> Window {
        let end = place.saturating_add(count).min(self.length);
        let first = place.min(end);
        Window { shared: self.clone(), first, at: first, end }
    }
}

impl Block {
    /// Some bytes from a place, at least one where there is one.
    fn read(&mut self, place: u64, out: &mut [u8]) -> io::Result<usize> {
        let inside = |block: &Self| {
            let from = usize::try_from(place.checked_sub(block.at)?).ok()?;
            (from < block.bytes.len()).then_some(from)
        };
        if inside(self).is_none() {
            self.input.seek(SeekFrom::Start(place))?;
            if out.len() >= BLOCK {
                return self.input.read(out);
            }
            self.bytes.clear();
            self.at = place;
            self.input.by_ref().take(BLOCK as u64).read_to_end(&mut self.bytes)?;
        }
        let Some(from) = inside(self) else { return Ok(0) };
        let some = out.len().min(self.bytes.len() - from);
        out[..some].copy_from_slice(&self.bytes[from..from + some]);
        Ok(some)
    }
}

impl Read for Window {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let some = (self.end - self.at).min(out.len() as u64) as usize;
        if some == 0 {
            return Ok(0);
        }
        let mut input = self.shared.input.lock().unwrap_or_else(PoisonError::into_inner);
        let got = input.read(self.at, &mut out[..some])?;
        self.at += got as u64;
        Ok(got)
    }
}

impl Seek for Window {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let place = match to {
            SeekFrom::Start(from) => self.first.checked_add(from),
            SeekFrom::Current(from) => self.at.checked_add_signed(from),
            SeekFrom::End(from) => self.end.checked_add_signed(from),
        };
        let place = place.filter(|&place| place >= self.first).ok_or(io::ErrorKind::InvalidInput)?;
        // Behind the end there is nothing to read, wherever that is.
        self.at = place.min(self.end);
        Ok(place - self.first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;

    #[test]
    fn windows_read_their_bytes_in_any_order_of_places() {
        let bytes: Vec<u8> = (0..300_000u32).map(|i| ((i * 7) >> 3) as u8).collect();
        let shared = Shared::new(Box::new(Cursor::new(bytes.clone()))).unwrap();
        for (place, count) in [(0, 10), (299_990, 10), (5, 200_000), (65_530, 12), (3, 4), (131_000, 99_000)]
        {
            assert_eq!(shared.at(place as u64, count).unwrap(), bytes[place..place + count], "{place}");
        }
        let mut window = shared.window(100, 50);
        assert_eq!(window.seek(SeekFrom::End(-20)).unwrap(), 30);
        let mut rest = Vec::new();
        window.read_to_end(&mut rest).unwrap();
        assert_eq!(rest, bytes[130..150]);
        assert!(window.seek(SeekFrom::Current(-51)).is_err());
        assert!(shared.at(299_999, 2).is_err());
    }
}
