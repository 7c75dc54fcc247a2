//! The command line of `evaluate`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::groups::Running;
use super::parse;

/// The head of the long help.
pub const ABOUT: &str = "\
Score lines against known ones, or compare two results

  lineament evaluate part.lines.json --truth part.dxf                 a table of figures
  lineament evaluate new.json --truth old.json                        what changed from one run to another
  lineament evaluate part.lines.json --truth truth.json -o score.png  with a picture of what was missed and what is false

Both are lines in JSON, DXF, STEP or OBJ, or a mesh (STL, OBJ, PLY, ...), which stands for the edges between its faces. The table
goes to standard output; -o writes all figures, and pictures.";

const HELP: &str = "\
Formats of -o by extension:
  .json  every figure, and the stretches that were missed or are false
  .png   a picture: right grey, missed orange, false blue; over the scan with --points
  .svg   the same as a drawing

More examples:
  lineament evaluate part.lines.json --truth part.stl --points part.ply -o score.json -o score.png
  lineament evaluate part.lines.json --truth truth.json --points part.ply --labels labels.u8
  lineament evaluate marks.npy --labels labels.u8                      marks of `classify` against labels";

/// Arguments of `evaluate`.
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub struct Evaluate {
    /// Lines to score; without --truth marks of points: the classes that `classify` wrote (.npy, .npz, .ply, ...), bytes (.u8) or text
    #[arg(value_name = "RESULT", value_hint = ValueHint::FilePath)]
    pub result: PathBuf,
    /// The known lines, or those of another run
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, required_unless_present = "labels")]
    pub truth: Option<PathBuf>,
    /// The scan of both: for the picture, and for the spacing where no file states it
    #[arg(long, value_name = "SCAN", value_hint = ValueHint::FilePath, requires = "truth")]
    pub points: Option<PathBuf>,
    /// A label for each point of the scan: 1 on an edge, 2 near one, 3 neither way, 0 else (.u8, .npy or text, or a column `class`). Lines found beside
    /// points of label 3 count neither for nor against
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub labels: Option<PathBuf>,
    /// Mean spacing of the points, in the unit of the lines [default: of the truth, of --points, or of the result]
    #[arg(long, value_name = "LENGTH", value_parser = parse::length)]
    pub spacing: Option<f64>,
    /// Further tolerances, in spacings; the first is that of the picture and of what was missed [default: 1 and 2]
    #[arg(long, value_name = "N,N,..", value_delimiter = ',', value_parser = parse::length)]
    pub tolerance: Vec<f64>,
    /// Angle between the faces of a mesh beyond which their edge is a line, degrees
    #[arg(long, value_name = "DEG", default_value_t = 30.0, value_parser = parse::angle)]
    pub angle: f64,
    /// File to write, in the format of its extension; may be given several times
    #[arg(short, long, value_name = "OUT", value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Viewpoint of pictures: auto, top, bottom, front, back, left, right, iso, or X,Y,Z, a direction towards the eye
    #[arg(long, default_value = "auto", allow_hyphen_values = true)]
    pub view: String,
    /// Width and height of a picture in pixels
    #[arg(long, value_name = "WxH", default_value = "1600x1200", value_parser = parse::size)]
    pub size: (usize, usize),
    #[command(flatten)]
    pub running: Running,
}
