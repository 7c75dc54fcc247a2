//! The command line as it is typed. Nothing is checked here that needs more than the text.

use std::path::PathBuf;

use clap::{ArgAction, Args as ClapArgs, Parser, Subcommand, ValueHint};
use clap_complete::Shell;
use lineament::detect::baselines::Detector;

const EXAMPLES: &str = "\
Examples:
  lineament extract --sample bracket -o bracket.obj     a generated scan, to try it out
  lineament extract part.ply                            writes part.lines.json and .obj
  lineament extract part.ply -o part.dxf -o part.json   several formats, by extension
  lineament render part.ply -o part.png                 look at it
  lineament params > tuning.toml                        every parameter, with its meaning

Exit codes:
  0    everything asked for was done
  1    of several inputs one or more failed, the others have their results
  2    the command line does not make sense
  3    an input cannot be read, or is malformed
  4    refused: a parameter is out of range, or the points have no surface
  5    an output could not be written
  130  interrupted; no file is left half-written";

/// Feature lines from point clouds: creases, borders and corners as ordered curves.
///
/// Reads a scan of a surface and writes the lines where faces meet (creases) and where the surface ends (borders),
/// joined in junctions and corners. No parameter needs to be set.
#[derive(Debug, Parser)]
#[command(name = "lineament", version, after_long_help = EXAMPLES, max_term_width = 110)]
pub struct Args {
    #[command(subcommand)]
    pub command: Command,
}

const EXTRACT_HELP: &str = "\
Formats by extension:
  .json  everything found, in the schema lineament-network/1
  .obj   lines, grouped by kind
  .ply   vertices and edges
  .dxf   3D polylines, a layer a kind

