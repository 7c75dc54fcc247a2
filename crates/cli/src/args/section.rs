//! The command line of `section`.

use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use lineament::params::{Auto, ParamValue};
use lineament::section::{Axis, Planes, SectionParams, Zero};

use super::groups::{Cad, Running, Settings, Source};
use super::parse;

/// The head of the long help.
pub const ABOUT: &str = "\
Cut a scan by planes and write the curves in which they meet its surface

  lineament section part.ply -o part.dxf --axis z --count 20        20 slices through the whole part
  lineament section part.ply -o part.json --axis auto --count 60 --fit
                                                                    bores, bosses and steps by name

There is no default output: name at least one with -o. A folder gets NAME.sections.json and NAME.sections.dxf.";

const HELP: &str = "\
How a slice is drawn:
  Points near the plane are carried to it along the surface, so that a slanted wall stays a thin line; --no-carry
  projects them straight. The curve follows the middle of the points; --side out or in follows an edge of a thick band.
  hull and voronoi draw polylines with few vertices. Closed curves are solid (counter-clockwise) or holes.

With --fit:
  Each curve is described by lines, arcs, circles, ellipses and splines within --tolerance, and the stack of slices is read:
  extrusions, holes, tapers, revolutions, mirror planes and repeated outlines, each with its range and error. A run
  needs two slices or more (revolutions four): cut several through the thinnest feature that matters.

Parameters:
  The options are shorthands: --outline hull is --set section.outline=hull. `lineament params` lists these and others under
  [section]; --params reads them from a file.

More examples:
  lineament section scan.ply -o plan.svg --at=1.2 --from floor      a floor plan, 1.2 above the floor
  lineament section part.ply -o part.svg --adaptive 16              few slices where nothing changes
  lineament section part.ply -o part.json --axis 1,0,1 --step 2.5 --outline voronoi";

/// The foot of the help.
fn help() -> String {
    format!("Formats by extension:\n{}\n\n{HELP}", lineament_io::format_help(|format| format.section))
}

/// Arguments of `section`.
#[derive(Debug, Args)]
#[command(after_help = help())]
pub struct Section {
    #[command(flatten)]
    pub source: Source,
    /// File to write the sections to, in the format of its extension; may be given several times. A folder gets
    /// NAME.sections.json and NAME.sections.dxf, `{stem}` stands for the name of the input, `-` is JSON on standard output
    #[arg(short, long, help_heading = "Output", value_name = "OUT", required_unless_present = "sample")]
    #[arg(value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    #[command(flatten)]
    pub slicing: Slicing,
    /// Folder for the steps to the sections: slabs, points on the planes, hulls round by round, empty circles (PLY), with their counts
    /// (stages.json); several inputs get a folder each inside it
    #[arg(long, help_heading = "Output", value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub stages: Option<PathBuf>,
    /// Millimetres of a drawing (SVG) for one unit of the input [default: fit 200 mm]
    #[arg(long, help_heading = "Output", value_name = "MM", value_parser = parse::length)]
    pub millimetres: Option<f64>,
    #[command(flatten)]
    pub cad: Cad,
    #[command(flatten)]
    pub running: Running,
}

