//! The command line of `classify`.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use lineament::detect::baselines::Detector;

use super::groups::Work;
use super::parse;

/// The head of the long help.
pub const ABOUT: &str = "\
Classify each point: 0 smooth, 1 crease, 2 border, 3 corner, 4 clutter

  lineament classify part.ply -o part.npy    the classes alone, as a NumPy array
  lineament classify part.ply -o part.las    the points with class, score and attributes

There is no default output: name at least one with -o.";

/// The foot of the help.
fn help() -> String {
    let formats = lineament_io::format_help(|format| format.points);
    format!("Formats by extension:\n{formats}\n\n{DETECTORS}\n\n{EXAMPLES}")
}

const DETECTORS: &str = "\
Detectors, each with an automatic threshold; points above it get 1, all others 0:
  projection            projected distance at each point's best scale (Tran 2013)
  surface-variation     least eigenvalue over the sum, 16 neighbours (Pauly 2003)
  mean-curvature        of a quadric fitted to 16 neighbours
  normal-difference     mean angle to the normals of 16 neighbours
  multiscale-variation  greatest surface variation of 8 to 32 neighbours
  persistence           share of these scales at which it is high";

const EXAMPLES: &str = "\
More examples:
  lineament classify part.ply -o sharp.npy --detector projection
  lineament classify part.ply -o part.scores.ply --scores";

/// Arguments of `classify`.
#[derive(Debug, Args)]
#[command(after_help = help())]
pub struct Classify {
    /// File to write a row for each point to, in the order of the input, dropped points with class 0; may be given
    /// several times. A folder gets NAME.classes.npy, `{stem}` stands for the name of the input, `-` is NPY on standard
    /// output
    #[arg(short, long, value_name = "OUT", required = true, value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Classify by this measure and its threshold alone, without lines; see below
    #[arg(long, value_name = "NAME", conflicts_with = "method", value_parser = parse::detector)]
    pub detector: Option<Detector>,
    /// Add the score of every detector to the points, in any format but NPY
    #[arg(long)]
    pub scores: bool,
    #[command(flatten)]
    pub work: Work,
}
