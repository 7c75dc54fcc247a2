//! The command line of `report`.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use lineament::section::Axis;

use super::groups::Work;
use super::parse;

/// The head of the long help.
pub const ABOUT: &str = "\
Find lines and patches of a scan and write them as a report that a browser opens

  lineament report part.ply                  writes part.html
  lineament report part.ply --slices 100     with a hundred sections and the features they show

The report is one file, which needs no network: turn the scan, filter its lines, read lengths and diameters, measure, cut, and
save the lines that are left as DXF, CSV or SVG.";

const HELP: &str = "\
The file holds up to 700,000 of the points and stays under 15 MB.

More examples:
  lineament report scans/*.ply -o reports/ -o 'all/{stem}.html'
  lineament report part.ply --method segments --slices 60 --axis x";

/// Arguments of `report`.
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub struct Report {
    /// HTML file to write; may be given several times. A folder gets NAME.html, `{stem}` stands for the name of the input
    /// [default: NAME.html beside the input]
    #[arg(short, long, value_name = "OUT.html", value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Axis that points up in the report: x, y, z or auto, which is y for glTF, as that format has it, and z for all others
    #[arg(long, default_value = "auto", value_parser = ["auto", "x", "y", "z"])]
    pub up: String,
    /// Number of sections to cut as well, evenly through the whole scan
    #[arg(long, help_heading = "Slices", value_name = "N", value_parser = parse::count)]
    pub slices: Option<usize>,
    /// Across the slices: x, y, z, a vector X,Y,Z, `auto`, `long` or `thin`, as `section` has it [default: auto]
    #[arg(long, help_heading = "Slices", requires = "slices", value_parser = parse::parameter::<Axis>)]
    #[arg(allow_hyphen_values = true)]
    pub axis: Option<Axis>,
    #[command(flatten)]
    pub work: Work,
}
