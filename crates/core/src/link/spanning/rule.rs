//! How long is long: which cycles are lines and which branches are short.

use crate::params::{Auto, PenaltyForm, SpanningParams};
use crate::resolution::Resolution;

/// Length in spacings of the shortest loop that is told from noise when `rho` is left to the data.
const SHORTEST_LOOP: f64 = 10.0;

/// What the lengths of cycles and branches are measured in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Metric {
    /// Every edge counts one, as printed.
    Edges,
    /// Lengths along the line over this unit.
    Lengths(f64),
}

/// Which cycles of a spanning graph stay, and which branches go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CycleRule {
    /// Least length of a cycle; branches shorter than half of it are pruned (the paper's `rho`).
    pub(crate) rho: f64,
    /// What `rho` is measured in.
    pub(crate) metric: Metric,
    /// Whether cycles are tested, and lines repaired, as printed or in the robust form.
    pub(crate) form: PenaltyForm,
}

impl CycleRule {
    /// `rho` as given, in edges; else as printed half the root of the number of points (section 3.2), and in the robust form
    /// a length that small holes still have.
    pub(crate) fn new(
        params: &SpanningParams,
        form: PenaltyForm,
        points: usize,
        resolution: Resolution,
    ) -> CycleRule {
        let (rho, metric) = match (params.rho, form) {
            (Auto::Given(rho), _) => (rho as f64, Metric::Edges),
            (Auto::Auto, PenaltyForm::Paper) => (0.5 * (points as f64).sqrt(), Metric::Edges),
            (Auto::Auto, PenaltyForm::Robust) => (SHORTEST_LOOP, Metric::Lengths(resolution.unit())),
        };
        CycleRule { rho, metric, form }
    }

    /// Least depth of a branch that stays.
    pub(crate) fn long_branch(&self) -> f64 {
        0.5 * self.rho
    }
}
