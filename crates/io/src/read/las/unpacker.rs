//! Decoders of the chunks of a LAZ file.

use super::gps::GpsTime;
use super::header::Fields;
use super::packing::Packing;
use super::point14::Point14;
use laz::LazItemType;
use laz::record::{LayeredPointRecordDecompressor, RecordDecompressor, SequentialPointRecordDecompressor};
use std::io::Cursor;

/// Whether the layers that a chunk announces are in it.
fn layers_fit(bytes: &[u8], packing: &Packing) -> bool {
    let Some(sizes) = bytes.get(packing.record + 4..) else { return false };
    if sizes.len() < 4 * packing.layers {
        return false;
    }
    let total: u64 =
        sizes.chunks_exact(4).take(packing.layers).map(|s| u64::from(Fields(s).number::<u32>())).sum();
    total <= (sizes.len() - 4 * packing.layers) as u64
}

pub(super) type Unpacker = Box<dyn RecordDecompressor<Cursor<Vec<u8>>>>;

/// A decoder of one chunk. Fields with GPS times are decoded here, all others by `laz`.
pub(super) fn unpacker(bytes: Vec<u8>, packing: &Packing) -> Result<Unpacker, String> {
    if packing.layered && !layers_fit(&bytes, packing) {
        return Err("its layers are longer than it is".into());
    }
    let mut unpacker = if packing.layered { layered(bytes, packing) } else { pointwise(bytes, packing) }
        .map_err(|error| error.to_string())?;
    unpacker.set_selection(packing.selection);
    Ok(unpacker)
}

fn layered(bytes: Vec<u8>, packing: &Packing) -> laz::Result<Unpacker> {
    let mut unpacker = LayeredPointRecordDecompressor::new(Cursor::new(bytes));
    for item in &packing.items {
        match item.item_type() {
            LazItemType::Point14 if item.version() <= 4 => {
                unpacker.add_field_decompressor(Point14::new(item.version()))
            }
            _ => unpacker.set_fields_from(&vec![*item])?,
        }
    }
    Ok(Box::new(unpacker))
}

fn pointwise(bytes: Vec<u8>, packing: &Packing) -> laz::Result<Unpacker> {
    let mut unpacker = SequentialPointRecordDecompressor::new(Cursor::new(bytes));
    for item in &packing.items {
        match (item.item_type(), item.version()) {
            (LazItemType::GpsTime, 2) => unpacker.add_field_decompressor(GpsTime::default()),
            _ => unpacker.set_fields_from(&vec![*item])?,
        }
    }
    Ok(Box::new(unpacker))
}
