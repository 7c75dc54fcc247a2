//! A network as CSV: a row for each point of each strip.

use lineament::Network;
use std::io::{self, Write};

/// Writes columns `strip,kind,closed,index,x,y,z`. A closed strip's first point is not repeated.
pub(super) fn write(out: &mut dyn Write, network: &Network) -> io::Result<()> {
    writeln!(out, "strip,kind,closed,index,x,y,z")?;
    for (id, strip) in network.strips.iter().enumerate() {
        let (kind, closed) = (strip.kind.name(), u8::from(strip.closed));
        for (index, [x, y, z]) in strip.points.iter().enumerate() {
            writeln!(out, "{id},{kind},{closed},{index},{x:?},{y:?},{z:?}")?;
        }
    }
    Ok(())
}
