//! A network as PLY with elements `vertex` and `edge`, binary little endian.

use super::NetworkContext;
use super::polyline::Polylines;
use lineament::{Network, StripKind};
use std::io::{self, Write};

/// Writes double coordinates and edges of `vertex1`, `vertex2`, `kind` (0 crease, 1 border) and `strip`.
pub(super) fn write(out: &mut dyn Write, network: &Network, context: &NetworkContext) -> io::Result<()> {
    let Polylines { vertices, paths } = Polylines::of(network);
    let edges: usize = paths.iter().map(|path| path.len().saturating_sub(1)).sum();
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\ncomment lineament {}: feature lines\n\
         comment edge kind: 0 crease, 1 border; the first {} vertices are the nodes\n\
         element vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element edge {edges}\nproperty int vertex1\nproperty int vertex2\nproperty uchar kind\n\
         property int strip\nend_header\n",
        context.program_version,
        network.nodes.len(),
        vertices.len(),
    )?;
    for coordinate in vertices.iter().flatten() {
        out.write_all(&coordinate.to_le_bytes())?;
    }
    for (id, (strip, path)) in network.strips.iter().zip(&paths).enumerate() {
        let kind = match strip.kind {
            StripKind::Crease => 0u8,
            StripKind::Border => 1,
        };
        for pair in path.windows(2) {
            out.write_all(&index(pair[0])?.to_le_bytes())?;
            out.write_all(&index(pair[1])?.to_le_bytes())?;
            out.write_all(&[kind])?;
            out.write_all(&index(id)?.to_le_bytes())?;
        }
    }
    Ok(())
}

fn index(value: usize) -> io::Result<i32> {
    let large = |_| io::Error::other(format!("vertex {value} is beyond the 32-bit indices of PLY edges"));
    i32::try_from(value).map_err(large)
}
