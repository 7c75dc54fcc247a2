//! `lineament mesh`.

use std::path::PathBuf;
use std::time::Instant;

use lineament::apply::{MeshOptions, SurfaceMesh, mesh_surface};
use lineament_io::{ReadOptions, mesh_format, write_mesh};

use crate::args;
use crate::batch::Done;
use crate::failure::Failure;
use crate::source::{self, Origin};
use crate::summary::plural;
use crate::work::{self, Work};
use crate::{outputs, summary};

/// Suffixes of the files that a folder gets.
const SUFFIXES: [&str; 1] = ["mesh.ply"];

/// Reads, extracts, and writes a mesh whose edges follow the lines.
pub fn run(args: &args::Mesh) -> Result<(), Failure> {
    if source::is_list(&args.work.source) {
        return source::print_list();
    }
    let work = work::prepare(&args.work, &args.output, &SUFFIXES, mesh_format)?;
    work.each(|origin, outputs| one(&work, args, origin, outputs))
}

fn one(work: &Work, args: &args::Mesh, origin: &Origin, outputs: &[PathBuf]) -> Result<Done, Failure> {
    let start = Instant::now();
    let input =
        work.load(origin, &ReadOptions { attributes: false, without_noise: true, ..Default::default() })?;
    let found = work.extract(origin, &input)?;
    let meshing = Instant::now();
    let usual = MeshOptions::default();
    let options = match args.no_enrich {
        true => MeshOptions { step: None, apart: false },
        false => MeshOptions { step: args.step.or(usual.step), ..usual },
    };
    let mesh = mesh_surface(&input.cloud, &found, &work.params, &options)
        .map_err(|e| Failure::from(e).at(origin.shown()))?;
    let took = meshing.elapsed().as_secs_f64();
    let inputs = work.inputs_with(&input);
    for path in outputs {
        outputs::write(path, || write_mesh(path, &inputs, &mesh))?;
    }
    let mut lines = summary::of(&input, &found, work.args.running.verbose);
    lines.push(format!("{} in {took:.1} s", counts(&mesh)));
    lines.push(summary::written(outputs));
    let seconds = start.elapsed().as_secs_f64();
    Ok(Done { lines, row: summary::row(found.report.read, Some(&found.network), seconds) })
}

fn counts(mesh: &SurfaceMesh) -> String {
    let open = match mesh.open_edges() {
        0 => "closed".into(),
        open => plural(open, "open edge"),
    };
    let vertices = summary::grouped(mesh.vertices.len());
    format!("{} over {vertices} vertices, {open}", plural(mesh.triangles.len(), "triangle"))
}
