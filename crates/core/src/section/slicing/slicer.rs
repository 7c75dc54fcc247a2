//! A cloud cut at any heights: the values that all slices share, and the way from a slab to its section.

use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use super::planes::{self, Cut};
use super::reach::Reach;
use super::slabs::Slabs;
use super::{adaptive, direction, level};
use crate::error::Error;
use crate::frame::Localised;
use crate::neighbors::Index;
use crate::parallel;
use crate::params::section::{Outline, Planes, Side, Zero};
use crate::params::{Auto, SectionParams};
use crate::section::frame::SliceFrame;
use crate::section::outline;
use crate::section::result::{self, FEWEST_POINTS, Missing, Section, Sections};
use crate::section::steps::SliceSteps;
use crate::section::surface::carry::{Bins, Carrier, CarryLimits, Sample};
use crate::section::surface::plane::TangentPlane;
use crate::section::surface::quad::QUAD;
use crate::section::surface::tangents::{TangentPlanes, tangent_planes};
use crate::section::surface::texture::{Texture, texture};
use crate::section::surface::tile::{NOISY, Tile};
use crate::section::surface::tiles::Tiles;

/// Distance from which points are carried, as a multiple of the slab's reach, unless a thickness is given, as randomly scattered
/// points leave holes in a thin slab: for points with a plane of their own, and for those of a flat tile, whose plane is more
/// certain.
const CARRY_FARTHER: [f64; 2] = [1.2, 2.0];

/// A cloud to be cut across one axis, with the values that all slices share.
pub(crate) struct Slicer<'a> {
    local: &'a Localised,
    index: &'a Index,
    params: &'a SectionParams,
    frame: SliceFrame,
    scale: f64,
    /// World height of local height 0.
    base: f64,
    texture: Texture,
    tiles: Tiles,
    observe: &'a (dyn Fn(f64) + Sync),
}

impl<'a> Slicer<'a> {
    pub(crate) fn new(
        local: &'a Localised,
        index: &'a Index,
        params: &'a SectionParams,
        observe: &'a (dyn Fn(f64) + Sync),
    ) -> Self {
        let texture = texture(&local.positions, index);
        let frame = direction::resolve(params, &local.positions, index, texture.noise);
        let tiles = Tiles::new(index, texture.noise, frame.axes[2]);
        let base = frame.coordinates(local.frame.offset)[2];
        Self { local, index, params, frame, scale: local.frame.scale, base, texture, tiles, observe }
    }

    /// The planes in their order, those of adaptive slabs after as many cuts as these take.
    ///
    /// # Errors
    /// [`Error::Parameter`] for planes that cannot be.
    pub(crate) fn planned(&self) -> Result<Vec<Cut>, Error> {
        let cuts = self.cuts()?;
        Ok(match self.params.planes {
            Planes::Adaptive { start, most } => self.adapted(start, most),
            _ => cuts,
        })
    }

    /// The planes, world heights, in the order asked for.
    fn cuts(&self) -> Result<Vec<Cut>, Error> {
        let (low, high) = self.extent();
        match &self.params.planes {
            Planes::At(at) => {
                let zero = self.zero().1;
                planes::cuts(&Planes::At(at.iter().map(|z| zero + z).collect()), low, high)
            }
            planes => planes::cuts(planes, low, high),
        }
    }

    /// The place that positions are counted from, and its world height.
    fn zero(&self) -> (Zero, f64) {
        let tiles = &self.tiles.tiles;
        let lowest = || (Zero::Lowest, self.extent().0);
        let floor = || level::floor(tiles, self.frame.axes[2], self.texture.spacing);
        match self.params.from {
            Zero::Origin => (Zero::Origin, 0.0),
            Zero::Floor => {
                floor().map_or_else(lowest, |height| (Zero::Floor, self.base + self.scale * height))
            }
            Zero::Lowest => lowest(),
        }
    }

    /// Least and greatest world height of the points; 0 for none.
    fn extent(&self) -> (f64, f64) {
        let bounds =
            |(low, high): (f64, f64), tile: &Tile| (low.min(tile.heights.0), high.max(tile.heights.1));
        let (low, high) = self.tiles.tiles.iter().fold((f64::INFINITY, f64::NEG_INFINITY), bounds);
        if low > high { (0.0, 0.0) } else { (self.base + self.scale * low, self.base + self.scale * high) }
    }

