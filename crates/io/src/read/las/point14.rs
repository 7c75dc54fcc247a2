//! The base of LAZ records of point formats 6 to 10 (Isenburg, "LASzip compression of LAS 1.4", third and fourth
//! version): each part of the points of a chunk is a layer of its own bytes. What is known of the points before is kept
//! for each of the four channels of the scanner.

use super::gps::Times;
use super::median::Median;
use laz::DecompressionSelection;
use laz::decoders::ArithmeticDecoder;
use laz::decompressors::{IntegerDecompressor, IntegerDecompressorBuilder};
use laz::models::{ArithmeticModel, ArithmeticModelBuilder};
use laz::record::LayeredFieldDecompressor;
use std::io::{Cursor, Error, Read, Result, Seek, SeekFrom};

const SIZE: usize = 30;

/// Layers in the order in which they are stored.
const PLACE: usize = 0;
const Z: usize = 1;
const CLASS: usize = 2;
const FLAGS: usize = 3;
const INTENSITY: usize = 4;
const ANGLE: usize = 5;
const USER: usize = 6;
const SOURCE: usize = 7;
const TIME: usize = 8;
const LAYERS: usize = 9;

/// Which of six kinds a pulse with `n` returns (row) is at return `r` (column).
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

type Decoder = ArithmeticDecoder<Cursor<Vec<u8>>>;

/// A layer: whether it is wanted, its bytes, and whether they are there to be decoded.
struct Layer {
    wanted: bool,
    size: usize,
    used: bool,
    decoder: Decoder,
}

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

/// A record.
#[derive(Clone, Copy)]
struct Point {
    place: [i32; 3],
    intensity: u16,
    /// The number of the return, and of how many.
    returns: (u8, u8),
    flags: u8,
    class: u8,
    user: u8,
    angle: i16,
    source: u16,
    /// Bits of the GPS time.
    time: i64,
}

impl Point {
    fn unpack(b: &[u8; SIZE]) -> Self {
        let number = |at: usize| i32::from_le_bytes([b[at], b[at + 1], b[at + 2], b[at + 3]]);
        let mut time = [0; 8];
        time.copy_from_slice(&b[22..]);
        Self {
            place: [number(0), number(4), number(8)],
            intensity: u16::from_le_bytes([b[12], b[13]]),
            returns: (b[14] & 15, b[14] >> 4),
            flags: b[15],
            class: b[16],
            user: b[17],
            angle: i16::from_le_bytes([b[18], b[19]]),
            source: u16::from_le_bytes([b[20], b[21]]),
            time: i64::from_le_bytes(time),
        }
    }

    fn pack(&self, out: &mut [u8]) {
        for (axis, value) in self.place.iter().enumerate() {
            out[4 * axis..4 * axis + 4].copy_from_slice(&value.to_le_bytes());
        }
        out[12..14].copy_from_slice(&self.intensity.to_le_bytes());
        out[14] = self.returns.1 << 4 | self.returns.0;
        (out[15], out[16], out[17]) = (self.flags, self.class, self.user);
        out[18..20].copy_from_slice(&self.angle.to_le_bytes());
        out[20..22].copy_from_slice(&self.source.to_le_bytes());
        out[22..SIZE].copy_from_slice(&self.time.to_le_bytes());
    }
}

