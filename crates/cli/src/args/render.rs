//! The command line of `render`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::groups::Work;
use super::parse;

const HELP: &str = "\
Creases are red, borders blue, junctions black, corners green, ends pink. What the surface hides is
faint and dashed.

Examples:
  lineament render part.ply -o part.png
  lineament render part.ply -o top.png --view top --size 2400x1800
  lineament render part.ply -o part.png --network part.lines.json";

/// Arguments of `render`.
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub struct Render {
    /// The PNG file to write; a folder gets NAME.png, `{stem}` stands for the input's name, `-` is standard output
    #[arg(short, long, value_name = "OUT.png", required = true, value_hint = ValueHint::FilePath)]
    pub output: PathBuf,
    /// Where to look from: auto, top, bottom, front, back, left, right, iso, or X,Y,Z, a direction towards the eye
    #[arg(long, default_value = "auto", allow_hyphen_values = true)]
    pub view: String,
    /// The axis that points up in the picture: x, y or z
    #[arg(long, default_value = "z", value_parser = ["x", "y", "z"])]
    pub up: String,
    /// Width and height of the picture in pixels
    #[arg(long, value_name = "WxH", default_value = "1600x1200", value_parser = parse::size)]
    pub size: (usize, usize),
    /// The lines to draw: `computed`, `none`, or a JSON file that `extract` wrote, `{stem}` as in -o
    #[arg(long, value_name = "FILE.json", default_value = "computed", value_hint = ValueHint::FilePath)]
    pub network: PathBuf,
    /// Leave out the line of text that says what the colours mean
    #[arg(long)]
    pub no_caption: bool,
    #[command(flatten)]
    pub work: Work,
}
