//! `lineament clean`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::{Cleaned, clean};
use lineament_io::{
    PointFormat, PointTable, ReadOptions, Report, label_clutter, point_format, write_cleaned, write_report,
};

use super::page;
use crate::args;
use crate::batch::Done;
use crate::failure::{Code, Failure};
use crate::source::{self, Input, Origin};
use crate::summary::plural;
use crate::work::{self, Work};
use crate::{outputs, summary};

/// Suffixes of the files that a folder gets.
const SUFFIXES: [&str; 1] = ["clean.ply"];

/// Reads, tells surface from clutter, and writes the points on surfaces, or all with a label.
pub fn run(args: &args::Clean) -> Result<(), Failure> {
    if source::is_list(&args.work.source) {
        return source::print_list();
    }
    if args.work.tuning.method.is_some() {
        return Err(Failure::new(Code::Usage, "--method: `clean` looks for no lines"));
    }
    let work = work::prepare(&args.work, &args.output, &SUFFIXES, point_format)?;
    work.each(|origin, outputs| one(&work, args, origin, outputs))
}

fn one(work: &Work, args: &args::Clean, origin: &Origin, outputs: &[PathBuf]) -> Result<Done, Failure> {
    let start = Instant::now();
    let mut input =
        work.load(origin, &ReadOptions { hash: page::states_hash(outputs), ..Default::default() })?;
    let found = clean(&input.cloud, &work.params).map_err(|e| Failure::from(e).at(origin.shown()))?;
    let inputs = work.inputs_with(&input);
    let labels = if args.label { label_clutter(&mut input.cloud, &found.clutter) } else { Vec::new() };
    if !args.label {
        input.cloud = input.cloud.select(&found.surface);
    }
    for path in outputs {
        outputs::write(path, || write(path, &inputs, &input, &labels))?;
    }
    let mut lines = vec![summary::points(&input, &found.report), summary::resolution(&found.report)];
    lines.push(counts(&found, args.label));
    let table = PointTable { cloud: &input.cloud, classes: &[], scores: &[], las: input.las.as_ref() };
    lines.extend(summary::other_version(&table, outputs));
    lines.extend(found.report.notes.iter().map(|note| format!("note: {note}")));
    lines.extend(summary::warnings(&input));
    if work.args.running.verbose {
        lines.extend(input.remarks.iter().map(|remark| format!("input: {remark}")));
    }
    let seconds = start.elapsed().as_secs_f64();
    lines.push(summary::written(outputs));
    Ok(Done { lines, row: summary::row(found.report.read, None, seconds) })
}

/// Writes one output.
fn write(path: &Path, inputs: &[PathBuf], input: &Input, labels: &[u8]) -> Result<(), lineament_io::Error> {
    if point_format(path)? != PointFormat::Html {
        return write_cleaned(path, inputs, &input.cloud, labels, input.frame().as_deref());
    }
    let provenance = page::provenance(input);
    let report =
        Report { cloud: Some(&input.cloud), classes: labels, up: input.up(), ..Report::new(&provenance) };
    write_report(path, inputs, &report)
}

fn counts(found: &Cleaned, label: bool) -> String {
    let [surface, clutter] = [&found.surface, &found.clutter].map(|points| plural(points.len(), "point"));
    let done = if label { "labelled" } else { "left out" };
    format!("{surface} on surfaces, {clutter} of clutter {done}")
}
