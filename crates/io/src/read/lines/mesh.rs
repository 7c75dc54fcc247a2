//! Meshes as lines: the edges between their faces, by the readers of points.

use super::super::faces::with_faces;
use super::LineFile;
use crate::error::Error;
use crate::format::Format;
use crate::source::Source;
use lineament::evaluate::{Line, LineKind};
use lineament::mesh::lines;
use std::path::Path;

/// Reads faces, and takes the edges at which they meet at more than `angle_deg` degrees.
pub(super) fn read(path: &Path, format: Format, angle_deg: f64) -> Result<LineFile, Error> {
    let name = path.display().to_string();
    let fail = |source| Error::Io { action: "open", name: name.clone(), source };
    let file = std::fs::File::open(path).map_err(fail)?;
    let length = file.metadata().map_err(fail)?.len();
    let mut source = Source::new(Box::new(file), name.clone(), Some(length), false).at(path);
    // Recognising the format has looked ahead as far.
    source.peek(1 << 16)?;
    let advice = "give lines (JSON, DXF, STEP, OBJ) or a mesh with faces";
    let (decoded, faces) = with_faces(&mut source, format, "holds no lines", advice)?;
    let mut out = LineFile::new(format!("{format} mesh"));
    let found = lines(&decoded.cloud.positions, &faces, angle_deg);
    out.lines.lines.extend(found.into_iter().map(|line| {
        let kind = if line.border { LineKind::Border } else { LineKind::Crease };
        Line { kind, closed: line.closed, points: line.points }
    }));
    out.ignored = decoded.warnings;
    Ok(out)
}
