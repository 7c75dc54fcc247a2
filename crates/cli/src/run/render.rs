//! `lineament render`.

mod form;
mod tints;

use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::apply::render::{Scene, Settings, Surfel, Triangles, draw, lines_spacing, render, surfels};
use lineament::params::Auto;
use lineament::{Extraction, Network};
use lineament_io as io;

use super::page;
use crate::args::{PointColor, Render};
use crate::batch::Done;
use crate::failure::Failure;
use crate::source::{self, Input, Origin};
use crate::work::{self, Work};
use crate::{network_file, outputs, progress, summary};
use form::is_svg;

/// Suffixes of the files that a folder gets.
const SUFFIXES: [&str; 1] = ["png"];

/// Reads, extracts if asked to, draws, and writes the pictures.
pub fn run(args: &Render) -> Result<(), Failure> {
    if source::is_list(&args.work.source) {
        return source::print_list();
    }
    let settings = form::settings(args)?;
    let mut work = work::prepare(&args.work, &args.output, &SUFFIXES, form::known)?;
    if form::points(args) == Some(PointColor::Patch) {
        work.params.patches.find = Auto::Given(true);
    }
    let mesh = form::mesh(args)?;
    work.inputs.extend(form::mesh_path(args).map(Path::to_path_buf));
    let fixed = Fixed { settings, mesh: mesh.as_ref() };
    work.each(|origin, outputs| one(&work, origin, outputs, args, &fixed))
}

/// What all pictures have in common.
struct Fixed<'a> {
    settings: Settings,
    mesh: Option<&'a io::MeshFile>,
}

/// What a picture shows.
#[derive(Default)]
struct Shown {
    surfels: Vec<Surfel>,
    tints: Vec<[f32; 3]>,
    network: Option<Network>,
    spacing: f64,
    up: Option<[f64; 3]>,
    /// All files that were read.
    inputs: Vec<PathBuf>,
    said: Vec<String>,
}

fn one(
    work: &Work,
    origin: &Origin,
    outputs: &[PathBuf],
    args: &Render,
    fixed: &Fixed,
) -> Result<Done, Failure> {
    let start = Instant::now();
    let mut shown = match lines_alone(origin) {
        Some(path) => of_lines(work, path, fixed.mesh)?,
        None => of_points(work, origin, args)?,
    };
    shown.said.extend(fixed.mesh.iter().flat_map(|mesh| mesh.warnings.iter().cloned()));
    let settings = &Settings { up: page::up(&args.up, shown.up), ..fixed.settings.clone() };
    let mesh = fixed.mesh.map(|mesh| Triangles { vertices: &mesh.vertices, triangles: &mesh.triangles });
    let scene = Scene {
        surfels: if form::hides(args) { &shown.surfels } else { &[] },
        tints: if form::hides(args) { &shown.tints } else { &[] },
        mesh,
        network: shown.network.as_ref(),
        spacing: shown.spacing,
        ..Scene::default()
    };
    // All else of the settings was checked before.
    let refused = |e: lineament::Error| Failure { advice: None, ..e.into() }.at(origin.shown());
    let quiet = work.args.running.quiet;
    for path in outputs {
        if is_svg(path) {
            let drawing = progress::named("draw", quiet, || draw(&scene, settings)).map_err(refused)?;
            outputs::write(path, || io::write_drawing(path, &shown.inputs, &drawing))?;
        } else {
            let picture = progress::named("draw", quiet, || render(&scene, settings)).map_err(refused)?;
            outputs::write(path, || io::write_picture(path, &shown.inputs, &picture))?;
        }
    }
    shown.said.push(summary::written(outputs));
    let seconds = start.elapsed().as_secs_f64();
    let row = summary::row(shown.surfels.len(), shown.network.as_ref(), seconds);
    Ok(Done { lines: shown.said, row })
}

/// The file of an input that is itself a network.
fn lines_alone(origin: &Origin) -> Option<&Path> {
    match origin {
        Origin::File { path, .. } if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("json")) => {
            Some(path)
        }
        _ => None,
    }
}

/// Lines without points; the surface is the mesh, if there is one.
fn of_lines(work: &Work, path: &Path, mesh: Option<&io::MeshFile>) -> Result<Shown, Failure> {
    let network = network_file::read(path)?;
    let spacing = lines_spacing(&network, mesh.map_or(&[][..], |mesh| &mesh.vertices));
    Ok(Shown { network: Some(network), spacing, inputs: work.inputs.clone(), ..Shown::default() })
}

/// Points, and lines that are computed or read.
fn of_points(work: &Work, origin: &Origin, args: &Render) -> Result<Shown, Failure> {
    let input =
        work.load(origin, &io::ReadOptions { attributes: false, without_noise: true, ..Default::default() })?;
    let mut shown = Shown { inputs: work.inputs_with(&input), up: Some(input.up()), ..Shown::default() };
    let (found, network) = match args.network.to_str() {
        Some("none") => (None, None),
        Some("computed") => {
            let found = computed(work, origin, &input)?;
            shown.said = summary::of(&input, &found, work.args.running.verbose);
            let network = found.network.clone();
            (Some(found), Some(network))
        }
        _ => {
            let path = outputs::filled(&args.network, origin);
            shown.inputs.push(path.clone());
            (None, Some(network_file::read(&path)?))
        }
    };
    shown.network = network;
    (shown.surfels, shown.spacing) =
        surfels(&input.cloud).map_err(|e| Failure::from(e).at(origin.shown()))?;
    if let (Some(color), Some(found)) = (form::points(args), &found) {
        shown.tints = tints::of(color, found, &shown.surfels);
        shown.said.push(tints::legend(color, found));
    }
    Ok(shown)
}

fn computed(work: &Work, origin: &Origin, input: &Input) -> Result<Extraction, Failure> {
    work.extract(origin, input).map_err(|e| e.advise("`--network none` draws the points alone"))
}
