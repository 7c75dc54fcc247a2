//! A neighbour graph as PLY with elements `vertex` and `edge`.

use super::table::GraphTable;
use crate::write::encode::ply;
use crate::write::points::ply::{columns, rows};
use crate::write::points::{PointTable, rows::names};
use std::io::{self, Write};

/// Writes every point of the input with its attributes, and edges of `vertex1`, `vertex2`, and `cut` where the edges that cross
/// a line are there.
pub(super) fn write(out: &mut dyn Write, table: &GraphTable) -> io::Result<()> {
    let points = PointTable { cloud: table.cloud, classes: &[], scores: &[], las: None };
    let names = names(&points);
    let more: &[(&str, &str)] = if table.all { &[("uchar", "cut")] } else { &[] };
    let program = format!("lineament {}: neighbour graph", table.context.program_version);
    let cut = "edge cut: 1 crosses a line, 0 does not";
    let comments = if table.all { vec![program.as_str(), cut] } else { vec![program.as_str()] };
    let elements = [ply::vertices(table.cloud.len(), &columns(&names)), ply::edges(table.count(), more)];
    ply::header(out, &comments, &elements)?;
    rows(out, &points)?;
    for (edge, cut) in table.edges() {
        let cut = if table.all { &[u8::from(cut)][..] } else { &[] };
        ply::edge(out, edge.map(|end| end as usize), cut)?;
    }
    Ok(())
}
