//! Sections of a cloud: the curves in which slicing planes meet the surface.
//!
//! After Kyriazis, Fudos and Palios, *Detecting features from sliced point clouds* (2007): slice, project, tell the
//! contours apart, draw an outline through feature points, describe it by curves. Two steps are ours: the points of
//! a slab are carried to the plane along the local surface before anything is drawn, so that a slanted wall gives a
//! thin band ([`SectionParams::carry`]); and contours are told apart and ordered by linking tangents, before any
//! outline, so that several, nested and open ones need no special case.

mod adaptive;
mod band;
mod carry;
mod chain;
mod corner;
mod curve;
mod hull;
mod join;
mod link;
mod lsq;
mod nest;
mod node;
mod outline;
mod params;
mod plane;
mod polyline;
mod primitive;
mod result;
mod slice;
mod smooth;
mod spline;
mod spread;
mod stack;
mod stray;
mod surface;
mod tidy;
mod tree;
mod vec2;
mod voronoi;

use rayon::prelude::*;

use crate::cloud::Cloud;
use crate::error::Error;
use crate::frame::{Frame, Localised};
use crate::neighbors::Index;

pub use params::{Axis, Outline, Planes, SectionParams, Side};
pub use result::{Contour, CurvePiece, CurveShape, Missing, Section, Sections};
pub use slice::SliceFrame;
pub use stack::{Feature, Mirror, Repeat, Run, Stack, stack};

use carry::{Reach, Sample};
use slice::Slabs;
use surface::{Surface, Texture};

/// Fewest points of a slab that a curve is sought in.
const FEWEST: usize = 4;

/// Slices a cloud: one [`Section`] for each plane, in the order the planes were given or run along the axis.
///
/// # Errors
/// [`Error::Parameter`] for a value outside its range; what [`Frame::localise`] refuses.
pub fn section(cloud: &Cloud, params: &SectionParams) -> Result<Sections, Error> {
    params.check()?;
    let local = Frame::localise(cloud)?;
    sections(&local, &Index::build(&local.positions), params)
}

/// [`section`], and what [`stack`] says of the sections.
///
/// # Errors
/// Those of [`section`].
pub fn section_and_stack(cloud: &Cloud, params: &SectionParams) -> Result<(Sections, Stack), Error> {
    params.check()?;
    let local = Frame::localise(cloud)?;
    let index = Index::build(&local.positions);
    let sections = sections(&local, &index, params)?;
    let stack = stack::of(&local, &index, &sections);
    Ok((sections, stack))
}

fn sections(local: &Localised, index: &Index, params: &SectionParams) -> Result<Sections, Error> {
    let texture = surface::texture(&local.positions, index);
    let slicer = Slicer::new(local, params, texture);
    let mut heights = slicer.heights(params)?;
    if let Planes::Adaptive { start, most } = params.planes {
        heights = slicer.adapted(local, index, start, most);
    }
    let found = slicer.cut(local, index, &heights);
    Ok(slicer.finish(found, local, heights))
}

/// The cloud turned so that its third coordinate runs across the slices, with what holds for all of them.
struct Slicer<'a> {
    params: &'a SectionParams,
    frame: SliceFrame,
    scale: f64,
    /// World height of local height 0.
    base: f64,
    texture: Texture,
    turned: Vec<[f64; 3]>,
}

impl<'a> Slicer<'a> {
    fn new(local: &Localised, params: &'a SectionParams, texture: Texture) -> Self {
        let frame = slice::resolve(params.axis, &local.positions);
        let turned = local.positions.par_iter().map(|&p| frame.coordinates(p)).collect();
        let base = frame.coordinates(local.frame.offset)[2];
        Self { params, frame, scale: local.frame.scale, base, texture, turned }
    }

    /// World heights of the planes in the order asked for.
    fn heights(&self, params: &SectionParams) -> Result<Vec<f64>, Error> {
        let (low, high) = self.extent();
        params::positions(&params.planes, low, high)
    }

    /// Least and greatest world height of the points; 0 for none.
    fn extent(&self) -> (f64, f64) {
        let bounds = |(low, high): (f64, f64), p: &[f64; 3]| (low.min(p[2]), high.max(p[2]));
        let (low, high) = self.turned.iter().fold((f64::INFINITY, f64::NEG_INFINITY), bounds);
        if low > high { (0.0, 0.0) } else { (self.base + self.scale * low, self.base + self.scale * high) }
    }

