//! `lineament enrich`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::apply::{LinePoint, enriched, line_points};
use lineament::{Attribute, Class, Cloud, Column};
use lineament_io::{PointFormat, PointTable, ReadOptions, Report, point_format, write_points, write_report};

use crate::args;
use crate::batch::Done;
use crate::failure::Failure;
use crate::run::page;
use crate::source::{self, Input, Origin};
use crate::summary::plural;
use crate::work::{self, Work};
use crate::{outputs, summary};

/// Suffixes of the files that a folder gets.
const SUFFIXES: [&str; 1] = ["enriched.ply"];

/// Reads, extracts, and writes the points with those along the lines.
pub fn run(args: &args::Enrich) -> Result<(), Failure> {
    if source::is_list(&args.work.source) {
        return source::print_list();
    }
    let work = work::prepare(&args.work, &args.output, &SUFFIXES, point_format)?;
    work.each(|origin, outputs| one(&work, args, origin, outputs))
}

fn one(work: &Work, args: &args::Enrich, origin: &Origin, outputs: &[PathBuf]) -> Result<Done, Failure> {
    let start = Instant::now();
    let input = work.load(origin, &ReadOptions { hash: page::states_hash(outputs), ..Default::default() })?;
    let found = work.extract(origin, &input)?;
    let points = line_points(&input.cloud, &found, &work.params, args.step);
    let (mut cloud, mut classes) = enriched(&input.cloud, &found.classes(), &points);
    let first = input.cloud.len();
    let mut added = vec![0u8; first];
    added.resize(cloud.len(), 1);
    if args.added {
        let rows: Vec<u32> = (first as u32..cloud.len() as u32).collect();
        cloud = cloud.select(&rows);
        classes.drain(..first);
        added.drain(..first);
    }
    let classes = page::numbers(&classes);
    label(&mut cloud, &classes, added);
    let inputs = work.inputs_with(&input);
    for path in outputs {
        outputs::write(path, || write(path, &inputs, &input, &cloud, &classes))?;
    }
    let mut lines = summary::of(&input, &found, work.args.running.verbose);
    lines.push(counts(&points));
    let table = PointTable { cloud: &cloud, classes: &[], scores: &[], las: input.las.as_ref() };
    lines.extend(summary::other_version(&table, outputs));
    lines.push(summary::written(outputs));
    let seconds = start.elapsed().as_secs_f64();
    Ok(Done { lines, row: summary::row(found.report.read, Some(&found.network), seconds) })
}

/// Adds the columns of the new points and the old.
fn label(cloud: &mut Cloud, classes: &[u8], added: Vec<u8>) {
    let column = |name: &str, values| Attribute { name: name.into(), values: Column::U8(values) };
    cloud.attributes.insert(0, column("class", classes.to_vec()));
    cloud.attributes.insert(1, column("added", added));
}

/// Writes one output.
fn write(
    path: &Path,
    inputs: &[PathBuf],
    input: &Input,
    cloud: &Cloud,
    classes: &[u8],
) -> Result<(), lineament_io::Error> {
    if point_format(path)? != PointFormat::Html {
        let frame = input.frame();
        let table = PointTable { cloud, classes: &[], scores: &[], las: frame.as_deref() };
        return write_points(path, inputs, &table);
    }
    let provenance = page::provenance(input);
    let report = Report { cloud: Some(cloud), classes, up: input.up(), ..Report::new(&provenance) };
    write_report(path, inputs, &report)
}

fn counts(points: &[LinePoint]) -> String {
    let of = |kind, what: &str| plural(points.iter().filter(|p| p.kind == kind).count(), what);
    let kinds = [(Class::Crease, "crease point"), (Class::Border, "border point"), (Class::Corner, "corner")];
    let parts: Vec<String> = kinds.into_iter().map(|(kind, what)| of(kind, what)).collect();
    format!("{} added: {}", plural(points.len(), "point"), parts.join(", "))
}
