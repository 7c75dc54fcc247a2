//! The points beside an outline between two heights, with the planes of the surface there. A sample of the index's leaves
//! is enough, and only those among them that are not flat get planes of their own points.

use rayon::prelude::*;

use super::super::super::nest;
use super::super::super::result::Sections;
use super::super::super::surface;
use super::super::super::tile::Tiles;
use super::super::super::vec2::sub;
use super::super::profile::Profile;
use super::super::runs::Found;
use super::super::{Feature, Run};
use super::size::Size;
use super::{By, End};
use crate::frame::Localised;
use crate::math::vec3;
use crate::neighbors::Index;

/// How far beside an outline its end is looked for, in spacings.
pub(super) const BESIDE: f64 = 6.0;
/// How far behind its slice, in spacings, an end may lie.
const BEHIND: f64 = 0.7;
/// The same where its wall bends away slowly, as at the rim of a countersink cut from the side: a slice some way beyond it
/// still nearly shows the outline.
const SLOWLY: f64 = 4.0;
/// How far around an end points show it, in spacings.
const AROUND: f64 = 2.0;
/// Most leaves of the index that are looked at for one end: of upright walls, of others.
const LEAVES: [usize; 2] = [100, 300];
/// Sine of the angle to the axis below which a wall counts as upright: 8 degrees.
const UPRIGHT: f64 = 0.14;

/// An end of a run that is looked for between two heights, the first at the run's own slice.
pub(super) struct Search<'a> {
    pub outline: &'a Profile,
    pub inner: f64,
    pub outer: f64,
    /// How far behind `inner` it may lie.
    behind: f64,
    /// How far behind it points are looked at, and slow ends.
    slowly: f64,
    /// How far beyond `outer` points are looked at.
    around: f64,
    /// Whether the walls stand along the axis.
    pub upright: bool,
    /// For a taper an outline from its middle: what both have in common stands along the axis.
    other: Option<&'a Profile>,
}

impl Search<'_> {
    /// How far ahead of the run's slice a height lies.
    pub(super) fn ahead(&self, height: f64) -> f64 {
        (height - self.inner) * (self.outer - self.inner).signum()
    }

    /// Heights of the points looked at: what shows an end lies around it.
    fn range(&self) -> (f64, f64) {
        let far = self.outer + self.around * (self.outer - self.inner).signum();
        let start = self.inner - self.slowly * (self.outer - self.inner).signum();
        (start.min(far), start.max(far))
    }

    /// Points that show ends other than slow ones, of those that are looked at.
    pub(super) fn ahead_of_start<'s>(&self, spots: &'s [Spot]) -> &'s [Spot] {
        &spots[spots.partition_point(|s| self.ahead(s.height) < -self.behind)..]
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

/// How far beyond its outermost slice a turned wall that closes may go on: its radius there, as a wall that bends inwards does.
fn closing(run: &Run, profiles: &[&Profile], end: usize) -> f64 {
    let n = profiles.len();
    let (outer, inner) =
        if end == 0 { (profiles[0], profiles[n / 2]) } else { (profiles[n - 1], profiles[n / 2]) };
    let turned = matches!(run.feature, Feature::Revolution { .. });
    outer.round.filter(|_| turned && outer.area < inner.area).map_or(0.0, |r| r.radius)
}

/// A point beside an outline in the slice frame, world unit.
#[derive(Clone, Copy)]
pub(super) struct Spot {
    pub at: [f64; 2],
    pub height: f64,
    /// Distance from the outline; infinite for a point within it and far from it.
    pub off: f64,
    /// The outline's point nearest to it.
    pub foot: [f64; 2],
    /// A point of the surface's plane here, and its unit normal of either sign.
    pub centre: [f64; 3],
    pub normal: [f64; 3],
    /// Whether the plane holds here.
    pub fits: bool,
}

/// Cosine of the angle between a flat face's normal and the axis: 15 degrees.
const FLAT: f64 = 0.966;

impl Spot {
    /// Whether it lies on a face across the axis.
    pub(super) fn flat(&self) -> bool {
        self.fits && self.normal[2].abs() >= FLAT
    }
}

/// The cloud with what is known of its surface.
pub(super) struct Ground<'a> {
    local: &'a Localised,
    index: &'a Index,
    tiles: &'a Tiles,
    sections: &'a Sections,
    /// World height of local height 0.
    base: f64,
}

impl<'a> Ground<'a> {
    pub(super) fn new(
        local: &'a Localised,
        index: &'a Index,
        tiles: &'a Tiles,
        sections: &'a Sections,
    ) -> Self {
        let base = sections.frame.coordinates(local.frame.offset)[2];
        Self { local, index, tiles, sections, base }
    }

