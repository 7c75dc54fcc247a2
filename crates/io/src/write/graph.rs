//! Neighbour graphs: one file for each format.

mod csv;
mod json;
mod npz;
mod ply;
mod table;

pub use table::GraphTable;

use crate::error::Error;
use crate::format::{GraphFormat, graph_format};
use crate::output::Output;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes a neighbour graph to a file, whole or not at all, in the format of the extension. `path` must be none of `inputs`.
///
/// # Errors
/// Those of [`graph_format`] and [`Output::create`], a failed write, and [`Error::Inconsistent`] for an edge to a point that is
/// not there.
pub fn write_graph(path: &Path, inputs: &[PathBuf], table: &GraphTable) -> Result<(), Error> {
    let format = graph_format(path)?;
    let inconsistent = |what| Error::Inconsistent { name: path.display().to_string(), what };
    table.check().map_err(inconsistent)?;
    Output::whole(path, inputs, |out| write_graph_to(out, format, table))
}

/// Writes a neighbour graph to a stream; its edges lead to points that are there.
///
/// # Errors
/// Those of the stream.
pub fn write_graph_to(out: &mut dyn Write, format: GraphFormat, table: &GraphTable) -> io::Result<()> {
    match format {
        GraphFormat::Json => json::write(out, table),
        GraphFormat::Ply => ply::write(out, table),
        GraphFormat::Csv => csv::write(out, table),
        GraphFormat::Npz => npz::write(out, table),
    }
}
