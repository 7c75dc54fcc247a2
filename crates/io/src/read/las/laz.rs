//! LAZ: chunks of compressed records. Sizes and counts are checked against the bytes of the file before the
//! decoder sees them, since it takes memory for any number it is given; its panics become errors.

use super::chunks::{Chunk, at, chunks};
use super::copc;
use super::header::{Fields, Header, LasFrame, Record};
use super::packing::Packing;
use super::records;
use super::unpacker::unpacker;
use super::walk;
use crate::error::{Error, Place};
use crate::quiet;
use crate::read::rows::{Field, Part, Table};
use crate::read::{ReadOptions, limit};
use crate::source::{Shared, Source};
use laz::{DecompressionSelection, LazItemType, LazVlr};
use rayon::prelude::*;

/// Unpacked bytes that are held at a time of a chunk: they go to the table while they are in the cache.
const STEP: usize = 1 << 17;
/// Chunks that are shared out among threads at a time: a part of the table takes more memory than the least chunk.
const GROUP: usize = 1 << 10;

/// Numbers of whole points, and of those skipped because they lie outside the bounds.
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
        if options.without_noise {
            packing.selection = packing.selection.decompress_classification().decompress_flags();
        }
    }
    let input = source.seekable()?;
    let input = Shared::new(input).map_err(|error| source.io(error))?;
    let mut projections = Vec::new();
    let extended = extended(source, &input, header, &mut projections)?;
    let overlapping = copc::chunks(source, &input, header, frame, options)?;
    let partly = overlapping.is_some();
    let chunks = match overlapping.map_or_else(|| chunks(source, &input, header, &vlr, &packing), Ok) {
        // Without a chunk table, as in a file that was cut, the chunks are found one after the other.
        Err(_) if options.salvage => {
            let whole = walk::whole(&input, header, &vlr, &packing);
            if whole.is_empty() {
                return Err(nothing_whole(source, header));
            }
            whole
        }
        chunks => chunks?,
    };
    let wanted: u64 = chunks.iter().map(|chunk| chunk.points).sum();
    limit::check(source, options, wanted, table.row_bytes())?;
    let rows = match unpack_all(&chunks, &input, &packing, fields, table) {
        Err((chunk, what)) if !options.salvage => return Err(broken(source, &chunks[chunk], &what)),
        Err((chunk, _)) => chunks[..chunk].iter().map(|chunk| chunk.points).sum(),
        Ok(()) => wanted,
    };
    table.truncate(rows as usize);
    let passed = if partly { header.points.saturating_sub(wanted) } else { 0 };
    Ok(Taken { rows, passed, projections, extended })
}

/// The extended records.
fn extended(
    source: &Source,
    input: &Shared,
    header: &Header,
    records: &mut Vec<Record>,
) -> Result<(u32, u32), Error> {
    let length = input.length();
    records::extended(header, records, |place, count| {
        let there = place.checked_add(count as u64).is_some_and(|end| end <= length);
        there.then(|| at(source, input, place, count)).transpose()
    })
}

/// Unpacks all chunks, side by side where there are threads for it, into the table. The error is the first chunk that
/// cannot be unpacked whole, and why.
fn unpack_all(
    chunks: &[Chunk],
    input: &Shared,
    packing: &Packing,
    fields: &[Field],
    table: &mut Table,
) -> Result<(), (usize, String)> {
    table.zeros(chunks.iter().map(|chunk| chunk.points as usize).sum());
    let (mut row, mut before) = (0, 0);
    for group in chunks.chunks(GROUP) {
        let lengths: Vec<usize> = group.iter().map(|chunk| chunk.points as usize).collect();
        let parts = table.parts(row, &lengths).ok_or_else(|| (before, "no grid".into()))?;
        let work = parts.into_par_iter().zip(group).with_max_len(1);
        let unpacked: Vec<Result<usize, String>> =
            work.map(|(part, chunk)| unpack(chunk, input, packing, fields, part)).collect();
        for (index, outside) in unpacked.into_iter().enumerate() {
            table.count_outside(outside.map_err(|what| (before + index, what))?);
        }
        (row, before) = (row + lengths.iter().sum::<usize>(), before + group.len());
    }
    Ok(())
}

/// Unpacks a chunk into its part of the table, some records at a time; gives how many points lie outside the bounds.
fn unpack(
    chunk: &Chunk,
    input: &Shared,
    packing: &Packing,
    fields: &[Field],
    mut part: Part,
) -> Result<usize, String> {
    let bytes = input.at(chunk.start, chunk.bytes as usize).map_err(|error| error.to_string())?;
    let (record, points) = (packing.record, chunk.points as usize);
    let step = (STEP / record).max(1).min(points);
    let mut rows = vec![0; step * record];
    let unpacked = quiet::catch(|| {
        let mut unpacker = unpacker(bytes, packing)?;
        for first in (0..points).step_by(step) {
            let some = &mut rows[..step.min(points - first) * record];
            unpacker.decompress_many(some).map_err(|error| error.to_string())?;
            part.fill(first, some, record, fields);
        }
        Ok(part.outside())
    });
    unpacked.unwrap_or_else(|| Err("the decoder gave up".into()))
}

fn broken(source: &Source, chunk: &Chunk, what: &str) -> Error {
    let found =
        format!("the chunk of {} points in {} bytes cannot be unpacked ({what})", chunk.points, chunk.bytes);
    source.fault(Place::Byte(chunk.start), found, "the file is damaged; get it anew, or try --salvage")
}

/// The error for a file of which no chunk can be salvaged.
fn nothing_whole(source: &Source, header: &Header) -> Error {
    let found = "neither the chunk table nor a whole chunk can be found";
    let advice = "LAZ packs points in chunks, often of 50,000, which unpack as a whole: nothing can be salvaged, get the file anew";
    source.fault(Place::Byte(header.points_at), found, advice)
}

/// Checks the record of the packing.
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
