//! The command line of `classify`.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use lineament::detect::baselines::Detector;

use super::groups::Work;
use super::parse;

const HELP: &str = "\
Formats by extension:
  .npy                                the classes alone, a byte a point
  .ply .pcd .xyz .csv .las .laz .npz .parquet
                                      the points and their attributes, with class and score

Detectors, each with an automatic threshold; a point above it is 1, all others 0:
  projection            projected distance at each point's best scale (Tran 2013)
  surface-variation     least eigenvalue over the sum, 16 neighbours (Pauly 2003)
  mean-curvature        of a quadric fitted to 16 neighbours
  normal-difference     mean angle to the normals of 16 neighbours
  multiscale-variation  greatest surface variation of 8 to 32 neighbours
  persistence           share of these scales at which it is high

Examples:
  lineament classify part.ply -o part.classes.npy -o part.classes.ply
  lineament classify part.ply -o sharp.npy --detector projection
  lineament classify part.ply -o part.scores.ply --scores";

/// Arguments of `classify`.
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub struct Classify {
    /// Where to write one row a point, in the order of the input; points that were dropped are 0. May be given several
    /// times; a folder gets NAME.classes.npy, `{stem}` stands for the input's name, `-` is NPY on standard output
    #[arg(short, long, value_name = "OUT", required = true, value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Mark the points by this measure and its threshold alone, without looking for lines; see below
    #[arg(long, value_name = "NAME", conflicts_with = "method", value_parser = parse::detector)]
    pub detector: Option<Detector>,
    /// Write the score of every detector as an attribute of the points, in any format but NPY
    #[arg(long)]
    pub scores: bool,
    #[command(flatten)]
    pub work: Work,
}
