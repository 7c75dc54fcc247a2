//! A detector by itself: from a cloud to a score and a mark for each of its points, without lines.

use super::baselines::{Detector, marks};
use super::marks::Marks;
use super::projection::warning;
use crate::extract::refuse_degenerate;
use crate::frame::{Frame, Localised};
use crate::measure::Class;
use crate::neighbors::{all_nearest, riemannian::graph};
use crate::resolution::Resolution;
use crate::{Cloud, Error, Params, Report};

/// What detectors say of the points of a cloud.
#[derive(Clone, Debug)]
pub struct Marked {
    /// Counts and estimates; the stages are not timed.
    pub report: Report,
    /// `(N)` for each point of the input its canonical index; `u32::MAX` if it was dropped.
    pub canonical: Vec<u32>,
    /// For each detector asked for, in that order, its scores and marks; canonical order.
    pub marks: Vec<(Detector, Marks)>,
}

/// Scores the points of a cloud by each of `detectors`.
///
/// # Errors
/// As [`extract`](crate::extract()).
pub fn mark(world: &Cloud, params: &Params, detectors: &[Detector]) -> Result<Marked, Error> {
    params.check()?;
    let local = Frame::localise(world)?;
    let (canonical, merged) = (local.canonical(), local.merged());
    let Localised { frame, positions, dropped, .. } = local;
    refuse_degenerate(world.len(), &positions)?;
    let nearest = all_nearest(&positions, params.neighbors.k);
    let estimate = Resolution::estimate(&positions, &nearest, &graph(&positions, &nearest));
    let noise = params.penalty.noise_spacings.or(|| estimate.noise / estimate.spacing) * estimate.spacing;
    let resolution = Resolution { noise, ..estimate };
    let found = detectors.iter().map(|&d| (d, marks(&positions, resolution, &params.projection, d)));
    let marks: Vec<(Detector, Marks)> = found.collect();
    let report = Report {
        read: world.len(),
        dropped,
        merged,
        points: positions.len(),
        spacing: frame.length_to_world(resolution.spacing),
        noise: frame.length_to_world(resolution.noise),
        settings: marks.iter().map(|(d, m)| setting(*d, m)).collect(),
        notes: if detectors.contains(&Detector::Projection) {
            Vec::from_iter(warning(resolution))
        } else {
            Vec::new()
        },
        ..Report::default()
    };
    Ok(Marked { report, canonical, marks })
}

fn setting(detector: Detector, marks: &Marks) -> (String, String) {
    let Marks { threshold, separability, .. } = marks;
    (
        detector.name(),
        format!("threshold {threshold:.3} of the greatest score, separability {separability:.2}"),
    )
}

impl Marked {
    /// `(N)` what the `which`-th detector asked for makes of each point, in the order of the input; dropped points are
    /// smooth, and all are if there is no such detector.
    pub fn classes(&self, which: usize) -> Vec<Class> {
        let classes = self.marks.get(which).map(|(_, marks)| marks.classes()).unwrap_or_default();
        self.canonical.iter().map(|&c| classes.get(c as usize).copied().unwrap_or_default()).collect()
    }

    /// `(N)` the scores of the `which`-th detector asked for, 0 to 1, in the order of the input; NaN for dropped points.
    pub fn scores(&self, which: usize) -> Vec<f32> {
        let scores = self.marks.get(which).map(|(_, marks)| marks.score.as_slice()).unwrap_or_default();
        self.canonical.iter().map(|&c| scores.get(c as usize).copied().unwrap_or(f32::NAN)).collect()
    }
}
