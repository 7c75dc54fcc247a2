//! The points of a face around a crease point: from those that the votes give it outwards over the neighbour graph, across no strip.

use super::beside::Beside;
use super::plane::Plane;
use super::stations::Station;
use super::surface::Axes;
use crate::math::vec3::{cross, dot, sub};
use crate::patch::Ground;

/// Slope that a face may have against its tangent plane at the crease, as far as it is followed.
const SLOPE: f64 = 0.15;
/// Offset from the tangent plane, in standard deviations of the noise, that is no slope.
const NOISE: f64 = 4.0;
/// Distance of the points from which a face is followed, units of the place.
const SEEDS: f64 = 3.5;

/// Fewest seeds whose plane is surer than that through the crease and their centroid.
const SURE: usize = 12;
/// Half the width of the wall along other strips that no face leads across, units of the place: more than half a link of the graph.
const WALL: f64 = 2.5;

/// Fewest points that tell the side of another strip on which a face lies, and the share of those beside it.
const KNOWN: usize = 3;
const AGREED: f64 = 0.8;

/// Memory of a search, used repeatedly without clearing.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    seen: Vec<u32>,
    search: u32,
}

/// A face near a crease point.
pub(super) struct Face {
    pub axes: Axes,
    pub points: Vec<[f64; 3]>,
}

/// What a face is followed by.
pub(super) struct Rule<'a> {
    pub ground: &'a Ground<'a>,
    pub beside: &'a [Beside],
    /// Number of the strip.
    pub strip: u32,
    /// Points nearer to a strip are left out.
    pub clear: f64,
    /// The unit of the place.
    pub unit: f64,
    /// Least standard deviation of a point.
    pub floor: f64,
}

impl Rule<'_> {
    /// The face `side` at a crease point of the strip, from the points in `near`, as far as `reach` along and across.
    pub(super) fn face(
        &self,
        station: &Station,
        side: usize,
        near: &[u32],
        reach: f64,
        scratch: &mut Scratch,
    ) -> Option<Face> {
        let (at, along) = (station.at, station.direction);
        let point = |i: u32| self.ground.points[i as usize];
        let on = |&i: &u32| {
            let d = sub(point(i), at);
            self.beside[i as usize].is_on(self.strip, side, self.clear)
                && dot(d, d).sqrt() <= SEEDS * self.unit
        };
        let seeds: Vec<u32> = near.iter().copied().filter(on).collect();
        let plane = Plane::fit(seeds.iter().map(|&i| point(i)), self.floor)?;
        // The face contains the direction of the crease.
        let across = sub(plane.centre, at);
        let normal = if seeds.len() < SURE { cross(along, across) } else { plane.normal };
        let length = dot(normal, normal).sqrt();
        if length == 0.0 {
            return None;
        }
        let axes = Axes::new(at, along, normal.map(|x| x / length), plane.centre)?;
        Some(Face { axes, points: self.grown(&axes, side, seeds, reach, scratch) })
    }

    fn grown(
        &self,
        axes: &Axes,
        side: usize,
        seeds: Vec<u32>,
        reach: f64,
        scratch: &mut Scratch,
    ) -> Vec<[f64; 3]> {
        scratch.begin(self.ground.points.len());
        let mut found = seeds;
        found.iter().for_each(|&i| scratch.seen[i as usize] = scratch.search);
        let own = [(self.strip, side as u32)];
        // Across no wall first; then up to the strips that bound the same face, whose side of it is known by now.
        self.spread(axes, &own, self.clear.max(WALL * self.unit), reach, &mut found, scratch);
        let sides = self.sides(&found);
        self.spread(axes, &sides, f64::INFINITY, reach, &mut found, scratch);
        found.iter().map(|&i| self.ground.points[i as usize]).collect()
    }

    /// Adds the points that the graph leads to, within the window and near the tangent plane: on the given sides of strips, and
    /// elsewhere at least `wall` from all strips.
    fn spread(
        &self,
        axes: &Axes,
        sides: &[(u32, u32)],
        wall: f64,
        reach: f64,
        found: &mut Vec<u32>,
        scratch: &mut Scratch,
    ) {
        let noise = NOISE * self.ground.scales.mean.noise.max(self.floor);
        let passes = |beside: &Beside| {
            let on =
                beside.distance >= self.clear && sides.binary_search(&(beside.strip, beside.side)).is_ok();
            on || beside.strip != self.strip && beside.distance >= wall
        };
        let mut next = 0;
        while next < found.len() {
            let from = found[next];
            next += 1;
            for &i in self.ground.graph.of(from as usize) {
                if scratch.seen[i as usize] == scratch.search || !passes(&self.beside[i as usize]) {
                    continue;
                }
                let [u, v, w] = axes.local(self.ground.points[i as usize]);
                if u >= 0.0 && u <= reach && v.abs() <= reach && w.abs() <= noise + SLOPE * u.hypot(v) {
                    scratch.seen[i as usize] = scratch.search;
                    found.push(i);
                }
            }
        }
    }

    /// The sides of strips on which a face lies that has these points, ascending: those of nearly all its points beside a strip.
    fn sides(&self, found: &[u32]) -> Vec<(u32, u32)> {
        let beside = found.iter().map(|&i| &self.beside[i as usize]).filter(|b| b.has_side());
        let mut all: Vec<(u32, u32)> = beside.map(|b| (b.strip, b.side)).collect();
        all.sort_unstable();
        let of_strips = all.chunk_by(|a, b| a.0 == b.0);
        of_strips
            .flat_map(|strip| {
                let enough = |n: usize| n >= KNOWN && n as f64 >= AGREED * strip.len() as f64;
                strip.chunk_by(|a, b| a == b).filter(move |of| enough(of.len())).map(|of| of[0])
            })
            .collect()
    }
}

impl Scratch {
    fn begin(&mut self, count: usize) {
        if self.seen.len() != count || self.search == u32::MAX {
            self.seen = vec![0; count];
            self.search = 0;
        }
        self.search += 1;
    }
}