/// Where to cut and how to draw: shorthands for parameters under `section.`, which go over a file and under --set.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Slices")]
pub struct Slicing {
    /// Across the slices: x, y, z, a vector X,Y,Z, `auto` (the axis that most of the surface stands along, lies across or is
    /// turned about; of several the one along which sections change least often, then the longest), `long` (the longest
    /// principal axis) or `thin` (the principal axis for which slices project thinnest) [default: z]
    #[arg(long, value_parser = parse::parameter::<Axis>, allow_hyphen_values = true)]
    pub axis: Option<Axis>,
    /// Distance between slices, in the unit of the input
    #[arg(long, value_name = "LENGTH", group = "planes")]
    pub step: Option<f64>,
    /// Number of slices, evenly through the whole scan, at most 100000 [default: 10]
    #[arg(long, value_name = "N", group = "planes")]
    pub count: Option<usize>,
    /// Positions of the slices along the axis: Z1,Z2,...
    #[arg(
        long,
        value_name = "Z1,Z2,..",
        value_delimiter = ',',
        group = "planes",
        allow_hyphen_values = true
    )]
    pub at: Option<Vec<f64>>,
    /// Place that the positions of --at are counted from: the origin of the input, its lowest point along the axis, or the floor, which is
    /// the lowest large face across it with little of the surface below, and the lowest point where there is none [default: origin]
    #[arg(long, value_name = "origin|lowest|floor", value_parser = parse::parameter::<Zero>)]
    pub from: Option<Zero>,
    /// Start with this many slices, split them where neighbours differ and merge them where they are alike
    #[arg(long, value_name = "N", group = "planes")]
    pub adaptive: Option<usize>,
    /// Thickness of a slab in the unit of the input, or `auto`: from the local spacing [default: auto]
    #[arg(long, value_name = "T", value_parser = parse::parameter::<Auto<f64>>)]
    pub thickness: Option<Auto<f64>>,
    /// How curves are taken from the points of a slab [default: middle]
    #[arg(long, value_enum)]
    pub outline: Option<OutlineName>,
    /// With the outline `voronoi`: how far empty circles may lie from the curve, as a multiple of how far its points do
    /// (0.1 to 100); small for few vertices, large for many [default: 1.0]
    #[arg(long, value_name = "FACTOR")]
    pub circle_bound: Option<f64>,
    /// Which side of a thick band of points the curves follow [default: mid]
    #[arg(long, value_enum)]
    pub side: Option<SideName>,
    /// Project points straight onto the plane instead of carrying them along the surface
    #[arg(long)]
    pub no_carry: bool,
    /// Fit lines, arcs, circles, ellipses and splines, and name the features of the stack of slices
    #[arg(long)]
    pub fit: bool,
    /// Greatest distance of a fitted curve from its contour, in the unit of the input; implies --fit [default: auto]
    #[arg(long, value_name = "LENGTH")]
    pub tolerance: Option<f64>,
    #[command(flatten)]
    pub settings: Settings,
}

/// Names of [`Outline`].
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum OutlineName {
    /// The middle of the band by local regression
    Middle,
    /// Refined convex hull (Kyriazis, section 3)
    Hull,
    /// Largest empty circles (Kyriazis, section 4)
    Voronoi,
}

/// Names of [`Side`].
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum SideName {
    /// The middle
    Mid,
    /// Away from the inside of a closed contour
    Out,
    /// Towards it
    In,
}

impl Slicing {
    /// Sets the parameters that these arguments name.
    pub fn set(&self, params: &mut SectionParams) {
        let planes = [
            self.step.map(Planes::Every),
            self.count.map(Planes::Count),
            self.at.clone().map(Planes::At),
            self.adaptive.map(Planes::adaptive),
        ];
        put(&mut params.axis, self.axis);
        put(&mut params.planes, planes.into_iter().flatten().next());
        put(&mut params.from, self.from);
        put(&mut params.thickness, self.thickness);
        put(&mut params.carry, self.no_carry.then_some(false));
        put(&mut params.outline, self.outline.and_then(named));
        put(&mut params.circle_bound, self.circle_bound);
        put(&mut params.side, self.side.and_then(named));
        put(&mut params.fit, (self.fit || self.tolerance.is_some()).then_some(true));
        put(&mut params.tolerance, self.tolerance.map(Auto::Given));
    }
}

fn put<T>(parameter: &mut T, given: Option<T>) {
    if let Some(value) = given {
        *parameter = value;
    }
}

/// The value that has the name of a choice.
fn named<T: ParamValue>(choice: impl ValueEnum) -> Option<T> {
    choice.to_possible_value().and_then(|value| T::parse(value.get_name()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use lineament::section::{Outline, Side};

    #[test]
    fn every_choice_is_a_value_of_its_parameter() {
        assert!(OutlineName::value_variants().iter().all(|&v| named::<Outline>(v).is_some()));
        assert!(SideName::value_variants().iter().all(|&v| named::<Side>(v).is_some()));
    }
}