/// What is known of a channel.
struct Channel {
    last: Point,
    /// Whether the last point had another time than the one before.
    timed: bool,
    intensities: [u16; 8],
    heights: [i32; 8],
    steps: [[Median; 12]; 2],
    changed: Models,
    channels: ArithmeticModel,
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
    fn new(last: &Point) -> Self {
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
    fn differences(&mut self, layer: &mut Layer) -> Result<u32> {
        let (r, n) = self.last.returns;
        let state = usize::from(r == 1) + 2 * usize::from(r >= n) + 4 * usize::from(self.timed);
        layer.decoder.decode_symbol(self.changed.at(state))
    }

    /// Decodes the number of the return, and of how many.
    fn returns(&mut self, layer: &mut Layer, differences: u32, timed: bool) -> Result<()> {
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
    fn place(&mut self, layers: &mut [Layer; LAYERS], timed: bool) -> Result<()> {
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
    fn attributes(&mut self, layers: &mut [Layer; LAYERS], differences: u32, timed: bool) -> Result<()> {
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

    fn time(&mut self, layer: &mut Layer) -> Result<()> {
        if layer.used {
            let times = self.times.get_or_insert_with(|| Times::new(self.last.time, false));
            self.last.time = times.next(&mut layer.decoder)?;
        }
        Ok(())
    }
}

/// The decoder of one chunk.
pub(super) struct Point14 {
    /// Whether the other fields of a record learn its channel although it is that of the last one: the fourth version.
    told: bool,
    layers: [Layer; LAYERS],
    channel: usize,
    channels: [Option<Box<Channel>>; 4],
}

impl Point14 {
    pub(super) fn new(version: u16) -> Self {
        let decoder = || ArithmeticDecoder::new(Cursor::new(Vec::new()));
        let layer = || Layer { wanted: true, size: 0, used: false, decoder: decoder() };
        Self {
            told: version == 4,
            layers: std::array::from_fn(|_| layer()),
            channel: 0,
            channels: [const { None }; 4],
        }
    }

    /// Decodes a change of channel; one that is new begins with the last point of the one before.
    fn change(&mut self) -> Result<()> {
        let Some(now) = &mut self.channels[self.channel] else { return Err(no_first()) };
        let by = self.layers[PLACE].decoder.decode_symbol(&mut now.channels)? as usize;
        let last = now.last;
        self.channel = (self.channel + by + 1) % 4;
        let next = self.channels[self.channel].get_or_insert_with(|| Box::new(Channel::new(&last)));
        next.last.flags = next.last.flags & !0b11_0000 | (self.channel as u8) << 4;
        Ok(())
    }
}

fn no_first() -> Error {
    Error::other("no first point")
}

impl<R: Read + Seek> LayeredFieldDecompressor<R> for Point14 {
    fn size_of_field(&self) -> usize {
        SIZE
    }

    fn set_selection(&mut self, selection: DecompressionSelection) {
        self.layers[Z].wanted = selection.should_decompress_z();
        self.layers[CLASS].wanted = selection.should_decompress_classification();
        self.layers[FLAGS].wanted = selection.should_decompress_flags();
        self.layers[INTENSITY].wanted = selection.should_decompress_intensity();
        self.layers[ANGLE].wanted = selection.should_decompress_scan_angle();
        self.layers[USER].wanted = selection.should_decompress_user_data();
        self.layers[SOURCE].wanted = selection.should_decompress_point_source_id();
        self.layers[TIME].wanted = selection.should_decompress_gps_time();
    }

    fn init_first_point(&mut self, bytes: &mut R, out: &mut [u8], context: &mut usize) -> Result<()> {
        let mut first = [0; SIZE];
        bytes.read_exact(&mut first)?;
        out.copy_from_slice(&first);
        let point = Point::unpack(&first);
        self.channel = usize::from(point.flags >> 4 & 3);
        self.channels[self.channel] = Some(Box::new(Channel::new(&point)));
        *context = self.channel;
        Ok(())
    }

    fn decompress_field_with(&mut self, out: &mut [u8], context: &mut usize) -> Result<()> {
        let Some(now) = &mut self.channels[self.channel] else { return Err(no_first()) };
        let differences = now.differences(&mut self.layers[PLACE])?;
        let (changes, timed) = (differences & 64 != 0, differences & 16 != 0);
        if changes {
            self.change()?;
        }
        if changes || self.told {
            *context = self.channel;
        }
        let Some(now) = &mut self.channels[self.channel] else { return Err(no_first()) };
        now.returns(&mut self.layers[PLACE], differences, timed)?;
        now.place(&mut self.layers, timed)?;
        now.attributes(&mut self.layers, differences, timed)?;
        if timed {
            now.time(&mut self.layers[TIME])?;
        }
        now.timed = timed;
        now.last.pack(out);
        Ok(())
    }

    fn read_layers_sizes(&mut self, bytes: &mut R) -> Result<()> {
        for layer in &mut self.layers {
            let mut size = [0; 4];
            bytes.read_exact(&mut size)?;
            layer.size = u32::from_le_bytes(size) as usize;
        }
        Ok(())
    }

    fn read_layers(&mut self, bytes: &mut R) -> Result<()> {
        for layer in self.layers.iter_mut().filter(|layer| layer.size > 0) {
            layer.used = layer.wanted;
            if layer.wanted {
                let mut packed = vec![0; layer.size];
                bytes.read_exact(&mut packed)?;
                layer.decoder = ArithmeticDecoder::new(Cursor::new(packed));
                layer.decoder.read_init_bytes()?;
            } else {
                bytes.seek(SeekFrom::Current(layer.size as i64))?;
            }
        }
        Ok(())
    }
}
