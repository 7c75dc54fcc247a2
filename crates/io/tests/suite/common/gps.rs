//! LAZ files whose GPS times change their sequence, as scans of several channels do and as damaged files do without end.

use super::las::{file_of, length, put, records};
use laz::compressors::{IntegerCompressor, IntegerCompressorBuilder};
use laz::encoders::ArithmeticEncoder;
use laz::las::v2::{LasExtraByteCompressor, LasPoint0Compressor};
use laz::models::{ArithmeticModel, ArithmeticModelBuilder};
use laz::record::{FieldCompressor, RecordCompressor, SequentialPointRecordCompressor};
use std::io::{Cursor, Write};

/// Where a record of a point format has its GPS time.
pub fn place(format: u8) -> usize {
    if format < 6 { 20 } else { 22 }
}

/// Records with these GPS times.
pub fn with_times(format: u8, times: &[f64]) -> Vec<u8> {
    let mut records = records(format, times.len());
    for (record, time) in records.chunks_exact_mut(length(format)).zip(times) {
        put(record, place(format), &time.to_le_bytes());
    }
    records
}

fn model(symbols: u32) -> ArithmeticModel {
    ArithmeticModelBuilder::new(symbols).with_compression(true).build()
}

fn integers() -> IntegerCompressor {
    IntegerCompressorBuilder::new().bits(32).contexts(9).build_initialized()
}

/// The packed GPS times of point format 6: so many changes of sequence, then steps by one.
fn layer(changes: usize, points: usize) -> Vec<u8> {
    let mut encoder = ArithmeticEncoder::new(Cursor::new(Vec::new()));
    let (mut first, mut step, mut integers) = (model(5), model(515), integers());
    for symbol in std::iter::repeat_n(2, changes).chain([0]) {
        encoder.encode_symbol(&mut first, symbol).unwrap();
    }
    integers.compress(&mut encoder, 0, 1, 0).unwrap();
    for _ in 2..points {
        encoder.encode_symbol(&mut step, 1).unwrap();
        integers.compress(&mut encoder, 1, 1, 1).unwrap();
    }
    encoder.done().unwrap();
    encoder.into_inner().into_inner()
}

/// A file of point format 6 whose second point changes its GPS sequence so many times.
pub fn layered(changes: usize) -> Vec<u8> {
    let format = 6;
    // No two of them in a row are equal, so that all have a place in the layer.
    let times: Vec<f64> = (0..200).map(|i| 3e5 + f64::from(i * 41 % 97) * 0.37).collect();
    let mut file = file_of(format, with_times(format, &times), Some(200), None);
    let at =
        |file: &[u8], place: usize| u32::from_le_bytes(file[place..place + 4].try_into().unwrap()) as usize;
    let sizes = at(&file, 96) + 8 + length(format) + 4;
    let layers = 9 + length(format) - 30;
    let before: usize = (0..8).map(|layer| at(&file, sizes + 4 * layer)).sum();
    let (start, room) = (sizes + 4 * layers + before, at(&file, sizes + 32));
    let layer = layer(changes, times.len());
    assert!(layer.len() <= room, "{} of {room}", layer.len());
    file[start..start + room].fill(0);
    put(&mut file, start, &layer);
    file
}

/// The packed GPS times of point format 1 of which each but the first comes after so many changes of sequence.
struct Changes {
    model: ArithmeticModel,
    counts: std::vec::IntoIter<usize>,
}

impl<W: Write> FieldCompressor<W> for Changes {
    fn size_of_field(&self) -> usize {
        8
    }

    fn compress_first(&mut self, out: &mut W, time: &[u8]) -> std::io::Result<()> {
        out.write_all(time)
    }

    fn compress_with(&mut self, encoder: &mut ArithmeticEncoder<W>, _: &[u8]) -> std::io::Result<()> {
        for symbol in std::iter::repeat_n(3, self.counts.next().unwrap_or(0)).chain([0]) {
            encoder.encode_symbol(&mut self.model, symbol)?;
        }
        Ok(())
    }
}

/// A file of point format 1, packed without chunks, whose points but the first change their GPS sequence so many times.
pub fn pointwise(counts: Vec<usize>) -> Vec<u8> {
    let records = with_times(1, &vec![0.0; counts.len() + 1]);
    let mut packer = SequentialPointRecordCompressor::new(Cursor::new(Vec::new()));
    packer.add_field_compressor(LasPoint0Compressor::default());
    packer.add_field_compressor(Changes { model: model(6), counts: counts.into_iter() });
    packer.add_field_compressor(LasExtraByteCompressor::new(length(1) - 28));
    packer.compress_many(&records).unwrap();
    packer.done().unwrap();
    let mut file = file_of(1, records, Some(1 << 20), None);
    file.truncate(u32::from_le_bytes(file[96..100].try_into().unwrap()) as usize);
    // The last record before the points says how they are packed, of three items.
    let laz = file.len() - 34 - 3 * 6;
    put(&mut file, laz, &[1, 0]);
    file.extend(packer.into_inner().into_inner());
    file
}
