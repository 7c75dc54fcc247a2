//! `lineament classify`.

use lineament_io::{PointTable, ReadOptions, point_format, write_points};

use crate::args::Classify;
use crate::failure::Failure;
use crate::summary::plural;
use crate::{config, outputs, progress, source, summary};

/// Reads, extracts, and writes a class and a score for every point.
pub fn run(args: &Classify) -> Result<(), Failure> {
    if source::is_list(&args.source) {
        return source::print_list();
    }
    config::threads(&args.running)?;
    let params = config::params(&args.tuning)?;
    outputs::check(&args.output, &source::files(&args.source), point_format)?;
    let input = source::load(&args.source, &ReadOptions::default())?;
    let found = progress::observed(&input.cloud, &params, args.running.quiet)
        .map_err(|e| Failure::from(e).at(&input.name))?;
    let classes: Vec<u8> = found.classes().into_iter().map(|class| class as u8).collect();
    let scores = found.scores();
    let table =
        PointTable { cloud: &input.cloud, classes: &classes, scores: &scores, las: input.las.as_ref() };
    for path in &args.output {
        outputs::write(path, || write_points(path, &input.files, &table))?;
    }
    if !args.running.quiet {
        let mut lines = summary::of(&input, &found, args.running.verbose);
        lines.push(counts(&classes));
        lines.push(summary::written(&args.output));
        eprintln!("{}", lines.join("\n"));
    }
    Ok(())
}

fn counts(classes: &[u8]) -> String {
    let names = ["smooth", "crease", "border", "corner"];
    let count = |class: usize| classes.iter().filter(|&&c| usize::from(c) == class).count();
    let parts = names.iter().enumerate().map(|(i, name)| plural(count(i), &format!("{name} point")));
    parts.collect::<Vec<String>>().join(", ")
}
