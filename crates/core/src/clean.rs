//! Points on surfaces told from clutter, without lines: the first stages of the pipeline by themselves.

use crate::error::Error;
use crate::params::{Clutter, Params};
use crate::prepare::prepare;
use crate::report::{Clock, Progress, Report};

/// The points of a cloud on surfaces, and the others.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cleaned {
    /// Counts, estimates and times.
    pub report: Report,
    /// Points of the input on surfaces, ascending: all finite points but clutter, duplicates among them.
    pub surface: Vec<u32>,
    /// Points of the input on no surface, ascending.
    pub clutter: Vec<u32>,
}

/// Tells the points of a cloud, or of `(N, 3)` positions held elsewhere, that lie on surfaces from clutter, whatever
/// `surface.clutter` says.
///
/// # Errors
/// As [`extract`](crate::extract()).
pub fn clean(world: &(impl AsRef<[[f64; 3]]> + ?Sized), params: &Params) -> Result<Cleaned, Error> {
    clean_observed(world, params, &|_| ())
}

/// As [`clean`], telling `observe` of progress.
///
/// # Errors
/// As [`clean`].
pub fn clean_observed(
    world: &(impl AsRef<[[f64; 3]]> + ?Sized),
    params: &Params,
    observe: &(dyn Fn(Progress) + Sync),
) -> Result<Cleaned, Error> {
    params.check()?;
    let mut params = params.clone();
    params.surface.clutter = Clutter::LeaveOut;
    let mut clock = Clock::new(observe);
    let cloud = prepare(world.as_ref(), &params, &mut clock)?;
    let on_surface = cloud.canonical.iter().zip(0..).filter(|(place, _)| **place != u32::MAX);
    let surface = on_surface.map(|(_, i)| i).collect();
    let report = Report { stages: clock.stages, ..cloud.report() };
    Ok(Cleaned { report, surface, clutter: cloud.clutter })
}
