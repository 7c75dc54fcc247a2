//! `lineament classify`.

use std::path::PathBuf;
use std::time::Instant;

use lineament::Params;
use lineament_io::{PointTable, ReadOptions, point_format, write_points};

use crate::args::Classify;
use crate::batch::{self, Done};
use crate::failure::Failure;
use crate::source::Origin;
use crate::summary::plural;
use crate::{config, outputs, progress, source, summary};

/// What a folder gets.
const SUFFIXES: [&str; 1] = ["classes.npy"];

/// Reads, extracts, and writes a class and a score for every point.
pub fn run(args: &Classify) -> Result<(), Failure> {
    if source::is_list(&args.source) {
        return source::print_list();
    }
    config::threads(&args.running)?;
    let params = config::params(&args.tuning)?;
    let origins = source::origins(&args.source)?;
    let inputs = source::files(&origins);
    let plan = outputs::plan(&origins, &args.output, &SUFFIXES)?;
    outputs::check(&plan, &inputs, point_format)?;
    batch::run(&origins, args.running.quiet, args.running.verbose, |i, origin| {
        one(args, origin, &inputs, &plan[i], &params)
    })
}

fn one(
    args: &Classify,
    origin: &Origin,
    inputs: &[PathBuf],
    outputs: &[PathBuf],
    params: &Params,
) -> Result<Done, Failure> {
    let start = Instant::now();
    let input = origin.load(&args.source, &ReadOptions::default())?;
    let found = progress::observed(&input.cloud, params, args.running.quiet)
        .map_err(|e| Failure::from(e).at(origin.shown()))?;
    let classes: Vec<u8> = found.classes().into_iter().map(|class| class as u8).collect();
    let table = PointTable { cloud: &input.cloud, classes: &classes, scores: &found.scores() };
    for path in outputs {
        outputs::write(path, || write_points(path, inputs, &table))?;
    }
    let mut lines = summary::of(&input, &found, args.running.verbose);
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
