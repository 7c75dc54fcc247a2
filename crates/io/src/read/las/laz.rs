//! LAZ: chunks of compressed records. Sizes and counts are checked against the bytes that are there before the
//! decoder sees them, since it takes memory for what it is told; its panics become errors.

use super::chunks::{Chunk, at, chunks};
use super::copc;
use super::header::{Fields, Header, LasFrame, Record};
use super::records;
use crate::columns::Endian;
use crate::error::{Error, Place};
use crate::quiet;
use crate::read::rows::{Field, Table};
use crate::read::{ReadOptions, limit};
use crate::source::{Input, Source};
use laz::record::{LayeredPointRecordDecompressor, RecordDecompressor, SequentialPointRecordDecompressor};
use laz::{DecompressionSelection, LazItem, LazItemType, LazVlr};
use rayon::prelude::*;
use std::io::{Cursor, Seek, SeekFrom};

/// Chunks that are unpacked at a time, side by side, where there are threads for it; as many wait for their place in the table meanwhile.
const BATCH: usize = 4;
/// Unpacked bytes of a chunk beyond which it goes alone.
const LARGE: u64 = 4 << 20;
/// Unpacked bytes that are held at a time of a chunk: they go to the table while they are in the cache.
const STEP: usize = 1 << 17;

/// How the records are packed.
pub(super) struct Packing {
    items: Vec<LazItem>,
    layered: bool,
    /// Layers of a layered chunk.
    layers: usize,
    /// Bytes of a record.
    pub record: usize,
    /// The layers to unpack: without attributes only coordinates.
    selection: DecompressionSelection,
}

/// Points that were there whole, and those that were passed over since they lie outside the bounds.
pub(super) struct Taken {
    pub rows: u64,
    pub passed: u64,
    /// Extended records that say where the points lie; how many others there are, and how many are missing.
    pub projections: Vec<Record>,
    pub extended: (u32, u32),
}

/// Reads the points into the table.
pub(super) fn read(
    source: &mut Source,
    header: &Header,
    frame: &LasFrame,
    options: &ReadOptions,
    fields: &[Field],
    table: &mut Table,
) -> Result<Taken, Error> {
    let (vlr, mut packing) = packing(source, header, frame)?;
    if !options.attributes {
        packing.selection = DecompressionSelection::base().decompress_z();
    }
    let mut input = source.seekable()?;
    let mut projections = Vec::new();
    let extended = extended(source, &mut input, header, &mut projections)?;
    let chunks = match copc::chunks(source, &mut input, header, frame, options)? {
        Some(overlapping) => overlapping,
        None => chunks(source, &mut input, header, &vlr, &packing)?,
    };
    let wanted: u64 = chunks.iter().map(|chunk| chunk.points).sum();
    limit::check(source, options, wanted, table.row_bytes())?;
    table.reserve(wanted as usize);
    let side_by_side = if rayon::current_num_threads() > 1 { BATCH } else { 1 };
    let (unpacking, pattern) = (Unpacking { packing: &packing, fields }, table.part(0));
    let mut waiting = Vec::new();
    let mut result = Ok(());
    for batch in batches(&chunks, packing.record, side_by_side) {
        let mut packed = Vec::new();
        for chunk in batch {
            packed.push(bytes(source, &mut input, chunk)?);
        }
        let before = std::mem::take(&mut waiting);
        // The parts of one batch are put together while the next is unpacked.
        let (unpacked, put) = rayon::join(
            || if batch.len() > 1 { unpacking.all(batch, &mut packed, &pattern) } else { Vec::new() },
            || put(table, before),
        );
        waiting = unpacked;
        result = put.and_then(|()| match (batch, packed.pop()) {
            ([chunk], Some(packed)) => unpacking.one(chunk, packed, table).map_err(|what| (chunk, what)),
            _ => Ok(()),
        });
        if result.is_err() {
            break;
        }
    }
    match result.and_then(|()| put(table, waiting)) {
        Err((chunk, what)) if !options.salvage => Err(broken(source, chunk, &what)),
        _ => {
            let (rows, passed) = (table.positions.len() as u64, header.points.saturating_sub(wanted));
            Ok(Taken { rows, passed, projections, extended })
        }
    }
}

/// The extended records.
fn extended(
    source: &Source,
    input: &mut Input,
    header: &Header,
    records: &mut Vec<Record>,
) -> Result<(u32, u32), Error> {
    let length = input.seek(SeekFrom::End(0)).map_err(|e| source.io(e))?;
    records::extended(header, records, |place, count| {
        let there = place.checked_add(count as u64).is_some_and(|end| end <= length);
        there.then(|| at(source, input, place, count)).transpose()
    })
}

/// A chunk with its rows, or why it cannot be unpacked.
type Unpacked<'a> = (&'a Chunk, Result<Table, String>);

/// Appends the rows of chunks to the table, up to the first that could not be unpacked.
fn put<'a>(table: &mut Table, chunks: Vec<Unpacked<'a>>) -> Result<(), (&'a Chunk, String)> {
    for (chunk, part) in chunks {
        table.join(part.map_err(|what| (chunk, what))?);
    }
    Ok(())
}

/// How records are packed, and where in them the numbers lie.
struct Unpacking<'a> {
    packing: &'a Packing,
    fields: &'a [Field],
}

