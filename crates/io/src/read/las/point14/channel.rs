//! A channel of the scanner: models of its points, and the fields that they decode.

use super::layer::{ANGLE, CLASS, FLAGS, INTENSITY, LAYERS, Layer, PLACE, SOURCE, USER, Z};
use super::point::Point;
use crate::read::las::gps::Times;
use crate::read::las::median::Median;
use laz::decompressors::{IntegerDecompressor, IntegerDecompressorBuilder};
use laz::models::{ArithmeticModel, ArithmeticModelBuilder};
use std::io::Result;

/// The kind, of six, of return `r` (column) of a pulse with `n` returns (row).
const KINDS: [&[u8; 16]; 16] = [
    b"0123453445555555",
    b"1013333333333333",
    b"2124444444433333",
    b"3345444444444444",
    b"4344544444444444",
    b"5344454444444444",
    b"3344445444444444",
    b"4344444544444444",
    b"4344444454444444",
    b"5344444445444444",
    b"5344444444544444",
    b"5334444444455444",
    b"5334444444455544",
    b"5334444444445554",
    b"5334444444444555",
    b"5334444444444455",
];

/// Models that are made when they are first needed.
struct Models {
    symbols: u32,
    all: Vec<Option<ArithmeticModel>>,
}

impl Models {
    fn new(count: usize, symbols: u32) -> Self {
        Self { symbols, all: vec![None; count] }
    }

    #[inline]
    fn at(&mut self, index: usize) -> &mut ArithmeticModel {
        let symbols = self.symbols;
        self.all[index].get_or_insert_with(|| ArithmeticModelBuilder::new(symbols).build())
    }
}

/// The state of a channel.
pub(super) struct Channel {
    pub last: Point,
    /// Whether the last point had another time than the one before.
    pub timed: bool,
    intensities: [u16; 8],
    heights: [i32; 8],
    steps: [[Median; 12]; 2],
    changed: Models,
    pub channels: ArithmeticModel,
    counts: Models,
    returns: Models,
    returns_of_pulse: ArithmeticModel,
    classes: Models,
    flags: Models,
    users: Models,
    x: IntegerDecompressor,
    y: IntegerDecompressor,
    z: IntegerDecompressor,
    intensity: IntegerDecompressor,
    angle: IntegerDecompressor,
    source: IntegerDecompressor,
    times: Option<Times>,
}

fn integers(bits: u32, contexts: u32) -> IntegerDecompressor {
    IntegerDecompressorBuilder::new().bits(bits).contexts(contexts).build_initialized()
}

impl Channel {
    pub fn new(last: &Point) -> Self {
        Self {
            last: *last,
            timed: false,
            intensities: [last.intensity; 8],
            heights: [last.place[2]; 8],
            steps: [[Median::new(); 12]; 2],
            changed: Models::new(8, 128),
            channels: ArithmeticModelBuilder::new(3).build(),
            counts: Models::new(16, 16),
            returns: Models::new(16, 16),
            returns_of_pulse: ArithmeticModelBuilder::new(13).build(),
            classes: Models::new(64, 256),
            flags: Models::new(64, 64),
            users: Models::new(64, 256),
            x: integers(32, 2),
            y: integers(32, 22),
            z: integers(32, 20),
            intensity: integers(16, 4),
            angle: integers(16, 2),
            source: integers(16, 1),
            times: None,
        }
    }

    /// Decodes which parts of the next point differ, as bits.
    pub fn differences(&mut self, layer: &mut Layer) -> Result<u32> {
        let (r, n) = self.last.returns;
        let state = usize::from(r == 1) + 2 * usize::from(r >= n) + 4 * usize::from(self.timed);
        layer.decoder.decode_symbol(self.changed.at(state))
    }