    /// Planes at the middles of adaptive slabs.
    fn adapted(&self, start: usize, most: usize) -> Vec<Cut> {
        let alike = self.params.alike_spacings.or(|| 0.15 + 0.5 * self.texture.noise);
        let limits = adaptive::Limits {
            start,
            most,
            thinnest: 2.0 * self.params.reach_spacings * self.texture.spacing * self.scale,
            step: self.texture.spacing,
            alike: alike * self.texture.spacing,
        };
        let slabs = adaptive::slabs(self.extent(), limits, |heights| self.cut(heights));
        slabs.into_iter().map(|(low, high)| (0.5 * (low + high), Some([low, high]))).collect()
    }

    /// Half the thickness of a slab, local frame.
    fn half(&self) -> f64 {
        let auto = self.params.reach_spacings * self.texture.widest;
        match self.params.thickness {
            Auto::Given(thickness) => 0.5 * thickness / self.scale,
            Auto::Auto => auto,
        }
    }

    /// The sections at some world heights, in their order.
    pub(crate) fn cut(&self, heights: &[f64]) -> Vec<Section> {
        let done = AtomicUsize::new(0);
        self.each(heights, |slab, planes, place| {
            let section = self.section(slab, planes, place, &mut |_| ());
            (self.observe)((done.fetch_add(1, Relaxed) + 1) as f64 / heights.len() as f64);
            section
        })
    }

    /// The steps to these sections.
    pub(crate) fn steps(&self, heights: &[f64]) -> Vec<SliceSteps> {
        self.each(heights, |slab, planes, place| {
            let mut steps = SliceSteps { plane: place.plane, ..SliceSteps::default() };
            let to_world = self.to_world(place.height);
            self.section(slab, planes, place, &mut |seen| steps.see(seen, &to_world, self.scale));
            let within = |leaf: &u32| {
                let own = &self.index.leaves[*leaf as usize];
                let heights = own.along(self.frame.axes[2]);
                own.ids().zip(heights).filter(|(_, z)| (z - place.local).abs() <= self.half())
            };
            steps.slab = slab.iter().flat_map(within).map(|(i, _)| self.local.source[i as usize]).collect();
            steps.slab.sort_unstable();
            steps
        })
    }

    /// What `one` makes of the slab of each plane, in the order of the heights.
    fn each<T: Send>(
        &self,
        heights: &[f64],
        one: impl Fn(&[u32], &TangentPlanes, Place) -> T + Sync,
    ) -> Vec<T> {
        // Slabs want ascending planes; the order asked for comes back at the end.
        let mut order: Vec<usize> = (0..heights.len()).collect();
        order.sort_by(|&a, &b| heights[a].total_cmp(&heights[b]).then(a.cmp(&b)));
        let ascending: Vec<f64> = order.iter().map(|&k| (heights[k] - self.base) / self.scale).collect();
        let tiles = &self.tiles.tiles;
        let slabs = Slabs::of(tiles.len(), |t| tiles[t].heights, &ascending, self.half());
        let wanted = slabs.union(tiles.len());
        let (points, noise) = (&self.local.positions, self.texture.noise);
        let planes = tangent_planes(points, self.index, &self.tiles, &wanted, noise);
        let made = parallel::map(order.len(), parallel::TASK, |slot| {
            let plane = order[slot];
            let place = Place { plane, height: heights[plane], local: ascending[slot] };
            one(slabs.of_plane(slot), &planes, place)
        });
        let mut made: Vec<(usize, T)> = order.into_iter().zip(made).collect();
        made.sort_by_key(|(plane, _)| *plane);
        made.into_iter().map(|(_, one)| one).collect()
    }

    fn section(
        &self,
        slab: &[u32],
        planes: &TangentPlanes,
        place: Place,
        see: &mut dyn FnMut(outline::Seen),
    ) -> Section {
        let (points, samples) = self.samples(slab, planes, place.local);
        let reach = Reach::new(self.index, &self.local.positions, self.texture.spacing);
        // Within a given thickness all points count, however far they lie from the plane.
        let all = self.params.thickness != Auto::Auto;
        let near = |at: [f64; 2]| all || reach.covers(self.frame.vector([at[0], at[1], place.local]));
        let chains = outline::contours(&samples, self.params, &self.texture, &near, see);
        let missing = match (points, chains.len()) {
            (0, _) => Some(Missing::Empty),
            (n, 0) if n < FEWEST_POINTS => Some(Missing::TooFewPoints(n)),
            (n, 0) => Some(Missing::NoCurve(n)),
            _ => None,
        };
        let tolerance = self.tolerance();
        let contours = result::contours(chains, self.params.fit.then_some(tolerance));
        Section { plane: place.plane, height: place.height, slab: None, points, contours, missing }
    }