    /// World heights at the middles of adaptive slabs.
    fn adapted(&self, local: &Localised, index: &Index, start: usize, most: usize) -> Vec<f64> {
        let limits = adaptive::Limits {
            start,
            most,
            thinnest: 2.0 * self.params.reach_spacings * self.texture.spacing * self.scale,
            alike: (0.15 + 0.5 * self.texture.noise) * self.texture.spacing,
        };
        let slabs = adaptive::slabs(self.extent(), limits, |heights| self.cut(local, index, heights));
        slabs.into_iter().map(|(low, high)| 0.5 * (low + high)).collect()
    }

    /// Half the thickness of a slab, local frame.
    fn half(&self) -> f64 {
        let auto = self.params.reach_spacings * self.texture.widest;
        self.params.thickness.map_or(auto, |t| 0.5 * t / self.scale)
    }

    fn cut(&self, local: &Localised, index: &Index, heights: &[f64]) -> Vec<Section> {
        // Slabs want ascending planes; the order asked for comes back at the end.
        let mut order: Vec<usize> = (0..heights.len()).collect();
        order.sort_by(|&a, &b| heights[a].total_cmp(&heights[b]).then(a.cmp(&b)));
        let ascending: Vec<f64> = order.iter().map(|&k| (heights[k] - self.base) / self.scale).collect();
        let slabs = Slabs::of(&self.turned, &ascending, self.half());
        let wanted = slabs.union(self.turned.len());
        let surface = surface::fit(&local.positions, index, &wanted, self.texture.noise);
        let cut = |(slot, &plane): (usize, &usize)| {
            let place = Place { plane, height: heights[plane], local: ascending[slot] };
            self.section(slabs.of_plane(slot), &surface, place)
        };
        let mut sections: Vec<Section> = order.par_iter().enumerate().map(cut).collect();
        sections.sort_by_key(|s| s.plane);
        sections
    }

    fn section(&self, slab: &[u32], surface: &Surface, place: Place) -> Section {
        let samples = self.samples(slab, surface, place.local);
        let chains = outline::contours(&samples, self.params, &self.texture);
        let missing = match (slab.len(), chains.len()) {
            (0, _) => Some(Missing::Empty),
            (n, 0) if n < FEWEST => Some(Missing::TooFewPoints(n)),
            (n, 0) => Some(Missing::NoCurve(n)),
            _ => None,
        };
        let tolerance = self.params.tolerance.map_or_else(|| self.tolerance(), |t| t / self.scale);
        let contours = result::contours(chains, self.params.fit.then_some(tolerance));
        Section { plane: place.plane, height: place.height, points: slab.len(), contours, missing }
    }

    /// What the smoothing leaves of the noise, with room for a curve to differ.
    fn tolerance(&self) -> f64 {
        (0.1 + 0.6 * self.texture.noise) * self.texture.spacing
    }

    fn samples(&self, slab: &[u32], surface: &Surface, height: f64) -> Vec<Sample> {
        let half = self.params.thickness.map(|t| 0.5 * t / self.scale);
        let turn = |i: u32| {
            let mut patch = *surface.at(i)?;
            patch.normal = self.frame.coordinates(patch.normal);
            patch.centre = self.frame.coordinates(patch.centre);
            patch.centre[2] -= height;
            let [x, y, z] = self.turned[i as usize];
            let reach = Reach {
                half: half.map_or(self.params.reach_spacings, |h| h / patch.spacing),
                noise: self.texture.noise,
                carry: self.params.carry,
            };
            carry::carry([x, y, z - height], &patch, reach)
        };
        slab.iter().filter_map(|&i| turn(i)).collect()
    }

    /// Brings sections from the slice frame to the world.
    fn finish(&self, mut sections: Vec<Section>, local: &Localised, heights: Vec<f64>) -> Sections {
        let world = |height: f64| {
            let third = (height - self.base) / self.scale;
            move |p: [f64; 2]| local.frame.to_world(self.frame.vector([p[0], p[1], third]))
        };
        for section in &mut sections {
            let to_world = world(section.height);
            section.contours.iter_mut().for_each(|c| c.place(&to_world, self.scale));
        }
        Sections {
            frame: self.frame,
            heights,
            spacing: self.texture.spacing * self.scale,
            noise: self.texture.noise,
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
