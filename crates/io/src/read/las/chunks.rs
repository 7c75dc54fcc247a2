//! The places of the chunks of a LAZ file: its chunk table, checked against the bytes of the file and the number of
//! points before the decoder sees it.

use super::header::{Fields, Header};
use super::packing::Packing;
use crate::error::{Error, Place};
use crate::quiet;
use crate::source::{Shared, Source};
use laz::LazVlr;
use laz::laszip::ChunkTable;
use std::io::Cursor;
use std::ops::Range;

/// A chunk: where it is, how long, and its points.
pub(super) struct Chunk {
    pub start: u64,
    pub bytes: u64,
    pub points: u64,
}

/// Finds the chunks, and checks that they fit the file and hold the points that the header announces.
pub(super) fn chunks(
    source: &Source,
    input: &Shared,
    header: &Header,
    vlr: &LazVlr,
    packing: &Packing,
) -> Result<Vec<Chunk>, Error> {
    let length = input.length();
    let pointwise = Fields(&vlr_compressor(vlr)).number::<u16>() == 1;
    if pointwise || header.points == 0 {
        let bytes = length.saturating_sub(header.points_at);
        let all = Chunk { start: header.points_at, bytes, points: header.points };
        return Ok(if header.points == 0 { Vec::new() } else { vec![all] });
    }
    let fail = |found: String| {
        let place = Place::Byte(header.points_at);
        Err(source.fault(place, found, "the file is cut or damaged; get it anew"))
    };
    let table_at = table_offset(source, input, header, length)?;
    let first = header.points_at + 8;
    if table_at < first || table_at.checked_add(8).is_none_or(|end| end > length) {
        return fail(format!("a chunk table at byte {table_at} of a file of {length}"));
    }
    let counts = at(source, input, table_at, 8)?;
    let count = u64::from(Fields(&counts[4..]).number::<u32>());
    // Every chunk begins with a record as it is, so that no more chunks than these can be there.
    let most = (table_at - first) / packing.record as u64;
    if count > most {
        return fail(format!("{count} chunks in {} bytes, where at most {most} fit", table_at - first));
    }
    let bytes = at(source, input, table_at, (length - table_at).min(64 + 24 * count) as usize)?;
    let variable = vlr.uses_variable_size_chunks();
    let read = quiet::catch(|| ChunkTable::read(&mut Cursor::new(bytes), variable));
    let Some(Ok(entries)) = read else { return fail("a chunk table that cannot be unpacked".into()) };
    let size = (!variable).then(|| u64::from(vlr.chunk_size()));
    let sized = (0..count as usize).map(|index| {
        let entry = &entries[index];
        (entry.byte_count, size.map_or(Points::Counted(entry.point_count), Points::UpTo))
    });
    let (mut chunks, left) = match placed(sized, first..table_at, header.points, packing.record as u64) {
        Ok(placed) => placed,
        Err(found) => return fail(found),
    };
    chunks.retain(|chunk| chunk.points > 0);
    if left > 0 {
        return Err(source.ends_early("points", header.points, header.points - left));
    }
    Ok(chunks)
}

/// Points of a chunk: counted in the table, or as many as are left, up to the chunk size.
enum Points {
    Counted(u64),
    UpTo(u64),
}

/// Chunks of these bytes and points one after the other within `room`, each of a record at least, and the number of
/// the file's points that are in none.
fn placed(
    sized: impl Iterator<Item = (u64, Points)>,
    room: Range<u64>,
    points: u64,
    record: u64,
) -> Result<(Vec<Chunk>, u64), String> {
    let (mut start, mut left, mut chunks) = (room.start, points, Vec::new());
    for (index, (bytes, points)) in sized.enumerate() {
        let points = match points {
            Points::Counted(points) => points,
            Points::UpTo(size) => size.min(left),
        };
        let end = start.checked_add(bytes).filter(|&end| end <= room.end);
        let Some(end) = end.filter(|_| points <= left && bytes >= record) else {
            return Err(format!("chunk {index} of {points} points in {bytes} bytes, which does not fit"));
        };
        chunks.push(Chunk { start, bytes, points });
        (start, left) = (end, left - points);
    }
    Ok((chunks, left))
}

/// The compressor as it stands in the record.
fn vlr_compressor(vlr: &LazVlr) -> Vec<u8> {
    let mut bytes = Vec::new();
    // Writing into memory does not fail; an empty record reads as compressor 0.
    let _ = vlr.write_to(&mut bytes);
    bytes
}

/// The offset of the chunk table: before the points, or at the end if the writer could not seek back.
fn table_offset(source: &Source, input: &Shared, header: &Header, length: u64) -> Result<u64, Error> {
    if length < header.points_at + 8 {
        return Err(source.ends_early("points", header.points, 0));
    }
    let front = Fields(&at(source, input, header.points_at, 8)?).number::<u64>();
    if front > header.points_at && front < 1 << 63 {
        return Ok(front);
    }
    Ok(Fields(&at(source, input, length - 8, 8)?).number())
}

/// Bytes of the input at a place.
pub(super) fn at(source: &Source, input: &Shared, place: u64, count: usize) -> Result<Vec<u8>, Error> {
    input.at(place, count).map_err(|e| source.io(e))
}