    /// From places on the plane at a world height to the world.
    fn to_world(&self, height: f64) -> impl Fn([f64; 2]) -> [f64; 3] {
        let third = (height - self.base) / self.scale;
        move |p: [f64; 2]| self.local.frame.to_world(self.frame.vector([p[0], p[1], third]))
    }

    /// Greatest distance of fitted curves from their contours, local frame.
    fn tolerance(&self) -> Auto<f64> {
        self.params.tolerance.map(|tolerance| tolerance / self.scale)
    }

    /// The number of points in a slab, and the samples of those that can be carried to its plane.
    fn samples(&self, slab: &[u32], planes: &TangentPlanes, height: f64) -> (usize, Vec<Sample>) {
        let half = self.half();
        let (mut count, mut samples) = (0, Vec::with_capacity(2 * slab.len()));
        let tiles = &self.tiles.tiles;
        let joined = |a: &u32, b: &u32| tiles[*a as usize].joined && *a as usize / QUAD == *b as usize / QUAD;
        for leaves in slab.chunk_by(joined) {
            let tile = planes.tile(leaves[0]);
            let carrier = if tile.flat { self.carrier(&tile.plane, height) } else { None };
            let mut bins = Bins::EMPTY;
            for &leaf in leaves {
                let own = &self.index.leaves[leaf as usize];
                let [x, y, z] = self.frame.axes.map(|axis| own.along(axis));
                let points = (0..own.len()).map(|k| [x[k], y[k], z[k] - height]);
                count += points.clone().filter(|p| p[2].abs() <= half).count();
                match &carrier {
                    Some(carrier) if self.merges() => points.for_each(|p| carrier.merge(p, &mut bins)),
                    Some(carrier) => samples.extend(points.filter_map(|p| carrier.sample(p))),
                    None if tile.flat => (),
                    None => {
                        let own = planes.fine(leaf as usize).into_iter().flatten();
                        let sample = |(p, plane)| self.carrier(plane, height)?.sample(p);
                        samples.extend(points.zip(own).filter_map(sample));
                    }
                }
            }
            carrier.iter().for_each(|carrier| carrier.merged(&bins, &mut samples));
        }
        (count, samples)
    }

    /// Whether the points of a tile may be taken together: an outline through feature points, or along a side, needs
    /// the points themselves.
    fn merges(&self) -> bool {
        self.params.outline == Outline::Middle && self.params.side == Side::Middle
    }

    /// Whether points with a plane each are carried far: under strong noise their planes do not reach that far, and an outline
    /// through feature points follows single points, however far they come from.
    fn goes_far(&self) -> bool {
        self.merges() && self.texture.noise <= NOISY
    }

    fn carrier(&self, plane: &TangentPlane, height: f64) -> Option<Carrier> {
        let mut plane = *plane;
        plane.normal = self.frame.coordinates(plane.normal);
        plane.centre = self.frame.coordinates(plane.centre);
        plane.centre[2] -= height;
        let far = |times: f64| match self.params.thickness {
            Auto::Given(thickness) => 0.5 * thickness / self.scale / plane.spacing,
            Auto::Auto => times * self.params.reach_spacings,
        };
        let limits = CarryLimits {
            half: far(if self.goes_far() { CARRY_FARTHER[0] } else { 1.0 }),
            far: far(CARRY_FARTHER[1]),
            noise: self.texture.noise,
            carry: self.params.carry,
        };
        Carrier::new(plane, limits)
    }

    /// The tiles, for the stages after slicing.
    pub(crate) fn into_tiles(self) -> Tiles {
        self.tiles
    }

    /// Brings sections from the slice frame to the world.
    pub(crate) fn finish(&self, mut sections: Vec<Section>, heights: Vec<f64>) -> Sections {
        for section in &mut sections {
            let to_world = self.to_world(section.height);
            section.contours.iter_mut().for_each(|c| c.place(&to_world, self.scale));
        }
        Sections {
            frame: self.frame.upright(),
            zero: self.zero(),
            heights,
            spacing: self.texture.spacing * self.scale,
            noise: self.texture.noise,
            dropped: self.local.dropped,
            merged: self.local.merged(),
            clutter: 0,
            sections,
        }
    }
}

/// One plane: its index, its world height and its height in the slice frame.
#[derive(Clone, Copy)]
struct Place {
    plane: usize,
    height: f64,
    local: f64,
}
