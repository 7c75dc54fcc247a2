//! The command line of `render`.

use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use lineament_io::Unit;

use super::groups::Work;
use super::parse;

/// The head of the long help.
pub const ABOUT: &str = "\
Draw a scan and its lines as a PNG picture, or the lines alone as a PNG or SVG drawing

  lineament render part.ply -o part.png                              computes the lines
  lineament render part.ply -o part.png --network part.lines.json    lines of `extract`
  lineament render part.ply -o part.svg                              a line drawing in vectors, hidden parts dashed
  lineament render part.lines.json --surface part.stl -o part.svg    lines without points, hidden by a mesh

A line drawing has creases, borders, isolated peaks and the outlines of the surface. There is no default output: name it with -o.";

const HELP: &str = "\
Creases are red, borders blue, junctions black, corners green, ends pink; lines behind the surface are faint and
dashed.

More examples:
  lineament render part.ply -o top.png --view top --size 2400x1800
  lineament render part.ply -o points.png --network none
  lineament render part.ply -o sheet.svg --view front,top,left,iso --hidden dashed --scale-bar --unit mm
  lineament render part.ply -o ink.png --style lines --hidden none --color ink --background none
  lineament render part.ply -o patches.png --point-color patch";

/// Arguments of `render`.
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub struct Render {
    /// File to write, PNG or, with the lines alone, SVG; may be given several times. A folder gets NAME.png, `{stem}` stands for
    /// the name of the input, `-` is PNG on standard output
    #[arg(short, long, value_name = "OUT", required = true, value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Viewpoint: auto, top, bottom, front, back, left, right, iso, or X,Y,Z, a direction towards the eye; several with commas
    /// between them stand on one sheet, of one scale
    #[arg(long, value_name = "VIEW,..", default_value = "auto", allow_hyphen_values = true)]
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
    /// Picture of the shaded surface and its lines, or a line drawing, which SVG always is
    #[arg(long, value_enum, default_value = "shaded")]
    pub style: PictureStyle,
    /// The surface that is seen and hides lines: the `points`, `none`, or a file of a mesh
    #[arg(long, value_name = "points|none|MESH", default_value = "points", value_hint = ValueHint::FilePath)]
    pub surface: PathBuf,
    /// Lines behind the surface: left out, dashed, or drawn like the others
    #[arg(long, value_enum, default_value = "dashed")]
    pub hidden: HiddenLines,
    /// Colours of lines: their kind, the confidence in them, or black ink [default: kind]
    #[arg(long, value_enum)]
    pub color: Option<LineColor>,
    /// Colours of the points: their class, which tells clutter too, their score, or their patch [default: white]
    #[arg(long, value_enum)]
    pub point_color: Option<PointColor>,
    /// Ground of the picture: white, or none, which is transparent
    #[arg(long, default_value = "white", value_parser = ["white", "none"])]
    pub background: String,
    /// Draw a scale bar
    #[arg(long)]
    pub scale_bar: bool,
    /// Unit of the input that the scale bar names: mm, cm, m, in, ft or us-ft
    #[arg(long, value_parser = parse::unit, requires = "scale_bar")]
    pub unit: Option<Unit>,
    /// Leave out the caption with the meaning of the colours
    #[arg(long)]
    pub no_caption: bool,
    #[command(flatten)]
    pub work: Work,
}

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PictureStyle {
    Shaded,
    Lines,
}

/// What becomes of lines behind the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum HiddenLines {
    None,
    Dashed,
    Solid,
}

/// What the colours of lines tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum LineColor {
    Kind,
    Confidence,
    Ink,
}

/// What the colours of points tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PointColor {
    Class,
    Score,
    Patch,
}

impl PointColor {
    /// As on the command line.
    pub fn name(self) -> &'static str {
        match self {
            PointColor::Class => "class",
            PointColor::Score => "score",
            PointColor::Patch => "patch",
        }
    }
}
