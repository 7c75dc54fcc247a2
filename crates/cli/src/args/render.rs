//! The command line of `render`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::groups::Work;
use super::parse;

/// The head of the long help.
pub const ABOUT: &str = "\
Draw a scan and its lines as a PNG picture

  lineament render part.ply -o part.png                              computes the lines
  lineament render part.ply -o part.png --network part.lines.json    lines of `extract`

There is no default output: name it with -o.";

const HELP: &str = "\
Creases are red, borders blue, junctions black, corners green, ends pink; lines behind the surface are faint and
dashed.

More examples:
  lineament render part.ply -o top.png --view top --size 2400x1800
  lineament render part.ply -o points.png --network none";

/// Arguments of `render`.
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub struct Render {
    /// PNG file to write; a folder gets NAME.png, `{stem}` stands for the name of the input, `-` is standard output
    #[arg(short, long, value_name = "OUT.png", required = true, value_hint = ValueHint::FilePath)]
    pub output: PathBuf,
    /// Viewpoint: auto, top, bottom, front, back, left, right, iso, or X,Y,Z, a direction towards the eye
    #[arg(long, default_value = "auto", allow_hyphen_values = true)]
    pub view: String,
    /// Axis that points up in the picture: x, y, z or auto, which is y for glTF, as that format has it, and z for all others
    #[arg(long, default_value = "auto", value_parser = ["auto", "x", "y", "z"])]
    pub up: String,
    /// Width and height of the picture in pixels
    #[arg(long, value_name = "WxH", default_value = "1600x1200", value_parser = parse::size)]
    pub size: (usize, usize),
    /// Lines to draw: `computed`, `none`, or a JSON file written by `extract`, `{stem}` as in -o
    #[arg(long, value_name = "FILE.json", default_value = "computed", value_hint = ValueHint::FilePath)]
    pub network: PathBuf,
    /// Leave out the caption with the meaning of the colours
    #[arg(long)]
    pub no_caption: bool,
    #[command(flatten)]
    pub work: Work,
}
