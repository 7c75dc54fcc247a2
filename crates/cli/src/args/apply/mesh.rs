//! The command line of `mesh`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use crate::args::groups::Work;
use crate::args::parse;

/// The head of the long help.
pub const ABOUT: &str = "\
Make a mesh of triangles of a scan, whose edges follow its creases and borders

  lineament mesh part.ply -o part.stl                 a mesh with sharp edges, turned outwards
  lineament mesh part.ply -o part.obj --step 0.5      vertices on the creases half a spacing apart
  lineament mesh part.ply -o smooth.ply --no-enrich   of the points of the scan alone, which cuts the creases off

The vertices are points of the scan and points on the lines found in it; points beside a line give way to those on it. The
triangles are Delaunay triangles, which keep to one side of a crease but in gaps that nothing else closes (Gumhold 2001, sections
2.1, 5.1 and 5.2). The mesh is a manifold; where the scan ends or has a large hole, so does the mesh, and some small gaps stay
open: the summary counts their edges. It goes through the points: noise stays in it.

There is no default output: name at least one with -o.";

/// The foot of the help.
fn help() -> String {
    format!("Formats by extension:\n{}", lineament_io::format_help(|format| format.mesh))
}

/// Arguments of `mesh`.
#[derive(Debug, Args)]
#[command(after_help = help())]
pub struct Mesh {
    /// File to write the mesh to, in the format of its extension; may be given several times. A folder gets NAME.mesh.ply,
    /// `{stem}` stands for the name of the input, `-` is PLY on standard output
    #[arg(short, long, value_name = "OUT", required = true, value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Distance between the vertices along a line, in spacings of the scan there [default: 0.7]
    #[arg(long, value_name = "SPACINGS", value_parser = parse::length)]
    pub step: Option<f64>,
    /// Put no vertices on the lines, and let triangles join their sides
    #[arg(long, conflicts_with = "step")]
    pub no_enrich: bool,
    #[command(flatten)]
    pub work: Work,
}
