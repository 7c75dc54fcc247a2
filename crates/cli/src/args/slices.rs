//! The command line of `slices`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::groups::{Running, Source};
use super::parse;
use super::section::Slicing;

/// The head of the long help.
pub const ABOUT: &str = "\
Cut a scan by planes and write a picture of each slice

  lineament slices part.ply -o slices --count 40         writes slices/slice_0000.svg to slice_0039.svg
  lineament slices scan.laz -o plans --at=0.5,1.5,2.5    three heights";

/// Arguments of `slices`.
#[derive(Debug, Args)]
pub struct Slices {
    #[command(flatten)]
    pub source: Source,
    /// Folder to write the pictures into, slice_0000.svg and so on; it is made if need be
    #[arg(short, long, help_heading = "Output", value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
    #[command(flatten)]
    pub slicing: Slicing,
    /// Millimetres of a picture for one unit of the input [default: fit 200 mm]
    #[arg(long, help_heading = "Output", value_name = "MM", value_parser = parse::length)]
    pub millimetres: Option<f64>,
    #[command(flatten)]
    pub running: Running,
}
