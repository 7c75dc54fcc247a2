//! The command line as it is typed. Nothing is checked here that needs more than the text.

mod help;
mod parse;

use std::path::PathBuf;

use clap::{ArgAction, Args as ClapArgs, Parser, Subcommand, ValueHint};
use clap_complete::Shell;
use lineament::detect::baselines::Detector;
use lineament_io::Format;

/// Feature lines from point clouds: creases, borders and corners as ordered curves.
///
/// Reads a scan of a surface and writes the lines where faces meet (creases) and where the surface ends (borders),
/// joined in junctions and corners. No parameter needs to be set.
#[derive(Debug, Parser)]
#[command(name = "lineament", version, after_long_help = help::EXAMPLES, max_term_width = 110)]
pub struct Args {
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Find the feature lines of a scan and write them as curves
    Extract(Extract),
    /// Say of each point whether it lies on a line: 0 smooth, 1 crease, 2 border, 3 corner
    Classify(Classify),
    /// Divide a scan into its smooth patches and write their points, boundary loops and surfaces
    Patches(Patches),
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
#[command(after_help = help::EXTRACT_HELP)]
pub struct Extract {
    /// Where to write the lines; the extension says the format. May be given several times; a folder gets
    /// NAME.lines.json and NAME.lines.obj, `{stem}` stands for the input's name, `-` is JSON on standard output
    /// [default: NAME.lines.json and NAME.lines.obj beside the input]
    #[arg(short, long, value_name = "OUT", value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Where drawings (SVG) look from: auto, top, bottom, front, back, left, right, iso, or X,Y,Z
    #[arg(long, default_value = "auto", allow_hyphen_values = true)]
    pub view: String,
    /// Millimetres of a drawing (SVG) for one unit of the input [default: fit 200 mm]
    #[arg(long, value_name = "MM", value_parser = parse::length)]
    pub millimetres: Option<f64>,
    /// Write what the method `segments` goes through into this folder: its segmentation, each of its graphs (PLY), their
    /// counts and times (stages.json); of several inputs each into a folder of its own in it
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub stages: Option<PathBuf>,
    #[command(flatten)]
    pub work: Work,
}

/// Arguments of `classify`.
#[derive(Debug, ClapArgs)]
#[command(after_help = help::CLASSIFY_HELP)]
pub struct Classify {
    /// Where to write one row a point, in the order of the input; points that were dropped are 0. May be given several
    /// times; a folder gets NAME.classes.npy, `{stem}` stands for the input's name, `-` is NPY on standard output
    #[arg(short, long, value_name = "OUT", required = true, value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// Mark the points by this measure and its threshold alone, without looking for lines; see below
    #[arg(long, value_name = "NAME", conflicts_with = "method", value_parser = parse::detector)]
    pub detector: Option<Detector>,
    /// Write the score of every detector as an attribute of the points, in any format but NPY
    #[arg(long)]
    pub scores: bool,
    #[command(flatten)]
    pub work: Work,
}

/// Arguments of `patches`.
#[derive(Debug, ClapArgs)]
#[command(after_help = help::PATCHES_HELP)]
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

/// Arguments of `render`.
#[derive(Debug, ClapArgs)]
#[command(after_help = help::RENDER_HELP)]
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

/// Arguments of `info`.
#[derive(Debug, ClapArgs)]
pub struct Info {
    #[command(flatten)]
    pub source: Source,
    /// Read only every N-th point
    #[arg(long, help_heading = "Reading", value_name = "N", conflicts_with = "sample", value_parser = parse::count)]
    pub every: Option<usize>,
}

/// What the commands that extract have in common.
#[derive(Clone, Debug, ClapArgs)]
pub struct Work {
    #[command(flatten)]
    pub source: Source,
    /// Read only every N-th point
    #[arg(long, help_heading = "Reading", value_name = "N", conflicts_with = "sample", value_parser = parse::count)]
    pub every: Option<usize>,
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
    #[command(flatten)]
    pub reading: Reading,
}

/// What of a file is read.
#[derive(Clone, Debug, Default, ClapArgs)]
#[command(next_help_heading = "Reading")]
pub struct Reading {
    /// Read only the points inside this box, its faces included
    #[arg(long, value_name = "X,Y,Z,X,Y,Z", value_parser = parse::bounds, allow_hyphen_values = true)]
    #[arg(conflicts_with = "sample")]
    pub bounds: Option<[[f64; 3]; 2]>,
    /// Read only one point of every cube with this edge, in the unit of the input
    #[arg(long, value_name = "SIZE", conflicts_with = "sample", value_parser = parse::length)]
    pub voxel: Option<f64>,
    /// Read only one scan of a file that holds several, counted from 1
    #[arg(long, value_name = "N", conflicts_with = "sample", value_parser = parse::count)]
    pub scan: Option<usize>,
    /// Take the input for this format, whatever it looks like
    #[arg(long, value_name = "NAME", conflicts_with = "sample", value_parser = parse::format)]
    pub input_format: Option<Format>,
    /// Memory that the points of a compressed input may take, such as 4G [default: 64M and eight times the file]
    #[arg(long, value_name = "BYTES", conflicts_with = "sample", value_parser = parse::bytes)]
    pub memory: Option<u64>,
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
    #[arg(long, value_name = "KEY=VALUE", value_parser = parse::setting)]
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

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Args::command().debug_assert();
    }
}
