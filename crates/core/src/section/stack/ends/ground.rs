//! The points beside an outline between two heights, with the planes of the surface there. A sample of the index's leaves
//! is enough, and only those among them that are not flat get planes of their own points.

use super::search::{Search, inside};
use crate::frame::Localised;
use crate::math::vec3;
use crate::neighbors::Index;
use crate::parallel;
use crate::section::result::Sections;
use crate::section::surface::plane::TangentPlane;
use crate::section::surface::tangents::tangent_planes;
use crate::section::surface::tiles::Tiles;

/// Distance beside an outline up to which its end is searched, spacings.
pub(super) const OUTLINE_REACH: f64 = 6.0;
/// Greatest number of leaves of the index that are searched for one end: of upright walls, of others.
const LEAVES: [usize; 2] = [100, 300];
/// Sine of the angle to the axis below which a wall counts as upright: 8 degrees.
const UPRIGHT: f64 = 0.14;
/// Cosine of the angle between a flat face's normal and the axis: 15 degrees.
const FLAT: f64 = 0.966;

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

impl Spot {
    /// Whether it lies on a face across the axis.
    pub(super) fn flat(&self) -> bool {
        self.fits && self.normal[2].abs() >= FLAT
    }
}

/// The cloud with its tiles and sections.
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
        let leaves = parallel::map(searches.len(), parallel::TASK, |s| self.leaves(&searches[s]));
        let mut wanted: Vec<u32> = leaves.iter().flatten().copied().collect();
        wanted.sort_unstable();
        wanted.dedup();
        let planes =
            tangent_planes(&self.local.positions, self.index, self.tiles, &wanted, self.sections.noise);
        parallel::map(searches.len(), parallel::TASK, |s| {
            let search = &searches[s];
            let ids = leaves[s].iter().flat_map(|&l| self.index.leaves[l as usize].ids());
            let mut spots: Vec<(u32, Spot)> =
                ids.filter_map(|i| Some((i, self.spot(search, i, planes.at(i)?)?))).collect();
            spots.sort_by(|(i, a), (j, b)| {
                search.ahead(a.height).total_cmp(&search.ahead(b.height)).then(i.cmp(j))
            });
            spots.into_iter().map(|s| s.1).collect()
        })
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
            let [x, y, _] = self.sections.frame.coordinates(self.local.frame.to_world(tile.plane.centre));
            // A tile reaches about three spacings from its middle.
            search.outline.outline.off_within([x, y], (OUTLINE_REACH + 3.0) * h).is_some()
                || inside(search, [x, y])
        };
        let found = (0..self.tiles.tiles.len() as u32).filter(near);
        // Most leaves there are of an upright wall, which tells least.
        let axis = self.sections.frame.axes[2];
        let wall = |l: &u32| vec3::dot(self.tiles.tiles[*l as usize].plane.normal, axis).abs() < UPRIGHT;
        let (walls, others): (Vec<u32>, Vec<u32>) = found.partition(wall);
        let some = |leaves: Vec<u32>, most: usize| {
            let step = leaves.len().div_ceil(most).max(1);
            leaves.into_iter().step_by(step)
        };
        some(walls, LEAVES[0]).chain(some(others, LEAVES[1])).collect()
    }

    fn spot(&self, search: &Search, i: u32, plane: &TangentPlane) -> Option<Spot> {
        let (frame, local) = (&self.sections.frame, &self.local.frame);
        let (h, noise) = (self.sections.spacing, self.sections.noise);
        let position = self.local.positions[i as usize];
        let [x, y, height] = frame.coordinates(local.to_world(position));
        let (low, high) = search.range();
        if !(low..=high).contains(&height) {
            return None;
        }
        let near = search.outline.outline.nearest_within([x, y], (OUTLINE_REACH + 1.0) * h);
        let near = near.filter(|n| n.1 <= OUTLINE_REACH * h);
        let (foot, off) = match near {
            Some(near) => near,
            None if inside(search, [x, y]) => ([x, y], f64::INFINITY),
            None => return None,
        };
        let away = vec3::dot(vec3::sub(position, plane.centre), plane.normal).abs();
        // A tile of a face may hold a few points of the wall.
        let fits = plane.residual <= (2.0 * noise + 0.15) * plane.spacing
            && away <= (1.5 * noise + 0.05) * plane.spacing;
        let centre = frame.coordinates(local.to_world(plane.centre));
        Some(Spot { at: [x, y], height, off, foot, centre, normal: frame.coordinates(plane.normal), fits })
    }
}

/// The points, of those considered, that show ends other than slow ones.
pub(super) fn ahead_of_start<'s>(search: &Search, spots: &'s [Spot]) -> &'s [Spot] {
    &spots[spots.partition_point(|s| search.ahead(s.height) < -search.behind)..]
}
