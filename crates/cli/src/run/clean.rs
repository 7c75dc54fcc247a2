//! `lineament clean`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::{Attribute, Class, Cleaned, Cloud, Column, clean};
use lineament_io::{PointFormat, PointTable, ReadOptions, Report, point_format, write_points, write_report};

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
/// The attribute of LAS points with the classes of ASPRS, and the class of noise there.
const CLASSIFICATION: &str = "classification";
const NOISE: u8 = 7;

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
    let mut input = work.load(origin, &ReadOptions::default())?;
    let found = clean(&input.cloud, &work.params).map_err(|e| Failure::from(e).at(origin.shown()))?;
    let inputs = work.inputs_with(&input);
    let labels = if args.label { label(&mut input.cloud, &found.clutter) } else { Vec::new() };
    if !args.label {
        input.cloud = input.cloud.select(&found.surface);
    }
    for path in outputs {
        outputs::write(path, || write(path, &inputs, &input, &labels, &found.clutter))?;
    }
    let mut lines = vec![summary::points(&input, &found.report), summary::resolution(&found.report)];
    lines.push(counts(&found, args.label));
    lines.extend(found.report.notes.iter().map(|note| format!("note: {note}")));
    lines.extend(summary::warnings(&input));
    if work.args.running.verbose {
        lines.extend(input.remarks.iter().map(|remark| format!("input: {remark}")));
    }
    let seconds = start.elapsed().as_secs_f64();
    lines.push(summary::written(outputs));
    Ok(Done { lines, row: summary::row(found.report.read, None, seconds) })
}

/// Adds a column of classes to all points, and returns it.
fn label(cloud: &mut Cloud, clutter: &[u32]) -> Vec<u8> {
    let mut classes = vec![Class::Smooth as u8; cloud.len()];
    clutter.iter().for_each(|&i| classes[i as usize] = Class::Clutter as u8);
    cloud.attributes.insert(0, Attribute { name: "class".into(), values: Column::U8(classes.clone()) });
    classes
}

/// Writes one output. The classes are a column of their own where the format holds nothing else, and an attribute elsewhere.
fn write(
    path: &Path,
    inputs: &[PathBuf],
    input: &Input,
    labels: &[u8],
    clutter: &[u32],
) -> Result<(), lineament_io::Error> {
    let table = PointTable { cloud: &input.cloud, classes: &[], scores: &[], las: input.las.as_ref() };
    match point_format(path)? {
        PointFormat::Npy => write_points(path, inputs, &PointTable { classes: labels, ..table }),
        PointFormat::Las | PointFormat::Laz if !labels.is_empty() => {
            let cloud = with_noise(&input.cloud, clutter);
            write_points(path, inputs, &PointTable { cloud: &cloud, ..table })
        }
        PointFormat::Html => {
            let provenance = page::provenance(input);
            let report = Report {
                cloud: Some(&input.cloud),
                classes: labels,
                up: input.up(),
                ..Report::new(&provenance)
            };
            write_report(path, inputs, &report)
        }
        _ => write_points(path, inputs, &table),
    }
}

/// The points with clutter classified as noise. A classification that is not of bytes is none of LAS, and stays as it is.
fn with_noise(cloud: &Cloud, clutter: &[u32]) -> Cloud {
    let mut cloud = cloud.clone();
    if !cloud.attributes.iter().any(|a| a.name == CLASSIFICATION) {
        let values = Column::U8(vec![0; cloud.len()]);
        cloud.attributes.push(Attribute { name: CLASSIFICATION.into(), values });
    }
    let known = cloud.attributes.iter_mut().find(|a| a.name == CLASSIFICATION);
    if let Some(Attribute { values: Column::U8(classes), .. }) = known {
        clutter.iter().for_each(|&i| classes[i as usize] = NOISE);
    }
    cloud
}

fn counts(found: &Cleaned, label: bool) -> String {
    let [surface, clutter] = [&found.surface, &found.clutter].map(|points| plural(points.len(), "point"));
    let done = if label { "labelled" } else { "left out" };
    format!("{surface} on surfaces, {clutter} of clutter {done}")
}
