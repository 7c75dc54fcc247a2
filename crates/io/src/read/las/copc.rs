//! COPC, the cloud optimised form of LAZ (specification 1.0, Hobu 2021): an octree whose nodes are the chunks. With
//! bounds only the nodes that overlap them are read; without, the chunk table leads to all points, as in any LAZ file.

use super::chunks::{Chunk, at};
use super::header::{Fields, Header, LasFrame};
use crate::error::{Error, Place};
use crate::read::ReadOptions;
use crate::source::{Shared, Source};

/// Bytes of an entry of the hierarchy.
const ENTRY: u64 = 32;
/// Levels beyond which no node lies: its cube would be less than the stored integers can tell apart.
const LEVELS: i32 = 31;

/// The cube of the root, and where the hierarchy begins.
struct Info {
    low: [f64; 3],
    size: f64,
    page: (u64, u64),
}

/// One entry: the node's level and place, and its chunk or, with -1 points, a page of more entries.
struct Entry {
    level: i32,
    place: [i32; 3],
    offset: u64,
    bytes: i32,
    points: i32,
}

/// The box looked for, and the place of the octree.
struct Search<'a> {
    source: &'a Source,
    header: &'a Header,
    info: Info,
    bounds: [[f64; 3]; 2],
    length: u64,
}

/// The chunks of the nodes that overlap the bounds, in the order of the file; `None` if the input is no COPC file or
/// there are no bounds.
pub(super) fn chunks(
    source: &Source,
    input: &Shared,
    header: &Header,
    frame: &LasFrame,
    options: &ReadOptions,
) -> Result<Option<Vec<Chunk>>, Error> {
    let (Some(bounds), Some(data)) = (options.bounds, frame.find("copc", 1)) else { return Ok(None) };
    let Some(info) = info(data) else {
        return Err(source.malformed(
            format!("a COPC record of {} bytes", data.len()),
            "its octree has no finite size; the file is damaged, or read it without --bounds",
        ));
    };
    let length = input.length();
    let search = Search { source, header, info, bounds, length };
    let mut chunks = search.walk(input)?;
    chunks.sort_by_key(|chunk| chunk.start);
    if let Some(pair) = chunks.windows(2).find(|pair| pair[0].start + pair[0].bytes > pair[1].start) {
        return Err(search.fault(pair[1].start, "nodes that share a chunk".into()));
    }
    let total = chunks.iter().try_fold(0u64, |sum, chunk| sum.checked_add(chunk.points));
    if total.is_none_or(|total| total > header.points) {
        let found = format!("nodes with more than the {} points of the header", header.points);
        return Err(source.fault(Place::Byte(search.info.page.0), found, "the octree is damaged"));
    }
    Ok(Some(chunks))
}

fn info(data: &[u8]) -> Option<Info> {
    let number = |at: usize| Fields(data.get(at..).unwrap_or(&[])).number::<f64>();
    let (centre, half) = ([number(0), number(8), number(16)], number(24));
    let page = |at: usize| Fields(data.get(at..).unwrap_or(&[])).number::<u64>();
    let sound = data.len() >= 56 && half.is_finite() && half >= 0.0 && centre.iter().all(|c| c.is_finite());
    sound.then(|| Info { low: centre.map(|c| c - half), size: 2.0 * half, page: (page(40), page(48)) })
}

impl Search<'_> {
    /// Follows the pages of the hierarchy, each once at most.
    fn walk(&self, input: &Shared) -> Result<Vec<Chunk>, Error> {
        let mut pages = vec![self.info.page];
        // More bytes of entries than the file has can only be pages that lead to each other.
        let mut left = self.length;
        let mut chunks = Vec::new();
        while let Some((offset, bytes)) = pages.pop() {
            let fits = offset.checked_add(bytes).is_some_and(|end| end <= self.length) && bytes <= left;
            if !fits || bytes % ENTRY != 0 || bytes == 0 {
                return Err(self.fault(offset, format!("a page of the octree of {bytes} bytes")));
            }
            left -= bytes;
            for entry in at(self.source, input, offset, bytes as usize)?.chunks_exact(ENTRY as usize) {
                let entry = entry_of(entry);
                if !(0..=LEVELS).contains(&entry.level) {
                    return Err(self.fault(offset, format!("a node at level {}", entry.level)));
                }
                if !self.overlaps(&entry) || entry.points == 0 {
                    continue;
                }
                let bytes = u64::try_from(entry.bytes).unwrap_or(0);
                match entry.points {
                    -1 => pages.push((entry.offset, bytes)),
                    points => chunks.push(self.chunk(&entry, bytes, points)?),
                }
            }
        }
        Ok(chunks)
    }

    /// The chunk of a node, checked against the file.
    fn chunk(&self, entry: &Entry, bytes: u64, points: i32) -> Result<Chunk, Error> {
        let (start, least) = (entry.offset, self.header.record_length as u64);
        let inside =
            start >= self.header.points_at && start.checked_add(bytes).is_some_and(|e| e <= self.length);
        match u64::try_from(points) {
            Ok(points) if inside && bytes >= least => Ok(Chunk { start, bytes, points }),
            _ => Err(self.fault(start, format!("a node of {points} points in {bytes} bytes"))),
        }
    }

    /// Whether a node may hold points inside the bounds. A step of the grid is allowed for rounding.
    fn overlaps(&self, entry: &Entry) -> bool {
        let size = self.info.size / f64::from(1u32 << entry.level);
        (0..3).all(|a| {
            let low = self.info.low[a] + size * f64::from(entry.place[a]);
            let step = self.header.scale[a].abs() + 1e-9 * self.info.size;
            low - step <= self.bounds[1][a] && low + size + step >= self.bounds[0][a]
        })
    }

    fn fault(&self, place: u64, found: String) -> Error {
        let found = format!("{found} in a file of {}", self.length);
        self.source.fault(Place::Byte(place), found, "the octree is damaged; read the file without --bounds")
    }
}

fn entry_of(bytes: &[u8]) -> Entry {
    let number = |at: usize| Fields(&bytes[at..]).number::<i32>();
    Entry {
        level: number(0),
        place: [number(4), number(8), number(12)],
        offset: Fields(&bytes[16..]).number(),
        bytes: number(24),
        points: number(28),
    }
}
