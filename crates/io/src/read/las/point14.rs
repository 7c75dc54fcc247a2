//! The base of LAZ records of point formats 6 to 10 (Isenburg, "LASzip compression of LAS 1.4", third and fourth
//! version): each part of the points of a chunk is a layer of its own bytes. The state left by the points before is kept
//! for each of the four channels of the scanner.

mod channel;
mod layer;
mod point;

use channel::Channel;
use layer::{ANGLE, CLASS, FLAGS, INTENSITY, LAYERS, Layer, PLACE, SOURCE, TIME, USER, Z};
use laz::DecompressionSelection;
use laz::decoders::ArithmeticDecoder;
use laz::record::LayeredFieldDecompressor;
use point::{Point, SIZE};
use std::io::{Cursor, Error, Read, Result, Seek, SeekFrom};

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
