//! `lineament render`.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::apply::render::{Picture, Scene, Settings, View, render, surfels};
use lineament::{Network, Params};
use lineament_io as io;

use crate::args::Render;
use crate::batch::{self, Done};
use crate::failure::{Code, Failure};
use crate::source::{self, Input, Origin};
use crate::{config, network_file, outputs, progress, summary};

/// What a folder gets.
const SUFFIXES: [&str; 1] = ["png"];

/// Where the lines come from.
enum Lines {
    Absent,
    Computed(Box<Params>),
    Read(PathBuf),
}

/// Reads, extracts if asked to, draws, and writes the picture.
pub fn run(args: &Render) -> Result<(), Failure> {
    if source::is_list(&args.source) {
        return source::print_list();
    }
    config::threads(&args.running)?;
    let settings = settings(args)?;
    let params = config::params(&args.tuning)?;
    let origins = source::origins(&args.source)?;
    let inputs = source::files(&origins);
    let plan = outputs::plan(&origins, std::slice::from_ref(&args.output), &SUFFIXES)?;
    outputs::check(&plan, &inputs, png_only)?;
    batch::run(&origins, args.running.quiet, args.running.verbose, |i, origin| {
        let lines = match args.network.to_str() {
            Some("none") => Lines::Absent,
            Some("computed") => Lines::Computed(Box::new(params.clone())),
            _ => Lines::Read(outputs::filled(&args.network, origin)),
        };
        one(args, origin, &inputs, &plan[i], &lines, &settings)
    })
}

fn one(
    args: &Render,
    origin: &Origin,
    inputs: &[PathBuf],
    outputs: &[PathBuf],
    lines: &Lines,
    settings: &Settings,
) -> Result<Done, Failure> {
    let start = Instant::now();
    let input = origin.load(&args.source, &io::ReadOptions { attributes: false, ..Default::default() })?;
    let mut inputs = inputs.to_vec();
    let mut said = Vec::new();
    let network = match lines {
        Lines::Absent => None,
        Lines::Computed(params) => Some(computed(args, params, origin, &input, &mut said)?),
        Lines::Read(path) => {
            inputs.push(path.clone());
            Some(network_file::read(path)?)
        }
    };
    let (surfels, spacing) = surfels(&input.cloud).map_err(|e| Failure::from(e).at(origin.shown()))?;
    let picture = render(&Scene { surfels: &surfels, network: network.as_ref(), spacing }, settings)?;
    outputs.iter().try_for_each(|path| write(path, &inputs, &picture))?;
    said.push(summary::written(outputs));
    let seconds = start.elapsed().as_secs_f64();
    Ok(Done { lines: said, row: summary::row(input.cloud.len(), network.as_ref(), seconds) })
}

fn settings(args: &Render) -> Result<Settings, Failure> {
    let usage = |e: lineament::Error| Failure { code: Code::Usage, advice: None, ..Failure::from(e) };
    let view = View::parse(&args.view).map_err(usage)?;
    let up = match args.up.as_str() {
        "x" => [1.0, 0.0, 0.0],
        "y" => [0.0, 1.0, 0.0],
        _ => [0.0, 0.0, 1.0],
    };
    let (width, height) = args.size;
    let settings = Settings { view, up, width, height, caption: !args.no_caption };
    settings.check().map_err(usage)?;
    Ok(settings)
}

fn computed(
    args: &Render,
    params: &Params,
    origin: &Origin,
    input: &Input,
    said: &mut Vec<String>,
) -> Result<Network, Failure> {
    let found = progress::observed(&input.cloud, params, args.running.quiet)
        .map_err(|e| Failure::from(e).at(origin.shown()).advise("`--network none` draws the points alone"))?;
    *said = summary::of(input, &found, args.running.verbose);
    Ok(found.network)
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

fn write(path: &Path, inputs: &[PathBuf], picture: &Picture) -> Result<(), Failure> {
    let failed = |e: png::EncodingError| Failure::new(Code::Output, format!("{}: {e}", path.display()));
    if path.as_os_str() == "-" {
        return encode(&mut std::io::stdout().lock(), picture).map_err(failed);
    }
    outputs::write(path, || {
        let mut output = io::Output::create(path, inputs).map_err(Failure::from)?;
        encode(&mut output, picture).map_err(failed)?;
        output.finish().map_err(Failure::from)
    })
}

fn encode(out: &mut dyn Write, picture: &Picture) -> Result<(), png::EncodingError> {
    let mut encoder = png::Encoder::new(&mut *out, picture.width as u32, picture.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Balanced);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&picture.rgb)?;
    writer.finish()?;
    Ok(out.flush()?)
}
