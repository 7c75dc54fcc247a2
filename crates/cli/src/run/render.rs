//! `lineament render`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::Network;
use lineament::apply::render::{Scene, Settings, View, render, surfels};
use lineament_io as io;

use crate::args::Render;
use crate::batch::Done;
use crate::failure::{Code, Failure};
use crate::source::{self, Input, Origin};
use crate::work::{self, Work};
use crate::{network_file, outputs, progress, summary};

/// Suffixes of the files that a folder gets.
const SUFFIXES: [&str; 1] = ["png"];

/// Reads, extracts if asked to, draws, and writes the picture.
pub fn run(args: &Render) -> Result<(), Failure> {
    if source::is_list(&args.work.source) {
        return source::print_list();
    }
    let settings = settings(args)?;
    let work = work::prepare(&args.work, std::slice::from_ref(&args.output), &SUFFIXES, png_only)?;
    work.each(|origin, outputs| one(&work, origin, outputs, args, &settings))
}

fn one(
    work: &Work,
    origin: &Origin,
    outputs: &[PathBuf],
    args: &Render,
    settings: &Settings,
) -> Result<Done, Failure> {
    let (start, network) = (Instant::now(), &args.network);
    let input = work.load(origin, &io::ReadOptions { attributes: false, ..Default::default() })?;
    let mut inputs = work.inputs_with(&input);
    let mut said = Vec::new();
    let network = match network.to_str() {
        Some("none") => None,
        Some("computed") => Some(computed(work, origin, &input, &mut said)?),
        _ => {
            inputs.push(outputs::filled(network, origin));
            Some(network_file::read(&outputs::filled(network, origin))?)
        }
    };
    let (surfels, spacing) = surfels(&input.cloud).map_err(|e| Failure::from(e).at(origin.shown()))?;
    let settings = &Settings { up: up(&args.up, &input), ..settings.clone() };
    let scene = Scene { surfels: &surfels, network: network.as_ref(), slices: &[], verdicts: &[], spacing };
    // All else of the settings was checked before.
    let drawn = progress::named("draw", work.args.running.quiet, || render(&scene, settings));
    let picture = drawn.map_err(|e| Failure { advice: None, ..e.into() }.at(origin.shown()))?;
    for path in outputs {
        outputs::write(path, || io::write_picture(path, &inputs, &picture))?;
    }
    said.push(summary::written(outputs));
    let seconds = start.elapsed().as_secs_f64();
    Ok(Done { lines: said, row: summary::row(input.cloud.len(), network.as_ref(), seconds) })
}

fn computed(work: &Work, origin: &Origin, input: &Input, said: &mut Vec<String>) -> Result<Network, Failure> {
    let found =
        work.extract(origin, input).map_err(|e| e.advise("`--network none` draws the points alone"))?;
    *said = summary::of(input, &found, work.args.running.verbose);
    Ok(found.network)
}

fn settings(args: &Render) -> Result<Settings, Failure> {
    let usage = |e: lineament::Error| Failure { code: Code::Usage, advice: None, ..Failure::from(e) };
    let view = View::parse(&args.view).map_err(usage)?;
    let (width, height) = args.size;
    let settings = Settings { view, width, height, caption: !args.no_caption, ..Settings::default() };
    settings.check().map_err(usage)?;
    Ok(settings)
}

/// The axis of that name; without one that of the format of the input.
fn up(name: &str, input: &Input) -> [f64; 3] {
    match name {
        "x" => [1.0, 0.0, 0.0],
        "y" => [0.0, 1.0, 0.0],
        "auto" => input.up(),
        _ => [0.0, 0.0, 1.0],
    }
}

/// Accepts `-` and names that end in `.png`.
fn png_only(path: &Path) -> Result<(), Failure> {
    let is_png = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("png"));
    if is_png || path.as_os_str() == "-" {
        return Ok(());
    }
    let message = format!("{}: pictures are written as PNG only: end the name in `.png`", path.display());
    Err(Failure::new(Code::Usage, message))
}
