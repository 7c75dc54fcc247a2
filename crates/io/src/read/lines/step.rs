//! Wireframes of STEP (ISO 10303-21): the curves of its sets of curves; without any, the edges of its faces.

mod curve;
mod parse;

use super::LineFile;
use crate::error::{Error, Place};
use crate::source::Source;
use curve::Model;
use lineament::evaluate::LineKind;

/// Reads the curves.
pub(super) fn read(source: &mut Source) -> Result<LineFile, Error> {
    let bytes = super::all(source)?;
    let fault = |(at, found): (usize, String), source: &Source| {
        source.fault(Place::Byte(at as u64), found, "expected a wireframe in STEP")
    };
    let instances = parse::instances(&bytes).map_err(|e| fault(e, source))?;
    let model = Model::new(&instances);
    let mut out = LineFile::new("STEP");
    let sets = model.sets();
    let edges = if sets.is_empty() { model.edges() } else { Vec::new() };
    if !edges.is_empty() {
        out.ignored
            .push("no set of curves: all edges of the faces were taken, smooth ones and seams too".into());
    }
    let curves = sets.into_iter().chain(edges.into_iter().map(|id| (LineKind::Crease, id)));
    for (kind, id) in curves {
        for (points, typed) in model.curve(id).map_err(|e| fault(e, source))? {
            out.curve(kind, points, typed);
        }
    }
    let others = model.passed_over();
    if others > 0 {
        out.ignored.push(format!("{others} items of sets that are no curves"));
    }
    Ok(out)
}
