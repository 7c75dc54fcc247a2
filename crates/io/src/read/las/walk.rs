//! The whole chunks of a LAZ file without its chunk table, which stands at the end and is lost first where a file was cut. A chunk
//! of layers tells its length; a chunk of records ends where its decoder has read the last of them (Isenburg 2013).

use super::chunks::Chunk;
use super::header::{Fields, Header};
use super::packing::Packing;
use super::unpacker::unpacker;
use crate::quiet;
use crate::source::Shared;
use laz::LazVlr;

/// Bytes of the offset of the chunk table, before the first chunk.
const OFFSET: u64 = 8;
/// Times its records that a packed chunk may be long: packing lengthens no more than a little.
const LONGEST: u64 = 2;
/// Records that are unpacked at a time.
const STEP: usize = 1 << 10;

/// The chunks from the first up to the one that the end of the file cuts.
pub(super) fn whole(input: &Shared, header: &Header, vlr: &LazVlr, packing: &Packing) -> Vec<Chunk> {
    let (mut start, mut left, mut chunks) =
        (header.points_at.saturating_add(OFFSET), header.points, Vec::new());
    while left > 0 {
        let found = if packing.layered {
            layered(input, start, packing)
        } else if vlr.uses_variable_size_chunks() {
            None
        } else {
            pointwise(input, start, u64::from(vlr.chunk_size()).min(left), packing)
        };
        let Some((bytes, points)) = found.filter(|(_, points)| (1..=left).contains(points)) else { break };
        chunks.push(Chunk { start, bytes, points });
        (start, left) = (start + bytes, left - points);
    }
    chunks
}

/// Bytes and points of a chunk of layers: a record, the number of points, the sizes of the layers, the layers.
fn layered(input: &Shared, start: u64, packing: &Packing) -> Option<(u64, u64)> {
    let head = input.at(start, packing.record + 4 + 4 * packing.layers).ok()?;
    let mut numbers = head[packing.record..].chunks_exact(4).map(|n| u64::from(Fields(n).number::<u32>()));
    let points = numbers.next()?;
    let bytes = head.len() as u64 + numbers.sum::<u64>();
    (start.checked_add(bytes)? <= input.length()).then_some((bytes, points))
}

/// Bytes of a chunk of so many records, which are unpacked to find its end.
fn pointwise(input: &Shared, start: u64, points: u64, packing: &Packing) -> Option<(u64, u64)> {
    let most = points.checked_mul(LONGEST * packing.record as u64)?.saturating_add(1 << 10);
    let bytes = input.at(start, most.min(input.length().checked_sub(start)?) as usize).ok()?;
    let unpacked = quiet::catch(|| {
        let mut unpacker = unpacker(bytes, packing)?;
        let mut rows = vec![0; STEP * packing.record];
        let mut left = points as usize;
        while left > 0 {
            let some = left.min(STEP);
            unpacker
                .decompress_many(&mut rows[..some * packing.record])
                .map_err(|error| error.to_string())?;
            left -= some;
        }
        Ok::<u64, String>(unpacker.get().position())
    });
    Some((unpacked?.ok()?, points))
}
