//! LZF, Marc Lehmann's byte-oriented compression: runs of literal bytes, and copies of up to 264 bytes from up to
//! 8192 bytes back. Unpacked as a stream, so that no more than that window is held.

use crate::error::Error;
use crate::source::Source;

/// Greatest distance from which a copy is taken.
const WINDOW: usize = 1 << 13;

/// An unpacker that takes its bytes from a source.
pub(super) struct Lzf<'a> {
    source: &'a mut Source,
    /// Packed bytes left.
    left: u64,
    /// The last bytes unpacked, as a ring.
    window: Vec<u8>,
    /// Bytes unpacked so far.
    done: u64,
    pending: Pending,
}

/// The rest of the work that the last control byte asked for.
enum Pending {
    Literals(usize),
    Copy { distance: usize, length: usize },
}

impl<'a> Lzf<'a> {
    /// An unpacker of the next `packed` bytes of the source.
    pub fn new(source: &'a mut Source, packed: u64) -> Self {
        Self { source, left: packed, window: vec![0; WINDOW], done: 0, pending: Pending::Literals(0) }
    }

    /// Packed bytes left.
    pub fn left(&self) -> u64 {
        self.left
    }

    /// Fills `out`; `false` if the packed bytes end before.
    pub fn unpack(&mut self, out: &mut [u8]) -> Result<bool, Error> {
        let mut filled = 0;
        while filled < out.len() {
            let room = out.len() - filled;
            let step = match self.pending {
                Pending::Literals(0) | Pending::Copy { length: 0, .. } => {
                    if !self.control()? {
                        return Ok(false);
                    }
                    0
                }
                Pending::Literals(count) => {
                    match self.literals(&mut out[filled..filled + room.min(count)])? {
                        0 => return Ok(false),
                        step => step,
                    }
                }
                Pending::Copy { distance, length } => {
                    let step = length.min(room);
                    self.copy(distance, &mut out[filled..filled + step]);
                    self.pending = Pending::Copy { distance, length: length - step };
                    step
                }
            };
            filled += step;
        }
        Ok(true)
    }

    /// Reads a control byte and its operands; `false` at the end.
    fn control(&mut self) -> Result<bool, Error> {
        let Some(control) = self.byte()? else { return Ok(false) };
        if control < 32 {
            self.pending = Pending::Literals(usize::from(control) + 1);
            return Ok(true);
        }
        let mut length = usize::from(control >> 5) + 2;
        if control >> 5 == 7 {
            let Some(more) = self.byte()? else { return Ok(false) };
            length += usize::from(more);
        }
        let Some(low) = self.byte()? else { return Ok(false) };
        let distance = (usize::from(control & 31) << 8) + usize::from(low) + 1;
        if distance as u64 > self.done {
            let found = format!("a copy from {distance} bytes back where only {} are unpacked", self.done);
            return Err(self.source.malformed(found, "the compressed columns are damaged"));
        }
        self.pending = Pending::Copy { distance, length };
        Ok(true)
    }

    fn byte(&mut self) -> Result<Option<u8>, Error> {
        if self.left == 0 {
            return Ok(None);
        }
        let Some(&byte) = self.source.peek(1)?.first() else { return Ok(None) };
        self.source.consume(1);
        self.left -= 1;
        Ok(Some(byte))
    }

    /// Takes literal bytes; gives how many, 0 at the end.
    fn literals(&mut self, out: &mut [u8]) -> Result<usize, Error> {
        let Pending::Literals(count) = self.pending else { return Ok(0) };
        let here = self.source.peek(1)?;
        let step = out.len().min(here.len()).min(self.left.min(1 << 20) as usize);
        for (slot, &byte) in out.iter_mut().zip(&here[..step]) {
            *slot = byte;
            self.window[self.done as usize % WINDOW] = byte;
            self.done += 1;
        }
        self.source.consume(step);
        self.left -= step as u64;
        self.pending = Pending::Literals(count - step);
        Ok(step)
    }

    fn copy(&mut self, distance: usize, out: &mut [u8]) {
        for slot in out {
            let byte = self.window[(self.done as usize).wrapping_sub(distance) % WINDOW];
            *slot = byte;
            self.window[self.done as usize % WINDOW] = byte;
            self.done += 1;
        }
    }
}
