//! The command line of `clean`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::groups::Work;

/// The head of the long help.
pub const ABOUT: &str = "\
Leave out the points that lie on no surface: leaves, stray returns, veils between surfaces

  lineament clean room.laz -o room.clean.laz          the points on surfaces, with all their attributes
  lineament clean room.laz -o room.laz.npy            their positions alone, as a NumPy array
  lineament clean room.e57 -o room.ply --label        all points, with class 0 (surface) or 4 (clutter)
  lineament clean scans/*.ply -o 'clean/{stem}.ply'   several scans

There is no default output: name at least one with -o. Points that are not finite are left out too.";

/// The foot of the help.
fn help() -> String {
    format!("Formats by extension:\n{}\n\n{LABELS}", lineament_io::format_help(|format| format.points))
}

const LABELS: &str = "\
Without --label no format has a column of classes, NPY holds positions, and no format has scores.";

/// Arguments of `clean`.
#[derive(Debug, Args)]
#[command(after_help = help(), mut_arg("method", |arg| arg.hide(true)))]
pub struct Clean {
    /// File to write the points to, in the order of the input and the format of the extension; may be given several
    /// times. A folder gets NAME.clean.ply, `{stem}` stands for the name of the input, `-` is NPY on standard output
    #[arg(short, long, value_name = "OUT", required = true, value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Keep all points and add a column `class`: 0 on a surface or not finite, 4 clutter; NPY holds the classes. In LAS and
    /// LAZ clutter also gets classification 7, noise
    #[arg(long)]
    pub label: bool,
    #[command(flatten)]
    pub work: Work,
}
