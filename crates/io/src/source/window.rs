//! An input that several readers share, each at a place of its own.

use super::Input;
use std::io::{self, Read, Seek, SeekFrom};
use std::sync::{Arc, Mutex, PoisonError};

/// The whole of an input; clones read the same bytes.
#[derive(Clone)]
pub(crate) struct Shared {
    input: Arc<Mutex<Input>>,
    length: u64,
}

/// Bytes of a shared input, from a place to another.
pub(crate) struct Window {
    shared: Shared,
    at: u64,
    end: u64,
}

impl Shared {
    pub fn new(mut input: Input) -> io::Result<Self> {
        let length = input.seek(SeekFrom::End(0))?;
        Ok(Self { input: Arc::new(Mutex::new(input)), length })
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
        Window { shared: self.clone(), at: place.min(end), end }
    }
}

impl Read for Window {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let some = (self.end - self.at).min(out.len() as u64) as usize;
        if some == 0 {
            return Ok(0);
        }
        let mut input = self.shared.input.lock().unwrap_or_else(PoisonError::into_inner);
        input.seek(SeekFrom::Start(self.at))?;
        let got = input.read(&mut out[..some])?;
        self.at += got as u64;
        Ok(got)
    }
}
