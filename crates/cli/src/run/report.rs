//! `lineament report`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::params::Auto;
use lineament::section::{Axis, Planes, SectionParams};
use lineament_io::{NetworkFormat, ReadOptions, Report, network_format, write_report};

use super::context::context;
use super::page;
use crate::args;
use crate::batch::Done;
use crate::failure::{Code, Failure};
use crate::source::{self, Origin};
use crate::work::{self, Work};
use crate::{outputs, progress, summary};

/// Suffix of the file beside an input, or in a folder.
const SUFFIXES: [&str; 1] = ["html"];

/// Reads, extracts lines and patches, slices if asked to, and writes the report.
pub fn run(args: &args::Report) -> Result<(), Failure> {
    if source::is_list(&args.work.source) {
        return source::print_list();
    }
    let params = params(args)?;
    let mut work = work::prepare(&args.work, &args.output, &SUFFIXES, page_only)?;
    work.params.patches.find = Auto::Given(true);
    work.each(|origin, outputs| one(&work, args, params.as_ref(), origin, outputs))
}

/// How to slice; `None` if no slices are asked for.
fn params(args: &args::Report) -> Result<Option<SectionParams>, Failure> {
    let Some(count) = args.slices else { return Ok(None) };
    let axis = args.axis.unwrap_or(Axis::Faces);
    let params = SectionParams { axis, planes: Planes::Count(count), fit: true, ..SectionParams::default() };
    params.check()?;
    Ok(Some(params))
}

fn page_only(path: &Path) -> Result<NetworkFormat, Failure> {
    if page::is_page(path) || path.as_os_str() == "-" {
        return network_format(path).map_err(Failure::from);
    }
    let message = format!("{}: a report is HTML: end the name in `.html`", path.display());
    Err(Failure::new(Code::Usage, message))
}

fn one(
    work: &Work,
    args: &args::Report,
    slicing: Option<&SectionParams>,
    origin: &Origin,
    outputs: &[PathBuf],
) -> Result<Done, Failure> {
    let start = Instant::now();
    let input = work.load(
        origin,
        &ReadOptions { attributes: false, without_noise: true, hash: true, ..Default::default() },
    )?;
    let found = work.extract(origin, &input)?;
    let cut = |params| progress::sectioned(&input.cloud, params, work.args.running.quiet);
    let cut = slicing.map(cut).transpose().map_err(|e| Failure::from(e).at(origin.shown()))?;
    let (context, classes) = (context(&input, &work.params, &found), page::numbers(&found.classes()));
    let (labels, writing) = (found.patch_labels(), Instant::now());
    let report = Report {
        cloud: Some(&input.cloud),
        classes: &classes,
        labels: &labels,
        network: Some(&found.network),
        sections: cut.as_ref().map(|(sections, stack)| (sections, stack)),
        up: page::up(&args.up, Some(input.up())),
        ..Report::new(&context)
    };
    for path in outputs {
        outputs::write(path, || write_report(path, &work.inputs_with(&input), &report))?;
    }
    let [wrote, total] = [writing, start].map(|t| t.elapsed().as_secs_f64());
    let mut lines = summary::of(&input, &found, work.args.running.verbose);
    lines.push(summary::times(&input, &found.report, wrote, total));
    lines.push(summary::written(outputs));
    Ok(Done { lines, row: summary::row(found.report.read, Some(&found.network), total) })
}
