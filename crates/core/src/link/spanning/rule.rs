//! The length `rho`: which cycles are long enough to stay and which branches are short (Gumhold 2001, section 3.2).

use crate::math::vec3::distance;
use crate::network::StripKind;
use crate::params::{Auto, PenaltyForm, SpanningParams};
use crate::pattern::LineGraph;
use crate::resolution::Resolution;
use crate::surface::Scales;

/// Least depth of a branch without noise and with it, spacings; and the noise from which on it is the latter, spacings.
const BRANCH: (f64, f64) = (2.5, 5.0);
const NOISY: f64 = 0.1;

/// The measure of length of cycles and branches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Metric<'a> {
    /// The number of edges, as printed.
    Edges,
    /// The length along the line, in the spacings at each place.
    Lengths(Scales<'a>),
}

impl Metric<'_> {
    /// The length of an edge.
    pub(crate) fn length(&self, lines: &LineGraph, a: u32, b: u32) -> f64 {
        match self {
            Metric::Edges => 1.0,
            Metric::Lengths(scales) => {
                let [a, b] = [a as usize, b as usize];
                let unit = scales.between(lines.points[a], lines.points[b]);
                distance(lines.positions[a], lines.positions[b]) / unit
            }
        }
    }
}

/// The rule by which cycles of a spanning graph stay and branches go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CycleRule<'a> {
    /// Least length of a cycle (the paper's `rho`).
    pub(crate) rho: f64,
    /// Least depth of a branch: half of `rho` as printed.
    pub(crate) branch: f64,
    /// The measure of `rho` and `branch`.
    pub(crate) metric: Metric<'a>,
    /// Least ratio of the area that a cycle encloses to its length, spacings (robust form): keeps two strands of one band from
    /// forming a loop.
    pub(crate) openness: f64,
    /// The form of the cycle test and of the steps that follow.
    pub(crate) form: PenaltyForm,
}

impl<'a> CycleRule<'a> {
    /// `rho` as given, in edges; by default half the root of the number of points as printed (section 3.2), and in the robust
    /// form a length that the loops around small holes exceed.
    pub(crate) fn new(
        params: &SpanningParams,
        form: PenaltyForm,
        points: usize,
        scales: Scales<'a>,
    ) -> CycleRule<'a> {
        let edges = |rho: f64| (rho, 0.5 * rho, Metric::Edges);
        let (rho, branch, metric) = match (params.rho, form) {
            (Auto::Given(rho), _) => edges(rho as f64),
            (Auto::Auto, PenaltyForm::Paper) => edges(0.5 * (points as f64).sqrt()),
            (Auto::Auto, PenaltyForm::Robust) => {
                let branch = params.branch_spacings.or(|| branch(scales.mean));
                (params.loop_spacings, branch, Metric::Lengths(scales))
            }
        };
        CycleRule { rho, branch, metric, openness: params.openness_spacings, form }
    }

    /// The rule for lines of one kind: short branches of borders are never kept, as the last row of points has teeth where the
    /// density changes.
    pub(crate) fn of(self, kind: StripKind) -> Self {
        match kind {
            StripKind::Crease | StripKind::Rounded => self,
            StripKind::Border => CycleRule { branch: self.branch.max(0.5 * self.rho), ..self },
        }
    }
}

/// Least depth of a branch of creases, spacings.
fn branch(mean: Resolution) -> f64 {
    let noisy = (mean.noise / (NOISY * mean.spacing)).min(1.0);
    BRANCH.0 + noisy * (BRANCH.1 - BRANCH.0)
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
        assert_eq!([StripKind::Crease, StripKind::Border].map(|kind| robust.of(kind).branch), [2.5, 5.0]);
        for (noise, least) in [(0.1, 3.75), (0.2, 5.0), (2.0, 5.0)] {
            let scales = Scales::from(crate::Resolution { spacing: 2.0, noise });
            let rule = CycleRule::new(&params, PenaltyForm::Robust, 40_000, scales);
            assert_eq!(rule.branch, least, "noise {noise}");
        }
        let given = SpanningParams { rho: Auto::Given(30), ..params };
        let rule = CycleRule::new(&given, PenaltyForm::Robust, 40_000, scales);
        assert_eq!((rule.rho, rule.metric), (30.0, Metric::Edges));
    }
}
