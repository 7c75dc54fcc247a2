//! Sections of a cloud: the curves in which slicing planes meet the surface.
//!
//! After Kyriazis, Fudos and Palios, *Detecting features from sliced point clouds* (2007): slice, project, tell the
//! contours apart, draw an outline through feature points, describe it by curves. Two steps are ours: the points of
//! a slab are carried to the plane along the local surface before anything is drawn, so that a slanted wall gives a
//! thin band ([`SectionParams::carry`]); and contours are told apart and ordered by linking tangents, before any
//! outline, so that several, nested and open ones need no special case.

mod contour;
mod curves;
mod frame;
mod outline;
mod result;
mod slicing;
mod stack;
mod steps;
mod surface;

use crate::error::Error;
use crate::frame::{Frame, Localised};
use crate::neighbors::Index;
use crate::params::Clutter;
use crate::surface::clutter;

pub use crate::params::SectionParams;
pub use crate::params::section::{Axis, Outline, Planes, Side, Zero};
pub use frame::SliceFrame;
pub use result::{Contour, CurvePiece, CurveShape, Missing, Section, Sections};
pub use stack::{Feature, Mirror, Repeat, Run, Stack, stack};
pub use steps::{Circle, FeaturePoint, Projected, SliceSteps};

use slicing::slicer::Slicer;
use surface::tiles::Tiles;

/// Slices a cloud, or `(N, 3)` positions held elsewhere: one [`Section`] for each plane, in the order the planes were given or
/// run along the axis.
///
/// # Errors
/// [`Error::Parameter`] for a value outside its range; those of [`Frame::localise`].
pub fn section(cloud: &(impl AsRef<[[f64; 3]]> + ?Sized), params: &SectionParams) -> Result<Sections, Error> {
    params.check()?;
    let (local, clutter) = on_surfaces(cloud.as_ref(), params)?;
    let (sections, _) = sections(&local, &Index::build(&local.positions), params, &|_| ())?;
    Ok(Sections { clutter, ..sections })
}

/// [`section`] and, with [`SectionParams::fit`], the [`stack`] of the sections; else an empty stack. The share of
/// the slices that are cut, 0 to 1, is told to `observe` as it grows.
///
/// # Errors
/// Those of [`section`].
pub fn section_observed(
    cloud: &(impl AsRef<[[f64; 3]]> + ?Sized),
    params: &SectionParams,
    observe: &(dyn Fn(f64) + Sync),
) -> Result<(Sections, Stack), Error> {
    params.check()?;
    let (local, clutter) = on_surfaces(cloud.as_ref(), params)?;
    let index = Index::build(&local.positions);
    let (sections, tiles) = sections(&local, &index, params, observe)?;
    let stack =
        if params.fit { stack::of(&local, &index, &tiles, &sections, params) } else { Stack::default() };
    Ok((Sections { clutter, ..sections }, stack))
}

/// The steps to the sections of a cloud, one for each plane, in the order of [`Sections::sections`]: all is cut once more for them.
///
/// # Errors
/// Those of [`section()`].
pub fn steps(
    cloud: &(impl AsRef<[[f64; 3]]> + ?Sized),
    params: &SectionParams,
) -> Result<Vec<SliceSteps>, Error> {
    params.check()?;
    let (local, _) = on_surfaces(cloud.as_ref(), params)?;
    let index = Index::build(&local.positions);
    let slicer = Slicer::new(&local, &index, params, &|_| ());
    let heights: Vec<f64> = slicer.planned()?.iter().map(|cut| cut.0).collect();
    Ok(slicer.steps(&heights))
}

/// The points of a cloud that lie on surfaces, localised, and the number of those that do not.
fn on_surfaces(points: &[[f64; 3]], params: &SectionParams) -> Result<(Localised, usize), Error> {
    let mut local = Frame::of_points(points)?.with_spacing()?;
    let clutter = match params.clutter {
        Clutter::Keep => Vec::new(),
        Clutter::Auto | Clutter::LeaveOut => clutter(&local.positions),
    };
    let mut on_surface = clutter.iter().map(|c| !c);
    local.positions.retain(|_| on_surface.next().unwrap_or(true));
    let mut on_surface = clutter.iter().map(|c| !c);
    local.source.retain(|_| on_surface.next().unwrap_or(true));
    Ok((local, clutter.iter().filter(|&&c| c).count()))
}

fn sections(
    local: &Localised,
    index: &Index,
    params: &SectionParams,
    observe: &(dyn Fn(f64) + Sync),
) -> Result<(Sections, Tiles), Error> {
    let slicer = Slicer::new(local, index, params, observe);
    let cuts = slicer.planned()?;
    let heights: Vec<f64> = cuts.iter().map(|cut| cut.0).collect();
    let mut found = slicer.cut(&heights);
    found.iter_mut().zip(&cuts).for_each(|(section, cut)| section.slab = cut.1);
    Ok((slicer.finish(found, heights), slicer.into_tiles()))
}
