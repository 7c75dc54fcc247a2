//! `lineament classify`.

use std::path::PathBuf;
use std::time::Instant;

use lineament_io::{PointTable, ReadOptions, point_format, write_points};

use crate::args::Classify;
use crate::batch::Done;
use crate::failure::Failure;
use crate::source::{self, Origin};
use crate::summary::plural;
use crate::work::{self, Work};
use crate::{outputs, summary};

/// What a folder gets.
const SUFFIXES: [&str; 1] = ["classes.npy"];

/// Reads, extracts, and writes a class and a score for every point.
pub fn run(args: &Classify) -> Result<(), Failure> {
    if source::is_list(&args.work.source) {
        return source::print_list();
    }
    let work = work::prepare(&args.work, &args.output, &SUFFIXES, point_format)?;
    work.each(|origin, outputs| one(&work, origin, outputs))
}

fn one(work: &Work, origin: &Origin, outputs: &[PathBuf]) -> Result<Done, Failure> {
    let start = Instant::now();
    let input = work.load(origin, &ReadOptions::default())?;
    let found = work.extract(origin, &input)?;
    let classes: Vec<u8> = found.classes().into_iter().map(|class| class as u8).collect();
    let scores = found.scores();
    let table =
        PointTable { cloud: &input.cloud, classes: &classes, scores: &scores, las: input.las.as_ref() };
    for path in outputs {
        outputs::write(path, || write_points(path, &work.inputs, &table))?;
    }
    let mut lines = summary::of(&input, &found, work.args.running.verbose);
    lines.push(counts(&classes));
    lines.push(summary::written(outputs));
    let seconds = start.elapsed().as_secs_f64();
    Ok(Done { lines, row: summary::row(found.report.read, Some(&found.network), seconds) })
}

fn counts(classes: &[u8]) -> String {
    let names = ["smooth", "crease", "border", "corner"];
    let count = |class: usize| classes.iter().filter(|&&c| usize::from(c) == class).count();
    let parts = names.iter().enumerate().map(|(i, name)| plural(count(i), &format!("{name} point")));
    parts.collect::<Vec<String>>().join(", ")
}
