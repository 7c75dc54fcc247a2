//! A detector by itself: from a cloud to a score and a mark for each of its points, without lines.

use super::baselines::{Detector, marks};
use super::projection::marks::Marks;
use super::projection::warning;
use crate::error::Error;
use crate::measure::Class;
use crate::params::Params;
use crate::prepare::prepare;
use crate::report::{Clock, Progress, Report, Stage};

/// The points of a cloud, scored and marked by detectors.
#[derive(Clone, Debug)]
pub struct Marked {
    /// Counts and estimates; the stages are not timed.
    pub report: Report,
    /// `(N)` canonical index of each input point; `u32::MAX` if it was dropped or is clutter.
    pub canonical: Vec<u32>,
    /// The points of the input that are clutter, ascending.
    pub clutter: Vec<u32>,
    /// Scores and marks of each detector, in the order asked for; the points in canonical order.
    pub marks: Vec<(Detector, Marks)>,
}

/// Scores the points of a cloud, or `(N, 3)` positions held elsewhere, by each of `detectors`.
///
/// # Errors
/// As [`extract`](crate::extract()).
pub fn mark(
    world: &(impl AsRef<[[f64; 3]]> + ?Sized),
    params: &Params,
    detectors: &[Detector],
) -> Result<Marked, Error> {
    mark_observed(world, params, detectors, &|_| ())
}

/// As [`mark`], telling `observe` of progress.
///
/// # Errors
/// As [`mark`].
pub fn mark_observed(
    world: &(impl AsRef<[[f64; 3]]> + ?Sized),
    params: &Params,
    detectors: &[Detector],
    observe: &(dyn Fn(Progress) + Sync),
) -> Result<Marked, Error> {
    params.check()?;
    let mut clock = Clock::new(observe);
    let cloud = prepare(world.as_ref(), params, &mut clock)?;
    let scored = |&d: &Detector| (d, marks(&cloud.positions, cloud.resolution, &params.projection, d));
    let marks: Vec<(Detector, Marks)> = clock.run(Stage::Detect, || detectors.iter().map(scored).collect());
    let warned = detectors.contains(&Detector::Projection).then(|| warning(cloud.resolution)).flatten();
    let mut report = cloud.report();
    report.settings = marks.iter().map(|(d, m)| setting(*d, m)).collect();
    report.notes.extend(warned);
    Ok(Marked { report, canonical: cloud.canonical, clutter: cloud.clutter, marks })
}

fn setting(detector: Detector, marks: &Marks) -> (String, String) {
    let Marks { threshold, separability, .. } = marks;
    (
        detector.name(),
        format!("threshold {threshold:.3} of the greatest score, separability {separability:.2}"),
    )
}

impl Marked {
    /// `(N)` classes by the `which`-th detector asked for, in the order of the input. Dropped points are smooth, and all points
    /// are if there is no such detector.
    pub fn classes(&self, which: usize) -> Vec<Class> {
        let classes = self.marks.get(which).map(|(_, marks)| marks.classes()).unwrap_or_default();
        let of_point = |&c: &u32| classes.get(c as usize).copied().unwrap_or_default();
        let mut classes: Vec<Class> = self.canonical.iter().map(of_point).collect();
        self.clutter.iter().for_each(|&i| classes[i as usize] = Class::Clutter);
        classes
    }

    /// `(N)` scores by the `which`-th detector asked for, 0 to 1, in the order of the input; NaN for dropped points, zero for
    /// clutter.
    pub fn scores(&self, which: usize) -> Vec<f32> {
        let scores = self.marks.get(which).map(|(_, marks)| marks.score.as_slice()).unwrap_or_default();
        let of_point = |&c: &u32| scores.get(c as usize).copied().unwrap_or(f32::NAN);
        let mut scores: Vec<f32> = self.canonical.iter().map(of_point).collect();
        self.clutter.iter().for_each(|&i| scores[i as usize] = 0.0);
        scores
    }
}