    /// The points that each search looks at, going away from its slice.
    pub(super) fn near(&self, searches: &[Search]) -> Vec<Vec<Spot>> {
        let leaves: Vec<Vec<u32>> = searches.par_iter().map(|s| self.leaves(s)).collect();
        let mut wanted: Vec<u32> = leaves.iter().flatten().copied().collect();
        wanted.sort_unstable();
        wanted.dedup();
        let surface =
            surface::fit(&self.local.positions, self.index, self.tiles, &wanted, self.sections.noise);
        let spots = |(search, leaves): (&Search, &Vec<u32>)| {
            let ids = leaves.iter().flat_map(|&l| self.index.leaves[l as usize].ids());
            let mut spots: Vec<(u32, Spot)> =
                ids.filter_map(|i| Some((i, self.spot(search, i, surface.at(i)?)?))).collect();
            spots.sort_by(|(i, a), (j, b)| {
                search.ahead(a.height).total_cmp(&search.ahead(b.height)).then(i.cmp(j))
            });
            spots.into_iter().map(|s| s.1).collect()
        };
        searches.par_iter().zip(&leaves).map(spots).collect()
    }

    /// Leaves with points at the heights of a search beside its outline, evenly.
    fn leaves(&self, search: &Search) -> Vec<u32> {
        let (low, high) = search.range();
        let scale = self.local.frame.scale;
        let local = ((low - self.base) / scale, (high - self.base) / scale);
        let h = self.sections.spacing;
        let near = |&l: &u32| {
            let tile = &self.tiles.tiles[l as usize];
            if tile.heights.1 < local.0 || tile.heights.0 > local.1 {
                return false;
            }
            let [x, y, _] = self.sections.frame.coordinates(self.local.frame.to_world(tile.patch.centre));
            // A tile reaches about three spacings from its middle.
            search.outline.outline.off_within([x, y], (BESIDE + 3.0) * h).is_some() || inside(search, [x, y])
        };
        let found = (0..self.tiles.tiles.len() as u32).filter(near);
        // An upright wall is most of what lies there, and tells least.
        let axis = self.sections.frame.axes[2];
        let wall = |l: &u32| vec3::dot(self.tiles.tiles[*l as usize].patch.normal, axis).abs() < UPRIGHT;
        let (walls, others): (Vec<u32>, Vec<u32>) = found.partition(wall);
        let some = |leaves: Vec<u32>, most: usize| {
            let step = leaves.len().div_ceil(most).max(1);
            leaves.into_iter().step_by(step)
        };
        some(walls, LEAVES[0]).chain(some(others, LEAVES[1])).collect()
    }

    fn spot(&self, search: &Search, i: u32, patch: &surface::Patch) -> Option<Spot> {
        let (frame, local) = (&self.sections.frame, &self.local.frame);
        let (h, noise) = (self.sections.spacing, self.sections.noise);
        let position = self.local.positions[i as usize];
        let [x, y, height] = frame.coordinates(local.to_world(position));
        let (low, high) = search.range();
        if !(low..=high).contains(&height) {
            return None;
        }
        let near = search.outline.outline.nearest_within([x, y], (BESIDE + 1.0) * h);
        let near = near.filter(|n| n.1 <= BESIDE * h);
        let (foot, off) = match near {
            Some(near) => near,
            None if inside(search, [x, y]) => ([x, y], f64::INFINITY),
            None => return None,
        };
        let away = vec3::dot(vec3::sub(position, patch.centre), patch.normal).abs();
        // A tile of a face may hold a few points of the wall.
        let fits = patch.residual <= (2.0 * noise + 0.15) * patch.spacing
            && away <= (1.5 * noise + 0.05) * patch.spacing;
        let centre = frame.coordinates(local.to_world(patch.centre));
        Some(Spot { at: [x, y], height, off, foot, centre, normal: frame.coordinates(patch.normal), fits })
    }
}

/// Whether a point lies within an outline: the whole of a face or a bore tells where it lies, and a slanted wall goes on
/// there.
fn inside(search: &Search, p: [f64; 2]) -> bool {
    nest::contains(search.outline.outline.points(), p)
}

/// The apex that a taper runs out to, if points show its wall up to there.
pub(super) fn apex(search: &Search, spots: &[Spot], size: &Size, h: f64) -> Option<End> {
    let apex = size.apex();
    let ahead = search.ahead(apex);
    let last = spots.iter().map(|s| search.ahead(s.height)).fold(f64::NEG_INFINITY, f64::max);
    // Rows of points come a spacing apart along the wall; the outline there is a few points wide.
    let reached = ahead >= 0.0 && search.ahead(search.outer) >= ahead - h && last >= ahead - 2.0 * h;
    reached.then_some(End { height: apex, error: 0.1 * h, by: By::Apex })
}

/// Horizontal part of the way from a spot's plane to the foot.
pub(super) fn to_foot(spot: &Spot) -> [f64; 2] {
    sub(spot.foot, [spot.centre[0], spot.centre[1]])
}
