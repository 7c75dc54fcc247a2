//! Progress and report of the pipeline: stages as they begin and end, counts and times at the end.

use crate::surface::Findings;
use std::time::Instant;

/// Counts, estimates and times, for a summary.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Points given.
    pub read: usize,
    /// Points left out because a coordinate was not finite.
    pub dropped: usize,
    /// Points merged into an exact duplicate.
    pub merged: usize,
    /// Points kept.
    pub points: usize,
    /// Points left out because they lie on no surface, or because they are in excess.
    pub surface: Findings,
    /// Mean distance to the six nearest neighbours, corrected for noise; unit of the input.
    pub spacing: f64,
    /// Standard deviation of the noise along the surface normal; unit of the input.
    pub noise: f64,
    /// Seconds that each stage took.
    pub stages: Vec<(Stage, f64)>,
    /// The values of parameters derived from the data.
    pub settings: Vec<(String, String)>,
    /// Every parameter that the method reads, by key with the value it had, in the form that `Params::set` reads.
    pub used: Vec<(String, String)>,
    /// Notes for the user on the result.
    pub notes: Vec<String>,
}

/// A stage of the pipeline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Canonical order and local frame.
    Localise,
    /// Nearest neighbours and the neighbour graph.
    Neighbors,
    /// Points on surfaces told from clutter.
    Surface,
    /// Penalties and scores of the points.
    Detect,
    /// Patterns.
    Link,
    /// Strips, nodes and curves.
    Recover,
    /// Patches and their loops.
    Patches,
    /// Relations between curves, and their imposition.
    Relations,
}

impl Stage {
    /// The name in progress lines and summaries.
    pub fn name(self) -> &'static str {
        match self {
            Stage::Localise => "localise",
            Stage::Neighbors => "neighbors",
            Stage::Surface => "surface",
            Stage::Detect => "detect",
            Stage::Link => "link",
            Stage::Recover => "recover",
            Stage::Patches => "patches",
            Stage::Relations => "relations",
        }
    }
}

/// A stage that begins (`done` = 0) or ends (`done` = 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Which stage.
    pub stage: Stage,
    /// Share done, 0 to 1.
    pub done: f64,
}

/// Reports when stages begin and end, and times them.
pub(crate) struct Clock<'a> {
    observe: &'a (dyn Fn(Progress) + Sync),
    /// Seconds that each stage took.
    pub(crate) stages: Vec<(Stage, f64)>,
}

impl<'a> Clock<'a> {
    pub(crate) fn new(observe: &'a (dyn Fn(Progress) + Sync)) -> Self {
        Self { observe, stages: Vec::new() }
    }

    /// Runs the work of a stage.
    pub(crate) fn run<T>(&mut self, stage: Stage, work: impl FnOnce() -> T) -> T {
        (self.observe)(Progress { stage, done: 0.0 });
        let start = Instant::now();
        let result = work();
        self.stages.push((stage, start.elapsed().as_secs_f64()));
        (self.observe)(Progress { stage, done: 1.0 });
        result
    }
}