impl Unpacking<'_> {
    /// Unpacks chunks side by side, taking their packed bytes, each into a table like the pattern.
    fn all<'c>(&self, batch: &'c [Chunk], packed: &mut Vec<Vec<u8>>, pattern: &Table) -> Vec<Unpacked<'c>> {
        let pairs = batch.par_iter().zip(std::mem::take(packed));
        let unpacked = pairs.map(|(chunk, bytes)| {
            let mut part = pattern.part(chunk.points as usize);
            (chunk, self.one(chunk, bytes, &mut part).map(|()| part))
        });
        unpacked.collect()
    }

    /// Unpacks a chunk into a table, some records at a time; nothing of it stays there if it cannot be unpacked whole.
    fn one(&self, chunk: &Chunk, bytes: Vec<u8>, table: &mut Table) -> Result<(), String> {
        let record = self.packing.record;
        let step = (STEP / record).max(1).min(chunk.points as usize);
        let mut rows = vec![0; step * record];
        let mut left = chunk.points;
        let before = table.mark();
        let result = quiet::catch(|| {
            let mut unpacker = unpacker(bytes, self.packing)?;
            while left > 0 {
                let some = left.min(step as u64) as usize * record;
                unpacker.decompress_many(&mut rows[..some]).map_err(|error| error.to_string())?;
                table.append(&rows[..some], record, self.fields, Endian::Little);
                left -= (some / record) as u64;
            }
            Ok(())
        });
        let result = result.unwrap_or_else(|| Err("the decoder gave up".into()));
        result.inspect_err(|_| table.back_to(before))
    }
}

fn broken(source: &Source, chunk: &Chunk, what: &str) -> Error {
    let found =
        format!("the chunk of {} points in {} bytes cannot be unpacked ({what})", chunk.points, chunk.bytes);
    source.fault(Place::Byte(chunk.start), found, "the file is damaged; get it anew, or try --salvage")
}

/// Checks the record that says how points are packed.
fn packing(source: &Source, header: &Header, frame: &LasFrame) -> Result<(LazVlr, Packing), Error> {
    let fail = |found: String| {
        Err(source.malformed(found, "the LAZ record does not fit the points; the file is damaged"))
    };
    let Some(data) = frame.find(LazVlr::USER_ID, LazVlr::RECORD_ID) else {
        return fail("compressed points without the record `laszip encoded`".into());
    };
    let (compressor, coder) = (Fields(data).number::<u16>(), data.get(2).copied().unwrap_or(0));
    let count = data.get(32..).map_or(0, |d| usize::from(Fields(d).number::<u16>()));
    if data.len() < 34 + 6 * count || count == 0 || coder != 0 {
        return fail(format!("a LAZ record of {} bytes with {count} items and coder {coder}", data.len()));
    }
    let vlr = match LazVlr::from_buffer(data) {
        Ok(vlr) => vlr,
        Err(error) => return fail(format!("a LAZ record with {error}")),
    };
    let items = vlr.items().clone();
    let layered = compressor == 3;
    let (mut record, mut layers) = (0, 0);
    for (index, item) in items.iter().enumerate() {
        let (size, adds) = item_size(item.item_type());
        let first = matches!(item.item_type(), LazItemType::Point10 | LazItemType::Point14);
        let fits =
            usize::from(item.size()) == size && first == (index == 0) && layered == (item.version() >= 3);
        if !fits || item.version() == 0 || size == 0 {
            return fail(format!(
                "packed item {index} is {:?} of {} bytes, version {}",
                item.item_type(),
                item.size(),
                item.version()
            ));
        }
        record += size;
        layers += adds;
    }
    if record != header.record_length || !(1..=3).contains(&compressor) || layered != (header.format >= 6) {
        return fail(format!(
            "compressor {compressor} with records of {record} bytes for {}",
            header.record_length
        ));
    }
    let selection = DecompressionSelection::all();
    Ok((vlr, Packing { items, layered, layers, record, selection }))
}

/// Bytes and layers of a packed item.
fn item_size(kind: LazItemType) -> (usize, usize) {
    match kind {
        LazItemType::Byte(count) => (count.into(), 0),
        LazItemType::Point10 => (20, 0),
        LazItemType::GpsTime => (8, 0),
        LazItemType::RGB12 => (6, 0),
        LazItemType::WavePacket13 => (29, 0),
        LazItemType::Point14 => (30, 9),
        LazItemType::RGB14 => (6, 1),
        LazItemType::RGBNIR14 => (8, 2),
        LazItemType::WavePacket14 => (29, 1),
        LazItemType::Byte14(count) => (count.into(), count.into()),
    }
}

/// The packed bytes of a chunk, whose layers are checked against its length.
fn bytes(source: &Source, input: &mut Input, chunk: &Chunk) -> Result<Vec<u8>, Error> {
    at(source, input, chunk.start, chunk.bytes as usize)
}

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

/// Runs of chunks to unpack together.
fn batches(chunks: &[Chunk], record: usize, most: usize) -> impl Iterator<Item = &[Chunk]> {
    let mut rest = chunks;
    std::iter::from_fn(move || {
        let small = rest
            .iter()
            .take(most)
            .take_while(|chunk| chunk.points.saturating_mul(record as u64) <= LARGE)
            .count();
        let (batch, after) = rest.split_at(small.max(1).min(rest.len()));
        rest = after;
        Some(batch).filter(|batch| !batch.is_empty())
    })
}

type Unpacker<'a> = Box<dyn RecordDecompressor<Cursor<Vec<u8>>> + 'a>;

/// A decoder of one chunk.
fn unpacker<'a>(bytes: Vec<u8>, packing: &Packing) -> Result<Unpacker<'a>, String> {
    if packing.layered && !layers_fit(&bytes, packing) {
        return Err("its layers are longer than it is".into());
    }
    let mut unpacker: Unpacker = if packing.layered {
        Box::new(LayeredPointRecordDecompressor::new(Cursor::new(bytes)))
    } else {
        Box::new(SequentialPointRecordDecompressor::new(Cursor::new(bytes)))
    };
    unpacker.set_fields_from(&packing.items).map_err(|error| error.to_string())?;
    unpacker.set_selection(packing.selection);
    Ok(unpacker)
}
