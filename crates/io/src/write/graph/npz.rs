//! A neighbour graph as NPZ: `xyz` of (N, 3) f8, `edges` of (E, 2) u4, `length` of (E) f8, and `cut` of (E) u1 where the edges
//! that cross a line are there.

use super::table::GraphTable;
use crate::write::encode::zip::ZipWriter;
use crate::write::points::npy::{blocks, header};
use std::io::{self, Write};

/// Writes an archive of arrays that are stored as they are, so that NumPy can map them.
pub(super) fn write(out: &mut dyn Write, table: &GraphTable) -> io::Result<()> {
    let (points, count) = (table.cloud.len(), table.count());
    let mut archive = ZipWriter::new(out);
    archive.add("xyz.npy", &|out| {
        out.write_all(&header("<f8", &format!("{points}, 3")))?;
        blocks(out, table.cloud.positions.as_flattened())
    })?;
    let edges: Vec<[u32; 2]> = table.edges().map(|(edge, _)| edge).collect();
    archive.add("edges.npy", &|out| {
        out.write_all(&header("<u4", &format!("{count}, 2")))?;
        blocks(out, edges.as_flattened())
    })?;
    let lengths: Vec<f64> = edges.iter().map(|&edge| table.length(edge)).collect();
    archive.add("length.npy", &|out| {
        out.write_all(&header("<f8", &format!("{count},")))?;
        blocks(out, &lengths)
    })?;
    if table.all {
        let cut: Vec<u8> = table.edges().map(|(_, cut)| u8::from(cut)).collect();
        archive.add("cut.npy", &|out| {
            out.write_all(&header("|u1", &format!("{count},")))?;
            out.write_all(&cut)
        })?;
    }
    archive.finish()
}
