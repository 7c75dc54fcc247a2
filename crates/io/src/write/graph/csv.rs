//! A neighbour graph as CSV: a row for each edge.

use super::table::GraphTable;
use std::io::{self, Write};

/// Writes columns `first,second,length`, and `cut` where the edges that cross a line are there.
pub(super) fn write(out: &mut dyn Write, table: &GraphTable) -> io::Result<()> {
    writeln!(out, "first,second,length{}", if table.all { ",cut" } else { "" })?;
    for (edge, cut) in table.edges() {
        let [i, j] = edge;
        write!(out, "{i},{j},{:?}", table.length(edge))?;
        match table.all {
            true => writeln!(out, ",{}", u8::from(cut))?,
            false => writeln!(out)?,
        }
    }
    Ok(())
}
