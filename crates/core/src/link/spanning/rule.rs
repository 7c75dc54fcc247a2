//! How long is long: which cycles are lines and which branches are short.

use crate::params::{Auto, PenaltyForm, SpanningParams};
use crate::surface::Scales;

/// What the lengths of cycles and branches are measured in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Metric<'a> {
    /// Every edge counts one, as printed.
    Edges,
    /// Lengths along the line in spacings, those at each place.
    Lengths(Scales<'a>),
}

/// Which cycles of a spanning graph stay, and which branches go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CycleRule<'a> {
    /// Least length of a cycle; branches shorter than half of it are pruned (the paper's `rho`).
    pub(crate) rho: f64,
    /// What `rho` is measured in.
    pub(crate) metric: Metric<'a>,
    /// Least ratio of the area that a cycle encloses to its length, spacings (robust form): keeps two strands of one band from
    /// passing for a loop.
    pub(crate) openness: f64,
    /// Whether cycles are tested, and lines repaired, as printed or in the robust form.
    pub(crate) form: PenaltyForm,
}

impl<'a> CycleRule<'a> {
    /// `rho` as given, in edges; else as printed half the root of the number of points (section 3.2), and in the robust form
    /// a length that small holes still have.
    pub(crate) fn new(
        params: &SpanningParams,
        form: PenaltyForm,
        points: usize,
        scales: Scales<'a>,
    ) -> CycleRule<'a> {
        let (rho, metric) = match (params.rho, form) {
            (Auto::Given(rho), _) => (rho as f64, Metric::Edges),
            (Auto::Auto, PenaltyForm::Paper) => (0.5 * (points as f64).sqrt(), Metric::Edges),
            (Auto::Auto, PenaltyForm::Robust) => (params.loop_spacings, Metric::Lengths(scales)),
        };
        CycleRule { rho, metric, openness: params.openness_spacings, form }
    }

    /// Least depth of a branch that stays.
    pub(crate) fn long_branch(&self) -> f64 {
        0.5 * self.rho
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rho_is_the_documented_default_of_either_form() {
        let params = SpanningParams::default();
        let scales = Scales::from(crate::Resolution { spacing: 2.0, noise: 0.0 });
        let printed = CycleRule::new(&params, PenaltyForm::Paper, 40_000, scales);
        assert_eq!((printed.rho, printed.metric), (100.0, Metric::Edges));
        let robust = CycleRule::new(&params, PenaltyForm::Robust, 40_000, scales);
        assert_eq!((robust.rho, robust.metric), (params.loop_spacings, Metric::Lengths(scales)));
        let given = SpanningParams { rho: Auto::Given(30), ..params };
        let rule = CycleRule::new(&given, PenaltyForm::Robust, 40_000, scales);
        assert_eq!((rule.rho, rule.metric), (30.0, Metric::Edges));
    }
}
