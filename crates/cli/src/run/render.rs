//! `lineament render`.

use std::io::Write;
use std::path::Path;

use lineament::Network;
use lineament::apply::render::{Picture, Scene, Settings, View, render, surfels};
use lineament_io as io;

use crate::args::Render;
use crate::failure::{Code, Failure};
use crate::source::{self, Input};
use crate::{config, network_file, outputs, progress, summary};

/// Reads, extracts if asked to, draws, and writes the picture.
pub fn run(args: &Render) -> Result<(), Failure> {
    if source::is_list(&args.source) {
        return source::print_list();
    }
    config::threads(&args.running)?;
    let settings = settings(args)?;
    let mut inputs = source::files(&args.source);
    outputs::check(std::slice::from_ref(&args.output), &inputs, png_only)?;
    let input = source::load(&args.source, &io::ReadOptions { attributes: false, ..Default::default() })?;
    let mut lines = Vec::new();
    let network = match args.network.to_str() {
        Some("none") => None,
        Some("computed") => Some(computed(args, &input, &mut lines)?),
        _ => {
            inputs.push(args.network.clone());
            Some(network_file::read(&args.network)?)
        }
    };
    let (surfels, spacing) = surfels(&input.cloud).map_err(|e| Failure::from(e).at(&input.name))?;
    let scene = Scene { surfels: &surfels, network: network.as_ref(), spacing };
    let picture = render(&scene, &settings)?;
    write(&args.output, &inputs, &picture)?;
    if !args.running.quiet {
        lines.push(summary::written(std::slice::from_ref(&args.output)));
        eprintln!("{}", lines.join("\n"));
    }
    Ok(())
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

fn computed(args: &Render, input: &Input, lines: &mut Vec<String>) -> Result<Network, Failure> {
    let params = config::params(&args.tuning)?;
    let found = progress::observed(&input.cloud, &params, args.running.quiet)
        .map_err(|e| Failure::from(e).at(&input.name).advise("`--network none` draws the points alone"))?;
    *lines = summary::of(input, &found, args.running.verbose);
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

fn write(path: &Path, inputs: &[std::path::PathBuf], picture: &Picture) -> Result<(), Failure> {
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
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&picture.rgb)?;
    writer.finish()?;
    Ok(out.flush()?)
}
