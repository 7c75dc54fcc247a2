//! Features of a stack of slices: runs of like contours, mirrors and repeats.

/// The features of a stack of slices.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stack {
    /// Runs of like contours, by height, then by contour.
    pub runs: Vec<Run>,
    /// Planes along the axis in which the stack mirrors itself.
    pub mirrors: Vec<Mirror>,
    /// Runs that show the same outline at different places.
    pub repeats: Vec<Repeat>,
}

/// A run of like contours through neighbouring slices.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Run {
    /// The kind of the run, with its measures.
    pub feature: Feature,
    /// Whether the contours are holes.
    pub hole: bool,
    /// Where it begins along the axis, world unit.
    pub from: f64,
    /// Where it ends along the axis, world unit.
    pub to: f64,
    /// Errors of `from` and `to`, world unit.
    pub range_error: [f64; 2],
    /// Mean distance of the contours from the feature, world unit.
    pub residual: f64,
    /// Centroid of the middle contour, world frame; the centre of a round one.
    pub centre: [f64; 3],
    /// The contours as (plane, index in its section), ascending by height.
    pub contours: Vec<(usize, usize)>,
}

/// The kinds of runs.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Feature {
    /// The same outline throughout.
    Extrusion {
        /// World unit, if the outline is a circle.
        radius: Option<f64>,
    },
    /// An outline that moves evenly with height.
    Taper {
        /// Mean angle between the walls and the axis, degrees; positive where the outline grows along the axis.
        angle_deg: f64,
        /// Height at which the outline would shrink to nothing, world unit; infinite where it does nowhere.
        apex: f64,
        /// Radius at `from`, world unit, if the outline is a circle.
        radius: Option<f64>,
    },
    /// Circles about one axis along the slices' axis.
    Revolution {
        /// Least radius met, world unit.
        least: f64,
        /// Greatest radius met, world unit.
        most: f64,
    },
}

/// A mirror plane that holds the slices' axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Mirror {
    /// A point of the plane, world frame.
    pub point: [f64; 3],
    /// Its unit normal.
    pub normal: [f64; 3],
    /// Slices that mirror themselves in it.
    pub planes: usize,
    /// Mean distance between contours and mirrored contours, world unit.
    pub residual: f64,
}

/// Runs of one outline at several places.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Repeat {
    /// Indices of the runs.
    pub runs: Vec<usize>,
    /// Mean distance of their outlines, one laid over the other, world unit.
    pub residual: f64,
}

impl Feature {
    /// The name in files: `extrusion`, `taper` or `revolution`.
    pub fn name(&self) -> &'static str {
        match self {
            Feature::Extrusion { .. } => "extrusion",
            Feature::Taper { .. } => "taper",
            Feature::Revolution { .. } => "revolution",
        }
    }
}
