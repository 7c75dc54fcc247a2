//! The command line of `patches`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::groups::Work;

const HELP: &str = "\
Formats by extension:
  .json                           loops, neighbours, areas and surfaces, in the schema lineament-network/1
  .dxf                            the loops as 3D polylines, a layer a patch
  .ply .pcd .xyz .csv .las .laz   the points and their attributes, with the patch of each; -1 for none

The lines are those of the method `segments` unless --method, --params or --set says otherwise.

Examples:
  lineament patches part.ply -o part.patches.json -o part.patches.ply
  lineament patches part.ply -o part.dxf";

/// Arguments of `patches`.
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub struct Patches {
    /// Where to write the patches; the extension says what and how. May be given several times; a folder gets
    /// NAME.patches.json and NAME.patches.ply, `{stem}` stands for the input's name, `-` is JSON on standard output
    #[arg(short, long, value_name = "OUT", required = true, value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Write what the method `segments` goes through into this folder, as `extract` does
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub stages: Option<PathBuf>,
    #[command(flatten)]
    pub work: Work,
}
