//! Features that adjacent slices show together (Kyriazis et al., sections 1 and 2), such as holes, extrusions, symmetrical
//! and repeated parts: runs of like contours.
//!
//! Contours of neighbouring slices are matched into tracks; a track is cut into runs over which the outline stays
//! (extrusion), changes evenly (taper), or stays round about one axis (revolution). The end of a run is found from the
//! flat faces and the last points of its wall between the slices, not from the slices alone.

mod ends;
mod kinds;
mod mirror;
mod pairs;
mod profile;
mod repeats;
mod result;
mod runs;
mod shown;
mod slice;
mod track;

use crate::cloud::Cloud;
use crate::error::Error;
use crate::frame::{Frame, Localised};
use crate::neighbors::Index;
use crate::parallel;
use crate::params::SectionParams;
use crate::section::result::Sections;
use crate::section::surface::tiles::Tiles;
use runs::Found;

pub use result::{Feature, Mirror, Repeat, Run, Stack};

/// Greatest mean distance between contours of the same outline, world unit: as given, or derived from the noise.
fn tolerance(sections: &Sections, params: &SectionParams) -> f64 {
    params.same_spacings.or(|| 0.12 + 0.5 * sections.noise) * sections.spacing
}

/// Names the runs of a stack of sections of `cloud`. Where both are wanted,
/// [`section_observed`](crate::section::section_observed) sorts the cloud once for both.
///
/// # Errors
/// Those of [`Frame::localise`].
pub fn stack(cloud: &Cloud, sections: &Sections, params: &SectionParams) -> Result<Stack, Error> {
    let local = Frame::localise(cloud)?.with_spacing()?;
    let index = Index::build(&local.positions);
    let tiles = Tiles::new(&index, sections.noise, sections.frame.axes[2]);
    Ok(of(&local, &index, &tiles, sections, params))
}

/// [`stack`] of a cloud that is localised, indexed and tiled.
pub(crate) fn of(
    local: &Localised,
    index: &Index,
    tiles: &Tiles,
    sections: &Sections,
    params: &SectionParams,
) -> Stack {
    let tolerance = tolerance(sections, params);
    let order = profile::order(sections);
    let levels = profile::levels(sections, &order, tolerance);
    let heights: Vec<f64> = order.iter().map(|&plane| sections.heights[plane]).collect();
    let shown = shown::Shown::new(sections);
    let holds = |k: usize, profile: &profile::Profile| shown.holds(order[k], profile);
    let tracks = track::tracks(&levels, &heights, tolerance, params.missed, holds);
    // The runs of a track stay together until their ends are known.
    let mut found: Vec<Found> = parallel::flat_map(tracks.len(), parallel::TASK, |t, out| {
        out.extend(runs::runs(&tracks[t], sections, tolerance))
    });
    ends::refine(local, index, tiles, sections, tolerance, &mut found);
    found.sort_by(|a, b| a.run.from.total_cmp(&b.run.from).then_with(|| a.run.contours.cmp(&b.run.contours)));
    let repeats = repeats::repeats(&found, tolerance);
    Stack {
        runs: found.into_iter().map(|f| f.run).collect(),
        mirrors: mirror::mirrors(&levels, sections, tolerance),
        repeats,
    }
}
