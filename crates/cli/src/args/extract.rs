//! The command line of `extract`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::groups::Work;
use super::parse;

const HELP: &str = "\
Formats by extension:
  .json     everything found, in the schema lineament-network/1
  .obj      lines
  .ply      vertices and edges
  .dxf      3D polylines and points, a layer a kind
  .svg      a drawing in millimetres, seen from --view
  .geojson  line strings and points, with the reference system of the input
  .gpkg     GeoPackage, layers of lines and nodes with their properties
  .glb      binary glTF lines
  .vtp      VTK polygonal data
  .csv      a row a point

Examples:
  lineament extract part.ply
  lineament extract part.ply -o lines/part.dxf --method penalty
  lineament extract part.ply --params tuning.toml --set penalty.fold_deg=15
  lineament extract scans/*.ply -o lines/ -o 'cad/{stem}.dxf'
  zcat scan.xyz.gz | lineament extract - -o - > lines.json";

/// Arguments of `extract`.
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub struct Extract {
    /// Where to write the lines; the extension says the format. May be given several times; a folder gets
    /// NAME.lines.json and NAME.lines.obj, `{stem}` stands for the input's name, `-` is JSON on standard output
    /// [default: NAME.lines.json and NAME.lines.obj beside the input]
    #[arg(short, long, value_name = "OUT", value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Where drawings (SVG) look from: auto, top, bottom, front, back, left, right, iso, or X,Y,Z
    #[arg(long, default_value = "auto", allow_hyphen_values = true)]
    pub view: String,
    /// Millimetres of a drawing (SVG) for one unit of the input [default: fit 200 mm]
    #[arg(long, value_name = "MM", value_parser = parse::length)]
    pub millimetres: Option<f64>,
    /// Write what the method `segments` goes through into this folder: its segmentation, each of its graphs (PLY), their
    /// counts and times (stages.json); of several inputs each into a folder of its own in it
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub stages: Option<PathBuf>,
    #[command(flatten)]
    pub work: Work,
}