    /// Decodes the number of the return, and of how many.
    pub fn returns(&mut self, layer: &mut Layer, differences: u32, timed: bool) -> Result<()> {
        let (r, mut n) = self.last.returns;
        if differences & 4 != 0 {
            n = layer.decoder.decode_symbol(self.counts.at(n.into()))? as u8 & 15;
        }
        let r = match differences & 3 {
            0 => r,
            1 => r + 1,
            2 => r + 15,
            _ if timed => layer.decoder.decode_symbol(self.returns.at(r.into()))? as u8,
            _ => r + 2 + layer.decoder.decode_symbol(&mut self.returns_of_pulse)? as u8,
        };
        self.last.returns = (r & 15, n);
        Ok(())
    }

    /// Decodes where the point lies.
    pub fn place(&mut self, layers: &mut [Layer; LAYERS], timed: bool) -> Result<()> {
        let (r, n) = self.last.returns;
        let kind = usize::from(KINDS[usize::from(n)][usize::from(r)] - b'0') << 1 | usize::from(timed);
        let single = u32::from(n == 1);
        let decoder = &mut layers[PLACE].decoder;
        let step = self.x.decompress(decoder, self.steps[0][kind].get(), single)?;
        self.last.place[0] = self.last.place[0].wrapping_add(step);
        self.steps[0][kind].add(step);
        let context = single + (self.x.k() & !1).min(20);
        let step = self.y.decompress(decoder, self.steps[1][kind].get(), context)?;
        self.last.place[1] = self.last.place[1].wrapping_add(step);
        self.steps[1][kind].add(step);
        if layers[Z].used {
            let context = single + (u32::midpoint(self.x.k(), self.y.k()) & !1).min(18);
            let last = &mut self.heights[usize::from(n.abs_diff(r).min(7))];
            *last = self.z.decompress(&mut layers[Z].decoder, *last, context)?;
            self.last.place[2] = *last;
        }
        Ok(())
    }

    /// Decodes everything else but the time.
    pub fn attributes(&mut self, layers: &mut [Layer; LAYERS], differences: u32, timed: bool) -> Result<()> {
        let point = &mut self.last;
        let (r, n) = point.returns;
        let order = 2 * u32::from(r == 1) + u32::from(r >= n);
        if layers[CLASS].used {
            let model = self.classes.at(usize::from(point.class & 31) << 1 | usize::from(order == 3));
            point.class = layers[CLASS].decoder.decode_symbol(model)? as u8;
        }
        if layers[FLAGS].used {
            // Without the bits of the channel, which stand between.
            let model = self.flags.at((point.flags >> 2 & 0b11_0000 | point.flags & 15).into());
            let flags = layers[FLAGS].decoder.decode_symbol(model)? as u8;
            point.flags = (flags & 0b11_0000) << 2 | point.flags & 0b11_0000 | flags & 15;
        }
        if layers[INTENSITY].used {
            let last = &mut self.intensities[(order << 1) as usize | usize::from(timed)];
            let decoder = &mut layers[INTENSITY].decoder;
            *last = self.intensity.decompress(decoder, (*last).into(), order)? as u16;
            point.intensity = *last;
        }
        if layers[ANGLE].used && differences & 8 != 0 {
            let decoder = &mut layers[ANGLE].decoder;
            point.angle = self.angle.decompress(decoder, point.angle.into(), timed.into())? as i16;
        }
        if layers[USER].used {
            let model = self.users.at((point.user >> 2).into());
            point.user = layers[USER].decoder.decode_symbol(model)? as u8;
        }
        if layers[SOURCE].used && differences & 32 != 0 {
            let decoder = &mut layers[SOURCE].decoder;
            point.source = self.source.decompress(decoder, point.source.into(), 0)? as u16;
        }
        Ok(())
    }

    pub fn time(&mut self, layer: &mut Layer) -> Result<()> {
        if layer.used {
            let times = self.times.get_or_insert_with(|| Times::new(self.last.time, false));
            self.last.time = times.next(&mut layer.decoder)?;
        }
        Ok(())
    }
}
