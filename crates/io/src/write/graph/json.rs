//! A neighbour graph in the schema `lineament-graph/1`, which `docs/formats.md` describes.

use super::table::GraphTable;
use crate::write::encode::json::{Head, Number, Text, Value, list};
use std::io::{self, Write};

/// The name of the schema, as it stands in every file.
const SCHEMA: &str = "lineament-graph/1";

/// Writes provenance, the edges along the surface, and those that cross a line if they are asked for.
pub(super) fn write(out: &mut dyn Write, table: &GraphTable) -> io::Result<()> {
    let context = table.context;
    Head {
        schema: SCHEMA,
        version: &context.program_version,
        input: &context.input_name,
        sha256: context.input_sha256.as_deref(),
        points: context.input_points,
    }
    .write(out)?;
    writeln!(out, "\"method\": {},", Text(&context.method))?;
    write!(out, "\"parameters\": {{")?;
    list(out, &context.parameters, |out, _, p| write!(out, "{}: {}", Text(&p.key), Value(&p.value)))?;
    writeln!(out, "}},\n\"spacing\": {},", Number(context.spacing))?;
    let ends = |out: &mut dyn Write, _: usize, &[i, j]: &[u32; 2]| write!(out, "[{i}, {j}]");
    write!(out, "\"edges\": [")?;
    list(out, &table.graph.edges, ends)?;
    if table.all {
        write!(out, "],\n\"cut\": [")?;
        list(out, &table.graph.cut, ends)?;
    }
    writeln!(out, "]\n}}")
}
