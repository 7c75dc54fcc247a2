//! The command line of `enrich`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use crate::args::groups::Work;
use crate::args::parse;

/// The head of the long help.
pub const ABOUT: &str = "\
Add points along the creases and borders of a scan, and at its corners

  lineament enrich part.ply -o part.enriched.ply              the points, followed by those on the lines
  lineament enrich part.ply -o dense.ply --step 0.5           twice as dense along the lines as the scan is
  lineament enrich part.ply -o lines.ply --added              the new points alone

A scanner hardly ever hits an edge, so that programs that know nothing of edges cut them off. With points on the edges they keep
them (Gumhold 2001, section 5.2).

There is no default output: name at least one with -o.";

/// The foot of the help.
fn help() -> String {
    format!("Formats by extension:\n{}\n\n{COLUMNS}", lineament_io::format_help(|format| format.points))
}

const COLUMNS: &str = "\
There is no column of scores, and NPY holds the positions. Two columns are added:
  class  0 smooth, 1 crease, 2 border, 3 corner, 4 clutter
  added  1 of a new point, 0 of a point of the input
A new point has the other attributes of the point next to it; normals, which an edge has none of, are not numbers.";

/// Arguments of `enrich`.
#[derive(Debug, Args)]
#[command(after_help = help())]
pub struct Enrich {
    /// File to write the points to: those of the input in their order, then the new ones; in the format of the extension. May be
    /// given several times. A folder gets NAME.enriched.ply, `{stem}` stands for the name of the input, `-` is NPY on
    /// standard output
    #[arg(short, long, value_name = "OUT", required = true, value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Distance between the points along a line, in spacings of the scan there
    #[arg(long, value_name = "SPACINGS", default_value_t = 1.0, value_parser = parse::length)]
    pub step: f64,
    /// Write the new points alone
    #[arg(long)]
    pub added: bool,
    #[command(flatten)]
    pub work: Work,
}
