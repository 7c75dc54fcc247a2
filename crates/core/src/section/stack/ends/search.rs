//! The search ranges for the ends of a run.

use super::size::Size;
use crate::curve::polygon::contains;
use crate::section::result::Sections;
use crate::section::stack::profile::Profile;
use crate::section::stack::result::{Feature, Run};
use crate::section::stack::runs::Found;

/// Greatest distance of an end behind its slice, spacings.
const BEHIND: f64 = 0.7;
/// The same where its wall bends away slowly, as at the rim of a countersink cut from the side: a slice some way beyond it
/// still nearly shows the outline.
const SLOWLY: f64 = 4.0;
/// Distance from an end up to which points show it, spacings.
const AROUND: f64 = 2.0;

/// The search for an end of a run between two heights, the first at the run's own slice.
pub(super) struct Search<'a> {
    pub outline: &'a Profile,
    pub inner: f64,
    pub outer: f64,
    /// Greatest distance of the end behind `inner`.
    pub behind: f64,
    /// Distance behind `inner` up to which points and slow ends are considered.
    slowly: f64,
    /// Distance beyond `outer` up to which points are considered.
    around: f64,
    /// Whether the walls stand along the axis.
    pub upright: bool,
    /// For a taper an outline from its middle: the parts that both share stand along the axis.
    other: Option<&'a Profile>,
}

impl Search<'_> {
    /// The distance of a height ahead of the run's slice.
    pub(super) fn ahead(&self, height: f64) -> f64 {
        (height - self.inner) * (self.outer - self.inner).signum()
    }

    /// The range of heights of the points considered, as points around an end show it.
    pub(super) fn range(&self) -> (f64, f64) {
        let far = self.outer + self.around * (self.outer - self.inner).signum();
        let start = self.inner - self.slowly * (self.outer - self.inner).signum();
        (start.min(far), start.max(far))
    }

    /// Whether a slow end may lie so far ahead.
    pub(super) fn holds_slow(&self, ahead: f64) -> bool {
        (-self.slowly..=self.ahead(self.outer)).contains(&ahead)
    }

    /// Whether any wall stands along the axis.
    pub(super) fn partly_upright(&self) -> bool {
        self.upright || self.other.is_some()
    }

    /// Whether the wall at a place of the outline stands along the axis, to within `slack`.
    pub(super) fn stands_at(&self, foot: [f64; 2], slack: f64) -> bool {
        self.upright || self.other.is_some_and(|o| o.outline.off_within(foot, slack).is_some())
    }

    /// Whether an end may lie at a height.
    pub(super) fn holds(&self, height: f64) -> bool {
        (self.start().min(self.outer)..=self.start().max(self.outer)).contains(&height)
    }

    /// The height that the search starts at.
    pub(super) fn start(&self) -> f64 {
        self.inner - self.behind * (self.outer - self.inner).signum()
    }
}

/// The searches for both ends of a run.
pub(super) fn searches<'a>(
    found @ Found { run, profiles, .. }: &Found<'a>,
    size: &Size,
    sections: &Sections,
) -> [Search<'a>; 2] {
    // A slice within a spacing of a face may not show the outline whole: the face then lies past that slice, and noise
    // spreads its points.
    let past = (1.0 + 4.0 * sections.noise) * sections.spacing;
    let [low, high] = [profiles[0], profiles[profiles.len() - 1]];
    let (first, last) = (low.height, high.height);
    // Beyond the outermost slice the cloud may go on for any length: its end bounds the search.
    let below =
        if run.range_error[0].is_finite() { 2.0 * run.from - first - past } else { f64::NEG_INFINITY };
    let above = if run.range_error[1].is_finite() { 2.0 * run.to - last + past } else { f64::INFINITY };
    let [below, above] = size.to_apex([below, above], [first, last], sections.spacing);
    let (below, above) =
        (below.min(first - closing(run, profiles, 0)), above.max(last + closing(run, profiles, 1)));
    let [behind, slowly] = [BEHIND, SLOWLY].map(|far| (far * sections.spacing).min(0.5 * (last - first)));
    let upright = matches!(run.feature, Feature::Extrusion { .. });
    let around = AROUND * sections.spacing;
    // Beside a fold a slice shows a mean of both walls; an extrusion has the same outline in its middle.
    let [low, high] = if upright { [found.middle(); 2] } else { [low, high] };
    let other = matches!(run.feature, Feature::Taper { .. }).then(|| found.middle());
    let search =
        |outline, inner, outer| Search { outline, inner, outer, behind, slowly, around, upright, other };
    [search(low, first, below), search(high, last, above)]
}

/// Greatest distance by which a closing wall of revolution continues beyond its outermost slice: its radius there, as for a wall
/// that bends inwards.
fn closing(run: &Run, profiles: &[&Profile], end: usize) -> f64 {
    let n = profiles.len();
    let (outer, inner) =
        if end == 0 { (profiles[0], profiles[n / 2]) } else { (profiles[n - 1], profiles[n / 2]) };
    let turned = matches!(run.feature, Feature::Revolution { .. });
    outer.round.filter(|_| turned && outer.area < inner.area).map_or(0.0, |r| r.radius)
}

/// Whether a point lies within an outline, where a whole face or bore shows its height and where a slanted wall continues.
pub(crate) fn inside(search: &Search, p: [f64; 2]) -> bool {
    contains(search.outline.outline.points(), p)
}
