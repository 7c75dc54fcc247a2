//! `lineament classify`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::detect::baselines::Detector;
use lineament::detect::points::{Marked, mark};
use lineament::{Attribute, Class, Column, Network};
use lineament_io::{PointFormat, PointTable, ReadOptions, Report, point_format, write_points, write_report};

use super::page;
use crate::args::Classify;
use crate::batch::Done;
use crate::failure::{Code, Failure};
use crate::source::{self, Input, Origin};
use crate::summary::plural;
use crate::work::{self, Work};
use crate::{outputs, summary};

/// Suffixes of the files that a folder gets.
const SUFFIXES: [&str; 1] = ["classes.npy"];

/// Classes and scores of the points, with messages about them.
struct Found {
    classes: Vec<Class>,
    scores: Vec<f32>,
    lines: Vec<String>,
    network: Option<Network>,
}

/// Reads, extracts or applies one detector, and writes a class and a score for every point.
pub fn run(args: &Classify) -> Result<(), Failure> {
    if source::is_list(&args.work.source) {
        return source::print_list();
    }
    let bare = [PointFormat::Npy, PointFormat::Html];
    let holds_scores =
        |path: &PathBuf| path != Path::new("-") && point_format(path).is_ok_and(|f| !bare.contains(&f));
    if args.scores && !args.output.iter().any(holds_scores) {
        return Err(Failure::new(
            Code::Usage,
            "--scores: NPY and HTML hold classes only: add an output `-o NAME.ply`",
        ));
    }
    let work = work::prepare(&args.work, &args.output, &SUFFIXES, point_format)?;
    work.each(|origin, outputs| one(&work, args, origin, outputs))
}

fn one(work: &Work, args: &Classify, origin: &Origin, outputs: &[PathBuf]) -> Result<Done, Failure> {
    let start = Instant::now();
    let mut input =
        work.load(origin, &ReadOptions { hash: page::states_hash(outputs), ..Default::default() })?;
    let found = match args.detector {
        Some(detector) => by_detector(work, origin, &input, detector)?,
        None => by_method(work, origin, &input)?,
    };
    if args.scores {
        let every = marked(work, origin, &input, &Detector::ALL)?;
        input.cloud.attributes.extend((0..Detector::ALL.len()).map(|which| attribute(&every, which)));
    }
    let classes = page::numbers(&found.classes);
    let frame = input.frame();
    let table =
        PointTable { cloud: &input.cloud, classes: &classes, scores: &found.scores, las: frame.as_deref() };
    let (inputs, provenance) = (work.inputs_with(&input), page::provenance(&input));
    let report = Report {
        cloud: Some(&input.cloud),
        classes: &classes,
        network: found.network.as_ref(),
        up: input.up(),
        ..Report::new(&provenance)
    };
    for path in outputs {
        outputs::write(path, || match page::is_page(path) {
            true => write_report(path, &inputs, &report),
            false => write_points(path, &inputs, &table),
        })?;
    }
    let mut lines = found.lines;
    lines.push(counts(&classes));
    lines.extend(summary::other_version(&table, outputs));
    lines.push(summary::written(outputs));
    let seconds = start.elapsed().as_secs_f64();
    Ok(Done { lines, row: summary::row(input.cloud.len(), found.network.as_ref(), seconds) })
}

fn by_method(work: &Work, origin: &Origin, input: &Input) -> Result<Found, Failure> {
    let found = work.extract(origin, input)?;
    let lines = summary::of(input, &found, work.args.running.verbose);
    Ok(Found { classes: found.classes(), scores: found.scores(), lines, network: Some(found.network) })
}

fn by_detector(work: &Work, origin: &Origin, input: &Input, detector: Detector) -> Result<Found, Failure> {
    let found = marked(work, origin, input, &[detector])?;
    let mut lines = vec![summary::points(input, &found.report)];
    lines.extend(found.report.surface.unused(found.report.read));
    lines.push(summary::resolution(&found.report));
    lines.extend(found.report.notes.iter().map(|note| format!("note: {note}")));
    if work.args.running.verbose {
        lines.extend(input.remarks.iter().map(|remark| format!("input: {remark}")));
        lines.extend(found.report.settings.iter().map(|(key, value)| format!("chosen: {key}: {value}")));
    }
    Ok(Found { classes: found.classes(0), scores: found.scores(0), lines, network: None })
}

fn marked(work: &Work, origin: &Origin, input: &Input, detectors: &[Detector]) -> Result<Marked, Failure> {
    mark(&input.cloud, &work.params, detectors).map_err(|e| Failure::from(e).at(origin.shown()))
}

fn attribute(every: &Marked, which: usize) -> Attribute {
    let name = every.marks[which].0.name().replace('-', "_");
    Attribute { name, values: Column::F32(every.scores(which)) }
}

fn counts(classes: &[u8]) -> String {
    let names = ["smooth", "crease", "border", "corner", "clutter"];
    let count = |class: usize| classes.iter().filter(|&&c| usize::from(c) == class).count();
    let told = names.iter().enumerate().filter(|&(i, _)| i < 4 || count(i) > 0);
    let parts = told.map(|(i, name)| plural(count(i), &format!("{name} point")));
    parts.collect::<Vec<String>>().join(", ")
}
