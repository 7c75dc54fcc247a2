//! A network as PLY with elements `vertex` and `edge`.

use super::context::NetworkContext;
use crate::write::encode::ply;
use crate::write::encode::polyline::Polylines;
use lineament::{Network, StripKind};
use std::io::{self, Write};

/// Writes double coordinates and edges of `vertex1`, `vertex2`, `kind` (0 crease, 1 border) and `strip`.
pub(super) fn write(out: &mut dyn Write, network: &Network, context: &NetworkContext) -> io::Result<()> {
    let Polylines { vertices, paths } = Polylines::of(network);
    let edges = paths.iter().map(|path| path.len().saturating_sub(1)).sum();
    let program = format!("lineament {}: feature lines", context.program_version);
    let nodes = network.nodes.len();
    let kinds = format!("edge kind: 0 crease, 1 border, 2 rounded; the first {nodes} vertices are the nodes");
    let elements =
        [ply::vertices(vertices.len(), &[]), ply::edges(edges, &[("uchar", "kind"), ("int", "strip")])];
    ply::header(out, &[&program, &kinds], &elements)?;
    for &position in &vertices {
        ply::vertex(out, position, &[])?;
    }
    for (id, (strip, path)) in network.strips.iter().zip(&paths).enumerate() {
        let kind = match strip.kind {
            StripKind::Crease => 0u8,
            StripKind::Border => 1,
            StripKind::Rounded => 2,
        };
        let more = [&[kind], &ply::index(id)?.to_le_bytes()[..]].concat();
        for pair in path.windows(2) {
            ply::edge(out, [pair[0], pair[1]], &more)?;
        }
    }
    Ok(())
}
