//! The local frame that every stage works in: lengths near 1, the origin at the cloud, the points in one order.

mod far;
mod morton;
mod order;

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use crate::cloud::Cloud;
use crate::error::Error;
use crate::parallel;
pub(crate) use morton::{BITS, Grid, LEVELS, Levels, cell, finite};
use order::Ordered;

/// Squares of coordinate differences beyond this extent could overflow.
const EXTENT_LIMIT: f64 = 1e150;

/// Spacings below this have squares that vanish.
const LEAST_SPACING: f64 = 1e-140;

/// Points that one thread treats one after the other.
const CHUNK: usize = 1 << 14;

/// Where the local frame lies in the world: `world = offset + scale * local`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// World coordinates of the local origin: the least finite coordinate on each axis, so that a translation
    /// which is exact in f64 leaves every local bit as it was.
    pub offset: [f64; 3],
    /// World length of one local unit: a power of two within a factor of about two of the mean spacing.
    pub scale: f64,
}

/// A cloud in its local frame: finite, distinct points in canonical order.
#[derive(Clone, Debug, PartialEq)]
pub struct Localised {
    /// The way back to the world.
    pub frame: Frame,
    /// `(M, 3)` f64, local frame, canonical order: Morton order, a function of the set of points alone.
    pub positions: Vec<[f64; 3]>,
    /// `(M)` for each canonical point its index in the input, the least one among exact duplicates.
    pub source: Vec<u32>,
    /// Each input point that repeats another one exactly, with their canonical index.
    pub repeats: Vec<(u32, u32)>,
    /// The number of input points left out: with a coordinate that is not finite, or beyond reach.
    pub dropped: usize,
    /// How many of these are finite, but so far from the others that f64 cannot hold both: numbers that stand for no value.
    pub beyond: usize,
}

impl Localised {
    /// Whether coordinates from the least corner hardly tell neighbours apart.
    fn is_coarse(&self) -> bool {
        let extent = self.positions.iter().flatten().copied().fold(0.0, f64::max) * self.frame.scale;
        far::suspected(extent, self.frame.scale, self.merged(), self.positions.len() + self.merged())
    }

    /// The number of input points that repeat another one exactly.
    pub fn merged(&self) -> usize {
        self.repeats.len()
    }

    /// The same, unless its spacing has a square that vanishes in f64. Two points and fewer have no spacing.
    ///
    /// # Errors
    /// [`Error::Extent`] with the longest side.
    pub fn with_spacing(self) -> Result<Self, Error> {
        let Self { frame, positions, .. } = &self;
        let side = |axis: usize| frame.length_to_world(positions.iter().map(|p| p[axis]).fold(0.0, f64::max));
        let axis = (1..3).fold(0, |best, axis| if side(axis) > side(best) { axis } else { best });
        // Below the normal numbers the spacing itself is not known.
        if positions.len() < 3 || frame.scale >= LEAST_SPACING && side(axis) >= LEAST_SPACING {
            return Ok(self);
        }
        let min = frame.offset[axis];
        Err(Error::Extent { axis, min, max: min + side(axis) })
    }

    /// `(N)` for each input point its canonical index; `u32::MAX` where it was dropped as non-finite.
    pub fn canonical(&self) -> Vec<u32> {
        let read = self.source.len() + self.merged() + self.dropped;
        let canonical = parallel::map(read, parallel::QUICK, |_| AtomicU32::new(u32::MAX));
        // Every input point is numbered once, so that it does not matter which thread does it.
        let number = |i: u32, c: u32| canonical[i as usize].store(c, Relaxed);
        parallel::map(self.source.len(), parallel::QUICK, |c| number(self.source[c], c as u32));
        self.repeats.iter().for_each(|&(i, c)| number(i, c));
        canonical.into_iter().map(AtomicU32::into_inner).collect()
    }
}

impl Frame {
    /// Brings a cloud into its local frame and into canonical order, without its non-finite points and without
    /// its exact duplicates. Clouds of no, one or few points are fine.
    ///
    /// Two points are the same when their offsets from the least corner round to the same f64.
    ///
    /// # Errors
    /// [`Error::TooManyPoints`] above `u32::MAX - 1` points; [`Error::Extent`] where coordinates lie more than
    /// 1e150 apart, so that squared distances could overflow.
    pub fn localise(world: &Cloud) -> Result<Localised, Error> {
        Self::of_points(&world.positions)
    }

    /// [`localise`](Self::localise) of `(N, 3)` positions that are part of no [`Cloud`].
    pub(crate) fn of_points(points: &[[f64; 3]]) -> Result<Localised, Error> {
        let limit = u32::MAX as usize - 1;
        if points.len() > limit {
            return Err(Error::TooManyPoints { read: points.len(), limit });
        }
        match Frame::of_all(points) {
            Ok(local) if !local.is_coarse() => Ok(local),
            coarse => match far::without(points) {
                Some((kept, beyond)) => Ok(Localised { beyond, ..Frame::of_all(&kept)? }),
                None => coarse,
            },
        }
    }

