//! The command line of `patches`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::groups::{Cad, Work};

/// The head of the long help.
pub const ABOUT: &str = "\
Divide a scan into its smooth patches and write their points, boundary loops and surfaces

  lineament patches part.ply -o part.patches.ply     the points with the number of their patch
  lineament patches part.ply -o part.patches.json    loops, areas and fitted surfaces

There is no default output: name at least one with -o. The method is `segments` unless --method, --params or
--set chooses another.";

/// The foot of the help.
fn help() -> String {
    format!("Formats by extension:\n{}", lineament_io::format_help(|format| format.patches))
}

/// Arguments of `patches`.
#[derive(Debug, Args)]
#[command(after_help = help())]
pub struct Patches {
    /// File to write the patches to, in the format of its extension; may be given several times. A folder gets
    /// NAME.patches.json and NAME.patches.ply, `{stem}` stands for the name of the input, `-` is JSON on standard output
    #[arg(short, long, value_name = "OUT", required = true, value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    #[command(flatten)]
    pub cad: Cad,
    /// Folder for the stages of the method, as of `extract`
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub stages: Option<PathBuf>,
    #[command(flatten)]
    pub work: Work,
}
