//! `lineament extract`.

mod listing;

use std::path::PathBuf;
use std::time::Instant;

use lineament::apply::render::View;
use lineament::{Cloud, Extraction};
use lineament_io::{NetworkContext, ReadOptions, network_format, write_network};

use super::context::context;
use super::{page, stages};
use crate::args::Extract;
use crate::batch::Done;
use crate::failure::{Code, Failure};
use crate::source::{self, Origin};
use crate::work::{self, Work};
use crate::{outputs, summary};

/// Suffixes of the files in a folder, or beside an input.
const SUFFIXES: [&str; 2] = ["lines.json", "lines.obj"];

/// Reads, extracts, writes, and reports.
pub fn run(args: &Extract) -> Result<(), Failure> {
    if source::is_list(&args.work.source) {
        return source::print_list();
    }
    let view = view(&args.view)?;
    let mut work = work::prepare(&args.work, &args.output, &SUFFIXES, network_format)?;
    work.params.relations.regularise |= args.regularise;
    stages::keep(&mut work, args.stages.as_deref())?;
    listing::check(&work, args.report.as_deref())?;
    work.each(|origin, outputs| one(&work, args, origin, outputs, view))
}

/// The direction in which drawings look; `None` for the best one.
fn view(text: &str) -> Result<Option<[f64; 3]>, Failure> {
    match View::parse(text).map_err(|e| Failure { code: Code::Usage, advice: None, ..e.into() })? {
        View::Best => Ok(None),
        View::From(from) => Ok(Some(from.map(|x| -x))),
    }
}

fn one(
    work: &Work,
    args: &Extract,
    origin: &Origin,
    outputs: &[PathBuf],
    view: Option<[f64; 3]>,
) -> Result<Done, Failure> {
    let start = Instant::now();
    let hash = page::states_hash(outputs);
    let input = work
        .load(origin, &ReadOptions { attributes: false, without_noise: true, hash, ..Default::default() })?;
    let mut found = work.extract(origin, &input)?;
    let left_out = choose(args, &input.cloud, &mut found);
    let mut lines = summary::chosen(&input, &found, work.args.running.verbose, left_out);
    let list = listing::of(&input.cloud, &found, args.report.is_some());
    lines.extend(list.iter().flat_map(listing::told));
    let context = NetworkContext {
        view,
        millimetres: args.millimetres,
        unit: args.cad.stated.unit.or(input.unit),
        step: args.cad.step_protocol,
        first_schema: args.schema == 1,
        ..context(&input, &work.params, &found)
    };
    let writing = Instant::now();
    let inputs = work.inputs_with(&input);
    for path in outputs {
        outputs::write(path, || match page::is_page(path) {
            true => page::extracted(path, &inputs, &input, &found, &context),
            false => write_network(path, &inputs, &found.network, &context),
        })?;
    }
    let listed =
        listing::write(args.report.as_deref(), outputs, &inputs, origin, &input.name, list.as_ref())?;
    let staged = stages::write(work, args.stages.as_deref(), origin, &input.cloud, &found)?;
    let [wrote, total] = [writing, start].map(|t| t.elapsed().as_secs_f64());
    lines.extend(summary::unplaced(&input, outputs));
    lines.extend(summary::unmeasured(context.known_unit(), outputs));
    lines.push(summary::times(&input, &found.report, wrote, total));
    let also: Vec<PathBuf> = listed.into_iter().chain(staged).collect();
    lines.push(summary::written(&[outputs, &also].concat()));
    Ok(Done { lines, row: summary::row(found.report.read, Some(&found.network), total) })
}

/// Leaves out the lines that are not asked for; says how many there were.
fn choose(args: &Extract, cloud: &Cloud, found: &mut Extraction) -> Vec<String> {
    let before = found.network.strips.len();
    let (length, confidence) = (args.min_length.unwrap_or(0.0), args.min_confidence.unwrap_or(0.0));
    if args.min_length.or(args.min_confidence).is_some() {
        found.choose(|strip| strip.length() >= length && strip.confidence >= confidence);
    }
    let chosen = found.network.strips.len();
    if let Some(length) = args.min_hole {
        found.choose_holes(&cloud.positions, length);
    }
    let left = [
        (before - chosen, "too short or too uncertain"),
        (chosen - found.network.strips.len(), "borders around small holes"),
    ];
    let some = left.into_iter().filter(|(count, _)| *count > 0);
    some.map(|(count, why)| format!("{} of {before} left out: {why}", summary::plural(count, "line")))
        .collect()
}
