//! The command line of `slices`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::groups::{Running, Source};
use super::section::Slicing;

const HELP: &str = "\
Examples:
  lineament slices part.ply -o slices --count 40
  lineament slices scan.laz -o plans --at=0.5,1.5,2.5";

/// Arguments of `slices`.
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub struct Slices {
    #[command(flatten)]
    pub source: Source,
    /// The folder to write a picture a slice into: slice_0000.svg and so on; it is made if it is not there
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
    #[command(flatten)]
    pub slicing: Slicing,
    #[command(flatten)]
    pub running: Running,
}
