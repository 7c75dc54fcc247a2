//! What the stack of slices says of the object (Kyriazis et al., sections 1 and 2): runs of like contours.
//!
//! Contours of neighbouring slices are matched into tracks; a track is cut into runs over which the outline stays
//! (extrusion), changes evenly (taper), or stays round about one axis (revolution). Where a run ends is read from the
//! flat faces and the last points of its wall between the slices, not from the slices alone.

mod ends;
mod kinds;
mod mirror;
mod pairs;
mod profile;
mod repeats;
mod runs;
mod shown;
mod track;

use super::result::Sections;
use super::tile::Tiles;
use crate::cloud::Cloud;
use crate::error::Error;
use crate::frame::{Frame, Localised};
use crate::neighbors::Index;
use rayon::prelude::*;
use runs::Found;

/// What a stack of slices says.
#[derive(Clone, Debug, Default, PartialEq)]
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
pub struct Run {
    /// What the contours have in common.
    pub feature: Feature,
    /// Whether the contours are holes.
    pub hole: bool,
    /// Where it begins along the axis, world unit.
    pub from: f64,
    /// Where it ends along the axis, world unit.
    pub to: f64,
    /// How far `from` and `to` may be off, world unit.
    pub range_error: [f64; 2],
    /// Mean distance of the contours from what they have in common, world unit.
    pub residual: f64,
    /// Centroid of the middle contour, world frame; the centre of a round one.
    pub centre: [f64; 3],
    /// The contours as (plane, index in its section), ascending by height.
    pub contours: Vec<(usize, usize)>,
}

/// What a run of contours is.
#[derive(Clone, Copy, Debug, PartialEq)]
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

/// How far contours of one outline may lie apart on average, in spacings: what the noise leaves of a contour.
fn tolerance(sections: &Sections) -> f64 {
    (0.12 + 0.5 * sections.noise) * sections.spacing
}

/// Names the runs of a stack of sections of `cloud`. Where both are wanted,
/// [`section_observed`](crate::section::section_observed) sorts the cloud once for both.
///
/// # Errors
/// What [`Frame::localise`] refuses.
pub fn stack(cloud: &Cloud, sections: &Sections) -> Result<Stack, Error> {
    let local = Frame::localise(cloud)?;
    let index = Index::build(&local.positions);
    let tiles = Tiles::new(&index, sections.noise, sections.frame.axes[2]);
    Ok(of(&local, &index, &tiles, sections))
}

/// [`stack`] of a cloud that is localised, indexed and tiled.
pub(crate) fn of(local: &Localised, index: &Index, tiles: &Tiles, sections: &Sections) -> Stack {
    let tolerance = tolerance(sections);
    let order = profile::order(sections);
    let levels = profile::levels(sections, &order, tolerance);
    let heights: Vec<f64> = order.iter().map(|&plane| sections.heights[plane]).collect();
    let shown = shown::Shown::new(sections);
    let tracks = track::tracks(&levels, &heights, tolerance, |k, profile| shown.holds(order[k], profile));
    // The runs of a track stay together until their ends are known.
    let mut found: Vec<Found> =
        tracks.par_iter().flat_map_iter(|t| runs::runs(t, sections, tolerance)).collect();
    ends::refine(local, index, tiles, sections, tolerance, &mut found);
    found.sort_by(|a, b| a.run.from.total_cmp(&b.run.from).then_with(|| a.run.contours.cmp(&b.run.contours)));
    let repeats = repeats::repeats(&found, tolerance);
    Stack {
        runs: found.into_iter().map(|f| f.run).collect(),
        mirrors: mirror::mirrors(&levels, sections, tolerance),
        repeats,
    }
}
