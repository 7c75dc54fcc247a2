//! GPS times of LAZ (Isenburg 2013, second and third version): four sequences of times, each with its last step. The
//! `laz` crate follows a change of sequence by recursion, and two kilobytes can ask for a million changes in a row,
//! which no stack holds and no handler catches; here they are counted.

use laz::decoders::ArithmeticDecoder;
use laz::decompressors::{IntegerDecompressor, IntegerDecompressorBuilder};
use laz::models::{ArithmeticModel, ArithmeticModelBuilder};
use laz::record::FieldDecompressor;
use std::io::{Error, Read, Result};

/// Sequences; a packer changes at most once to find the right one, and after as many changes it has seen them all.
const SEQUENCES: usize = 4;
/// The multiple of the last step from which on it is a coarse guess, and that beyond it, counted backwards from there.
const MOST: u32 = 500;
const LEAST: u32 = 510;
/// The code of a time that is given whole; a change of sequence by one comes next.
const WHOLE: u32 = LEAST + 1;

/// The state left by the times so far.
pub(super) struct Times {
    /// Whether a time that stays is a code, as in the second version. In the third it is a bit of the point.
    stays: bool,
    /// The sequence of the last time, and the one that was begun last.
    last: usize,
    newest: usize,
    /// The bits of the last time of each sequence, its last step, and how often a step was far from it.
    times: [i64; SEQUENCES],
    steps: [i32; SEQUENCES],
    far: [u32; SEQUENCES],
    /// Models of the codes of a sequence without a step and with one, and of the differences.
    without: ArithmeticModel,
    with: ArithmeticModel,
    integers: IntegerDecompressor,
}

impl Times {
    pub(super) fn new(first: i64, stays: bool) -> Self {
        let more = u32::from(stays);
        Self {
            stays,
            last: 0,
            newest: 0,
            times: [first, 0, 0, 0],
            steps: [0; SEQUENCES],
            far: [0; SEQUENCES],
            without: ArithmeticModelBuilder::new(5 + more).build(),
            with: ArithmeticModelBuilder::new(WHOLE + 4 + more).build(),
            integers: IntegerDecompressorBuilder::new().bits(32).contexts(9).build_initialized(),
        }
    }

    /// The bits of the next time.
    pub(super) fn next<R: Read>(&mut self, decoder: &mut ArithmeticDecoder<R>) -> Result<i64> {
        for _ in 0..=SEQUENCES {
            let change = if self.steps[self.last] == 0 { self.first(decoder) } else { self.step(decoder) }?;
            if change == 0 {
                return Ok(self.times[self.last]);
            }
            self.last = (self.last + change) % SEQUENCES;
        }
        Err(Error::other("its GPS times change their sequence without end"))
    }

    /// Decodes a time of a sequence without a step; gives by how much the sequence changes instead.
    fn first<R: Read>(&mut self, decoder: &mut ArithmeticDecoder<R>) -> Result<usize> {
        let code = decoder.decode_symbol(&mut self.without)?;
        match code.checked_sub(u32::from(self.stays)) {
            None => {}
            Some(0) => {
                self.steps[self.last] = self.integers.decompress(decoder, 0, 0)?;
                self.add(self.steps[self.last]);
                self.far[self.last] = 0;
            }
            Some(1) => self.whole(decoder)?,
            Some(code) => return Ok(code as usize - 1),
        }
        Ok(0)
    }

    /// Decodes a time as a multiple of the step of its sequence; gives by how much the sequence changes instead.
    fn step<R: Read>(&mut self, decoder: &mut ArithmeticDecoder<R>) -> Result<usize> {
        let code = decoder.decode_symbol(&mut self.with)?;
        if code < WHOLE {
            self.multiple(decoder, code)?;
            return Ok(0);
        }
        match (code - WHOLE).checked_sub(u32::from(self.stays)) {
            None => {}
            Some(0) => self.whole(decoder)?,
            Some(change) => return Ok(change as usize),
        }
        Ok(0)
    }

    fn multiple<R: Read>(&mut self, decoder: &mut ArithmeticDecoder<R>, code: u32) -> Result<()> {
        let (factor, context) = match code {
            0 => (0, 7),
            1 => (1, 1),
            2..10 => (code as i32, 2),
            10..MOST => (code as i32, 3),
            MOST => (MOST as i32, 4),
            LEAST => (MOST as i32 - LEAST as i32, 6),
            _ => (MOST as i32 - code as i32, 5),
        };
        let guess = self.steps[self.last].wrapping_mul(factor);
        let step = self.integers.decompress(decoder, guess, context)?;
        self.add(step);
        match code {
            1 => self.far[self.last] = 0,
            0 | MOST | LEAST => self.note_far(step),
            _ => {}
        }
        Ok(())
    }

    /// A step far from the last one becomes the step of the sequence at the fourth time.
    fn note_far(&mut self, step: i32) {
        self.far[self.last] += 1;
        if self.far[self.last] > 3 {
            self.steps[self.last] = step;
            self.far[self.last] = 0;
        }
    }

    fn add(&mut self, step: i32) {
        self.times[self.last] = self.times[self.last].wrapping_add(step.into());
    }

    /// Begins a sequence with a time given whole.
    fn whole<R: Read>(&mut self, decoder: &mut ArithmeticDecoder<R>) -> Result<()> {
        let high = self.integers.decompress(decoder, (self.times[self.last] >> 32) as i32, 8)?;
        self.newest = (self.newest + 1) % SEQUENCES;
        self.last = self.newest;
        self.times[self.last] = i64::from(high) << 32 | i64::from(decoder.read_int()?);
        (self.steps[self.last], self.far[self.last]) = (0, 0);
        Ok(())
    }
}

/// The times of point formats 1, 3, 4 and 5, as a field of their records.
#[derive(Default)]
pub(super) struct GpsTime(Option<Times>);

impl<R: Read> FieldDecompressor<R> for GpsTime {
    fn size_of_field(&self) -> usize {
        8
    }

    fn decompress_first(&mut self, bytes: &mut R, out: &mut [u8]) -> Result<()> {
        let mut first = [0; 8];
        bytes.read_exact(&mut first)?;
        out.copy_from_slice(&first);
        self.0 = Some(Times::new(i64::from_le_bytes(first), true));
        Ok(())
    }

    fn decompress_with(&mut self, decoder: &mut ArithmeticDecoder<R>, out: &mut [u8]) -> Result<()> {
        let times = self.0.as_mut().ok_or_else(|| Error::other("no first time"))?;
        out.copy_from_slice(&times.next(decoder)?.to_le_bytes());
        Ok(())
    }
}
