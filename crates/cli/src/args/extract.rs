//! The command line of `extract`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::groups::{Cad, Work};
use super::parse;

/// The head of the long help.
pub const ABOUT: &str = "\
Find the feature lines of a scan and write them as curves

  lineament extract part.ply                writes part.lines.json and part.lines.obj
  lineament extract part.ply -o part.dxf    writes part.dxf alone

Without -o the files stand beside the input. Creases are lines where faces meet, borders lines where the surface ends; they join in junctions and corners.";

/// The foot of the help.
fn help() -> String {
    let formats = lineament_io::format_help(|format| format.network);
    format!("Formats by extension:\n{formats}\n\n{EXAMPLES}")
}

const EXAMPLES: &str = "\
More examples:
  lineament extract part.ply -o lines/part.dxf --method penalty
  lineament extract part.ply -o part.dxf --report holes.csv
  lineament extract part.ply --params tuning.toml --set penalty.fold_deg=15
  lineament extract scans/*.ply -o lines/ -o 'cad/{stem}.dxf'
  zcat scan.xyz.gz | lineament extract - -o - > lines.json";

/// Arguments of `extract`.
#[derive(Debug, Args)]
#[command(after_help = help())]
pub struct Extract {
    /// File to write the lines to, in the format of its extension; may be given several times. A folder gets
    /// NAME.lines.json and NAME.lines.obj, `{stem}` stands for the name of the input, `-` is JSON on standard output
    /// [default: NAME.lines.json and NAME.lines.obj beside the input]
    #[arg(short, long, value_name = "OUT", value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// List of the holes, bosses, other circles, arcs and straight edges with their tolerances: .txt for people, .csv, or `-`, text on
    /// standard output; `{stem}` as in -o
    #[arg(long, value_name = "LIST", value_hint = ValueHint::FilePath)]
    pub report: Option<PathBuf>,
    /// Leave out lines shorter than this, in the unit of the input
    #[arg(long, help_heading = "Choosing lines", value_name = "LENGTH", value_parser = parse::length)]
    pub min_length: Option<f64>,
    /// Leave out lines less certain than this, from 0 to 1
    #[arg(long, help_heading = "Choosing lines", value_name = "SHARE", value_parser = parse::share)]
    pub min_confidence: Option<f64>,
    /// Leave out borders around holes in the surface that are shorter than this, in the unit of the input: the edges of
    /// missing data, and of openings as small
    #[arg(long, help_heading = "Choosing lines", value_name = "LENGTH", value_parser = parse::length)]
    pub min_hole: Option<f64>,
    /// Move curves and nodes, within what the noise allows, so that lines are exactly parallel or at right angles, radii equal, and so on
    /// where they are that likely (as --set relations.regularise=true)
    #[arg(long)]
    pub regularise: bool,
    /// Viewpoint of drawings (SVG): auto, top, bottom, front, back, left, right, iso, or X,Y,Z
    #[arg(long, default_value = "auto", allow_hyphen_values = true)]
    pub view: String,
    /// Millimetres of a drawing (SVG) for one unit of the input [default: fit 200 mm]
    #[arg(long, value_name = "MM", value_parser = parse::length)]
    pub millimetres: Option<f64>,
    #[command(flatten)]
    pub cad: Cad,
    /// Version of the JSON schema: 2, or 1, which has no typed curves
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u8).range(1..=2))]
    pub schema: u8,
    /// Folder for the stages of the method `penalty`, `projection` or `segments`: what it measures at each point, and each of its
    /// graphs (PLY), with their counts (stages.json); several inputs get a folder each inside it
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub stages: Option<PathBuf>,
    #[command(flatten)]
    pub work: Work,
}