Examples:
  lineament extract part.ply
  lineament extract part.ply -o lines/part.dxf --method penalty
  lineament extract part.ply --params tuning.toml --set penalty.fold_deg=15
  lineament extract scans/*.ply -o lines/ -o 'cad/{stem}.dxf'
  zcat scan.xyz.gz | lineament extract - -o - > lines.json";

const CLASSIFY_HELP: &str = "\
Formats by extension:
  .npy  classes as u8, one a point
  .ply  the points and their attributes with class and score

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

const RENDER_HELP: &str = "\
Creases are red, borders blue, junctions black, corners green, ends pink. What the surface hides is
faint and dashed.

Examples:
  lineament render part.ply -o part.png
  lineament render part.ply -o top.png --view top --size 2400x1800
  lineament render part.ply -o part.png --network part.lines.json";

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Find the feature lines of a scan and write them as curves
    Extract(Extract),
    /// Say of each point whether it lies on a line: 0 smooth, 1 crease, 2 border, 3 corner
    Classify(Classify),
    /// Draw a scan and its lines as a PNG picture
    Render(Render),
    /// Cut a scan by planes and write the curves in which they meet its surface
    Section(crate::section_args::Section),
    /// Cut a scan by planes and write a picture a slice
    Slices(crate::section_args::Slices),
    /// Tell what a scan file holds
    Info(Info),
    /// Print every parameter as a commented TOML file
    Params(Tuning),
    /// Print a completion script for a shell
    Completions {
        /// The shell that will read the script
        shell: Shell,
    },
    /// Write the manual pages into a folder
    #[command(hide = true)]
    Man {
        /// An existing folder
        folder: PathBuf,
    },
}

/// Arguments of `extract`.
#[derive(Debug, ClapArgs)]
#[command(after_help = EXTRACT_HELP)]
pub struct Extract {
    /// Where to write the lines; the extension says the format. May be given several times; a folder gets
    /// NAME.lines.json and NAME.lines.obj, `{stem}` stands for the input's name, `-` is JSON on standard output
    /// [default: NAME.lines.json and NAME.lines.obj beside the input]
    #[arg(short, long, value_name = "OUT", value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    #[command(flatten)]
    pub work: Work,
}

/// Arguments of `classify`.
#[derive(Debug, ClapArgs)]
#[command(after_help = CLASSIFY_HELP)]
pub struct Classify {
    /// Where to write one row a point, in the order of the input; points that were dropped are 0. May be given several
    /// times; a folder gets NAME.classes.npy, `{stem}` stands for the input's name, `-` is NPY on standard output
    #[arg(short, long, value_name = "OUT", required = true, value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Mark the points by this measure and its threshold alone, without looking for lines; see below
    #[arg(long, value_name = "NAME", conflicts_with = "method", value_parser = parse_detector)]
    pub detector: Option<Detector>,
    /// Write the score of every detector as an attribute of the points (PLY)
    #[arg(long)]
    pub scores: bool,
    #[command(flatten)]
    pub work: Work,
}

/// Arguments of `render`.
#[derive(Debug, ClapArgs)]
#[command(after_help = RENDER_HELP)]
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
    #[arg(long, value_name = "WxH", default_value = "1600x1200", value_parser = parse_size)]
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

/// Arguments of `info`.
#[derive(Debug, ClapArgs)]
pub struct Info {
    #[command(flatten)]
    pub source: Source,
}

/// What the commands that extract have in common.
#[derive(Clone, Debug, ClapArgs)]
pub struct Work {
    #[command(flatten)]
    pub source: Source,
    #[command(flatten)]
    pub tuning: Tuning,
    #[command(flatten)]
    pub running: Running,
}

/// Where the points come from.
#[derive(Clone, Debug, ClapArgs)]
pub struct Source {
    /// The scans to read, each on its own; `-` is standard input
    #[arg(value_hint = ValueHint::FilePath, required_unless_present = "sample", conflicts_with = "sample")]
    pub input: Vec<PathBuf>,
    /// Use a generated scan instead of a file; `list` lists them
    #[arg(long, value_name = "NAME")]
    pub sample: Option<String>,
    /// Seed of the generated scan
    #[arg(long, value_name = "N", requires = "sample", default_value_t = 1)]
    pub seed: u64,
    /// Of a file that ends early, read what is whole, and say how much is missing
    #[arg(long)]
    pub salvage: bool,
    /// Refuse scans with points that are not finite instead of leaving those out
    #[arg(long)]
    pub strict: bool,
}

/// What the extraction may be told; nothing needs to be.
#[derive(Clone, Debug, Default, ClapArgs)]
pub struct Tuning {
    /// The detection method: same as --set method=M
    #[arg(long, value_name = "M")]
    pub method: Option<String>,
    /// Read parameters from a TOML file, such as `lineament params` prints
    #[arg(long, value_name = "FILE.toml", value_hint = ValueHint::FilePath)]
    pub params: Option<PathBuf>,
    /// Set one parameter, such as `penalty.gamma=0.4`; may be given several times and goes over the file
    #[arg(long, value_name = "KEY=VALUE", value_parser = parse_setting)]
    pub set: Vec<(String, String)>,
}

/// How the run goes.
#[derive(Clone, Debug, Default, ClapArgs)]
pub struct Running {
    /// Number of threads [default: one a core]; the result does not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Say nothing but errors
    #[arg(short, long, conflicts_with = "verbose")]
    pub quiet: bool,
    /// Say more: the values chosen for automatic parameters, what was passed over in the input
    #[arg(short, long, action = ArgAction::SetTrue)]
    pub verbose: bool,
}

fn parse_setting(text: &str) -> Result<(String, String), String> {
    let (key, value) = text.split_once('=').ok_or("write KEY=VALUE, such as penalty.gamma=0.4")?;
    Ok((key.trim().into(), value.trim().into()))
}

fn parse_detector(text: &str) -> Result<Detector, String> {
    let names = || Detector::ALL.map(Detector::name).join(", ");
    Detector::named(text).ok_or_else(|| format!("the detectors are {}", names()))
}

fn parse_size(text: &str) -> Result<(usize, usize), String> {
    let sides = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    sides.ok_or_else(|| "write WIDTHxHEIGHT in pixels, such as 1600x1200".into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Args::command().debug_assert();
    }

    #[test]
    fn settings_split_at_the_first_equals_sign() {
        assert_eq!(parse_setting("a.b = c=d"), Ok(("a.b".into(), "c=d".into())));
        assert!(parse_setting("a.b").is_err());
    }

    #[test]
    fn sizes_are_width_by_height() {
        assert_eq!(parse_size("800x600"), Ok((800, 600)));
        for bad in ["800", "x", "800x", "8x6x4", "-8x6", "800x6.5"] {
            assert!(parse_size(bad).is_err(), "{bad}");
        }
    }
}