    fn of_all(points: &[[f64; 3]]) -> Result<Localised, Error> {
        let bounds = Bounds::of(points);
        let grid = Grid::new(bounds.corner(), bounds.extent()?);
        let ordered = order::canonical(&grid, points);
        Ok(Frame::of_levels(&grid, &ordered.levels).localised(ordered, points.len()))
    }

    /// The frame of a cloud in its grid, by the levels at which its points part in the order.
    pub(crate) fn of_levels(grid: &Grid, levels: &Levels) -> Frame {
        Frame { offset: grid.offset, scale: grid.spacing(levels) }
    }

    /// Some points of a cloud in its frame and in its order; sources are indices of `points`.
    pub(crate) fn of_part(self, grid: &Grid, points: &[[f64; 3]]) -> Localised {
        self.localised(order::canonical(grid, points), points.len())
    }

    /// Some points of a cloud from its least corner, in world lengths and in its order, and the levels at which neighbours part.
    pub(crate) fn sorted(grid: &Grid, points: &[[f64; 3]]) -> (Vec<[f64; 3]>, Levels) {
        let Ordered { relative, levels, .. } = order::canonical(grid, points);
        (relative, levels)
    }

    fn localised(self, ordered: Ordered, read: usize) -> Localised {
        let Ordered { relative: mut positions, mut source, levels } = ordered;
        let to_local = 1.0 / self.scale;
        parallel::each(positions.chunks_mut(CHUNK), |_, chunk| {
            chunk.iter_mut().for_each(|p| *p = p.map(|x| x * to_local));
        });
        let finite = positions.len();
        let repeats = if levels[LEVELS] > 0 { merge(&mut positions, &mut source) } else { Vec::new() };
        Localised { frame: self, positions, source, repeats, dropped: read - finite, beyond: 0 }
    }

    /// The world coordinates of a local point.
    pub fn to_world(&self, local: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|a| self.offset[a] + local[a] * self.scale)
    }

    /// The local coordinates of a world point.
    pub fn to_local(&self, world: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|a| (world[a] - self.offset[a]) / self.scale)
    }

    /// The world length of a local one.
    pub fn length_to_world(&self, local: f64) -> f64 {
        local * self.scale
    }
}

/// Steps of the result's grid in one local unit.
const GRID_STEPS: f64 = (1_u32 << 24) as f64;

/// A local coordinate on a grid far below the noise of any scan. It leaves bits to add the frame's offset without
/// rounding, so that a cloud moved by few-bit lengths has its result moved by just those.
pub(crate) fn on_grid(local: f64) -> f64 {
    (local * GRID_STEPS).round() / GRID_STEPS
}

/// The least and greatest finite coordinates on each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) min: [f64; 3],
    pub(crate) max: [f64; 3],
}

impl Bounds {
    pub(crate) const NONE: Bounds = Bounds { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };

    /// Over the points of which all three coordinates are finite.
    pub(crate) fn of(points: &[[f64; 3]]) -> Bounds {
        let chunks = parallel::each(points.chunks(CHUNK), |_, chunk| Bounds::of_chunk(chunk));
        chunks.into_iter().fold(Bounds::NONE, Bounds::union)
    }

    fn of_chunk(points: &[[f64; 3]]) -> Bounds {
        points
            .iter()
            .filter(|p| morton::finite(p))
            .fold(Bounds::NONE, |b, &p| b.union(Bounds { min: p, max: p }))
    }

    pub(crate) fn union(self, other: Bounds) -> Bounds {
        let less = |a: f64, b: f64| if b < a { b } else { a };
        let more = |a: f64, b: f64| if b > a { b } else { a };
        Bounds {
            min: std::array::from_fn(|a| less(self.min[a], other.min[a])),
            max: std::array::from_fn(|a| more(self.max[a], other.max[a])),
        }
    }

    /// The local origin. Adding zero turns -0.0, which may or may not have been the least zero, into 0.0.
    pub(crate) fn corner(&self) -> [f64; 3] {
        self.min.map(|x| if x.is_finite() { x + 0.0 } else { 0.0 })
    }

    /// The longest side; zero without points.
    ///
    /// # Errors
    /// [`Error::Extent`] where squared distances could overflow.
    pub(crate) fn extent(&self) -> Result<f64, Error> {
        let mut longest = 0.0_f64;
        for axis in 0..3 {
            let (min, max) = (self.min[axis], self.max[axis]);
            let side = max - min;
            if side > EXTENT_LIMIT && min <= max {
                return Err(Error::Extent { axis, min, max });
            }
            longest = longest.max(side);
        }
        Ok(longest)
    }
}

/// Keeps the first of each run of equal points; returns the others' indices in the input, with what they repeat.
fn merge(positions: &mut Vec<[f64; 3]>, source: &mut Vec<u32>) -> Vec<(u32, u32)> {
    let (mut kept, mut repeats) = (0, Vec::new());
    for i in 0..positions.len() {
        if kept > 0 && positions[i] == positions[kept - 1] {
            repeats.push((source[i], kept as u32 - 1));
            continue;
        }
        (positions[kept], source[kept]) = (positions[i], source[i]);
        kept += 1;
    }
    positions.truncate(kept);
    source.truncate(kept);
    repeats
}

#[cfg(test)]
mod tests;
