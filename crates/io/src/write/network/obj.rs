//! A network as Wavefront OBJ lines: a vertex for each node, and an `l` statement for each strip.

use super::context::NetworkContext;
use crate::write::encode::polyline::Polylines;
use lineament::Network;
use std::io::{self, Write};

/// Writes `v` and `l` statements; a closed strip's `l` repeats its first vertex. Objects are named by strip and
/// groups by kind. Coordinates are the shortest decimals that give the same f64 back.
pub(super) fn write(out: &mut dyn Write, network: &Network, context: &NetworkContext) -> io::Result<()> {
    let Polylines { vertices, paths } = Polylines::of(network);
    writeln!(out, "# lineament {}: feature lines", context.program_version)?;
    for [x, y, z] in vertices {
        writeln!(out, "v {x:?} {y:?} {z:?}")?;
    }
    for (id, (strip, path)) in network.strips.iter().zip(&paths).enumerate() {
        if path.len() < 2 {
            continue;
        }
        write!(out, "o strip_{id}\ng {}\nl", strip.kind.name())?;
        for vertex in path {
            write!(out, " {}", vertex + 1)?;
        }
        writeln!(out)?;
    }
    Ok(())
}
