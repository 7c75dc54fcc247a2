//! The command line of `section`.

use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use lineament::section::{Axis, Outline, Planes, SectionParams, Side};

use super::groups::{Running, Source};

const HELP: &str = "\
How a slice is drawn:
  Points near the plane are carried to it along the surface, so that a slanted wall stays a thin line; --no-carry
  projects them straight. The curve follows the middle of the points; --side out or in follows an edge of a thick band.
  hull and voronoi draw polylines with few vertices. Closed curves are solid (counter-clockwise) or holes.

With --fit:
  Each curve is described by lines, arcs, circles and splines within --tolerance, and the stack of slices is read:
  extrusions, holes, tapers, revolutions, mirror planes and repeated outlines, each with its range and error. A run
  needs two slices or more (revolutions four): cut several through the thinnest feature that matters.

Examples:
  lineament section part.ply -o part.dxf --axis z --count 20        20 slices through the whole part
  lineament section scan.ply -o plan.svg -o plan.json --at=1.2      a floor plan at one height
  lineament section part.ply -o part.json --axis auto --count 60 --fit
                                                                    what bores, bosses and steps it has
  lineament section part.ply -o part.svg --adaptive 16              few slices where nothing changes
  lineament section part.ply -o part.json --axis 1,0,1 --every 2.5 --outline voronoi";

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
    /// Where to write the sections; the extension says the format. May be given several times; `-` is JSON on standard
    /// output
    #[arg(short, long, value_name = "OUT", required = true, value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    #[command(flatten)]
    pub slicing: Slicing,
    #[command(flatten)]
    pub running: Running,
}

/// Where to cut and how to draw.
#[derive(Clone, Debug, Args)]
pub struct Slicing {
    /// Across the slices: x, y, z, a vector X,Y,Z, `auto` (the axis that most of the surface stands along, lies across or is
    /// turned about; of several the one along which sections change least often, then the longest), `long` (the longest
    /// principal axis) or `thin` (the principal axis for which slices project thinnest) [default: z]
    #[arg(long, value_parser = parse_axis, allow_hyphen_values = true)]
    pub axis: Option<Axis>,
    /// Distance between slices, in the unit of the input
    #[arg(long, value_name = "S", group = "planes")]
    pub every: Option<f64>,
    /// Number of slices, evenly through the whole scan [default: 10]
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
    /// Start with this many slices, split them where neighbours differ and merge them where they are alike
    #[arg(long, value_name = "N", group = "planes")]
    pub adaptive: Option<usize>,
    /// Thickness of a slab in the unit of the input, or `auto`: from the local spacing
    #[arg(long, value_name = "T", value_parser = parse_auto)]
    pub thickness: Option<Auto>,
    /// How curves are taken from the points of a slab
    #[arg(long, value_enum)]
    pub outline: Option<OutlineName>,
    /// With the outline `voronoi`: how far empty circles may lie from the curve, as a multiple of how far its points do
    /// (0.1 to 100); small for few vertices, large for many [default: 1]
    #[arg(long, value_name = "FACTOR")]
    pub circle_bound: Option<f64>,
    /// Which side of a thick band of points the curves follow
    #[arg(long, value_enum)]
    pub side: Option<SideName>,
    /// Project points straight onto the plane instead of carrying them along the surface
    #[arg(long)]
    pub no_carry: bool,
    /// Fit lines, arcs, circles and splines, and name what the stack of slices shows
    #[arg(long)]
    pub fit: bool,
    /// Greatest distance of a fitted curve from its contour, in the unit of the input; implies --fit
    #[arg(long, value_name = "LENGTH")]
    pub tolerance: Option<f64>,
}

/// A length, or the one that follows from the data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Auto {
    /// From the data.
    Auto,
    /// Given.
    Length(f64),
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
    /// Away from what a closed contour encloses
    Out,
    /// Towards it
    In,
}

impl Slicing {
    /// The parameters that these arguments change from their defaults.
    pub fn params(&self) -> SectionParams {
        let standard = SectionParams::default();
        let planes = match (self.every, self.count, &self.at, self.adaptive) {
            (Some(step), ..) => Planes::Every(step),
            (_, Some(count), ..) => Planes::Count(count),
            (_, _, Some(at), _) => Planes::At(at.clone()),
            (.., Some(start)) => Planes::Adaptive { start, most: start.saturating_mul(8) },
            _ => standard.planes.clone(),
        };
        SectionParams {
            axis: self.axis.unwrap_or(standard.axis),
            planes,
            thickness: match self.thickness {
                Some(Auto::Length(t)) => Some(t),
                _ => None,
            },
            carry: !self.no_carry,
            outline: match self.outline {
                Some(OutlineName::Middle) => Outline::Middle,
                Some(OutlineName::Hull) => Outline::Hull,
                Some(OutlineName::Voronoi) => Outline::Voronoi,
                None => standard.outline,
            },
            side: match self.side {
                Some(SideName::Mid) => Side::Middle,
                Some(SideName::Out) => Side::Outside,
                Some(SideName::In) => Side::Inside,
                None => standard.side,
            },
            circle_bound: self.circle_bound.unwrap_or(standard.circle_bound),
            fit: self.fit || self.tolerance.is_some(),
            tolerance: self.tolerance,
            ..standard
        }
    }
}

fn parse_axis(text: &str) -> Result<Axis, String> {
    match text {
        "x" => return Ok(Axis::Coordinate(0)),
        "y" => return Ok(Axis::Coordinate(1)),
        "z" => return Ok(Axis::Coordinate(2)),
        "auto" => return Ok(Axis::Faces),
        "long" => return Ok(Axis::Principal),
        "thin" => return Ok(Axis::Thinnest),
        _ => {}
    }
    let parts: Option<Vec<f64>> = text.split(',').map(|t| t.trim().parse().ok()).collect();
    match parts.as_deref() {
        Some(&[x, y, z]) => Ok(Axis::Vector([x, y, z])),
        _ => Err("write x, y, z, auto, long, thin or a vector X,Y,Z such as 1,0,1".into()),
    }
}

fn parse_auto(text: &str) -> Result<Auto, String> {
    match (text, text.parse()) {
        ("auto", _) => Ok(Auto::Auto),
        (_, Ok(length)) => Ok(Auto::Length(length)),
        _ => Err("write a length in the unit of the input, or auto".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_letters_words_or_vectors() {
        assert_eq!(parse_axis("y"), Ok(Axis::Coordinate(1)));
        assert_eq!(parse_axis("auto"), Ok(Axis::Faces));
        assert_eq!(parse_axis("long"), Ok(Axis::Principal));
        assert_eq!(parse_axis("0, -1,2.5"), Ok(Axis::Vector([0.0, -1.0, 2.5])));
        for bad in ["w", "1,2", "1,2,3,4", ""] {
            assert!(parse_axis(bad).is_err(), "{bad}");
        }
    }
}
