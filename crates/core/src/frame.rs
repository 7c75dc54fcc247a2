//! The local frame that every stage works in: lengths near 1, the origin at the cloud, the points in one order.

mod morton;
mod order;

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use rayon::prelude::*;

use crate::cloud::Cloud;
use crate::error::Error;
use morton::Grid;
use order::Ordered;

/// Squares of coordinate differences beyond this extent could overflow.
const EXTENT_LIMIT: f64 = 1e150;

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
    /// `(N)` for each input point its canonical index; `u32::MAX` where it was dropped as non-finite.
    pub canonical: Vec<u32>,
    /// The number of input points with a coordinate that is not finite.
    pub dropped: usize,
    /// The number of input points that repeat another one exactly.
    pub merged: usize,
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
        let points = &world.positions;
        let limit = u32::MAX as usize - 1;
        if points.len() > limit {
            return Err(Error::TooManyPoints { read: points.len(), limit });
        }
        let bounds = Bounds::of(points);
        let grid = Grid::new(bounds.corner(), bounds.extent()?);
        let Ordered { relative: mut positions, mut source, levels } = order::canonical(&grid, points);
        let frame = Frame { offset: grid.offset, scale: grid.spacing(&levels) };
        let to_local = 1.0 / frame.scale;
        positions.par_iter_mut().for_each(|p| *p = p.map(|x| x * to_local));
        let finite = positions.len();
        let canonical = merge(&mut positions, &mut source, points.len());
        let (dropped, merged) = (points.len() - finite, finite - positions.len());
        Ok(Localised { frame, positions, source, canonical, dropped, merged })
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
#[derive(Clone, Copy)]
struct Bounds {
    min: [f64; 3],
    max: [f64; 3],
}

impl Bounds {
    const NONE: Bounds = Bounds { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };

    /// Over the points of which all three coordinates are finite.
    fn of(points: &[[f64; 3]]) -> Bounds {
        points.par_chunks(1 << 14).map(Bounds::of_chunk).reduce(|| Bounds::NONE, Bounds::union)
    }

    fn of_chunk(points: &[[f64; 3]]) -> Bounds {
        points
            .iter()
            .filter(|p| morton::finite(p))
            .fold(Bounds::NONE, |b, &p| b.union(Bounds { min: p, max: p }))
    }

    fn union(self, other: Bounds) -> Bounds {
        let less = |a: f64, b: f64| if b < a { b } else { a };
        let more = |a: f64, b: f64| if b > a { b } else { a };
        Bounds {
            min: std::array::from_fn(|a| less(self.min[a], other.min[a])),
            max: std::array::from_fn(|a| more(self.max[a], other.max[a])),
        }
    }

    /// The local origin. Adding zero turns -0.0, which may or may not have been the least zero, into 0.0.
    fn corner(&self) -> [f64; 3] {
        self.min.map(|x| if x.is_finite() { x + 0.0 } else { 0.0 })
    }

    /// The longest side; zero without points.
    fn extent(&self) -> Result<f64, Error> {
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

/// Keeps the first of each run of equal points, and numbers the input by what is kept. Every input point is
/// numbered once, so that it does not matter which thread does it.
fn merge(positions: &mut Vec<[f64; 3]>, source: &mut Vec<u32>, read: usize) -> Vec<u32> {
    let canonical: Vec<AtomicU32> = (0..read).into_par_iter().map(|_| AtomicU32::new(u32::MAX)).collect();
    let number = |(c, &i): (usize, &u32)| canonical[i as usize].store(c as u32, Relaxed);
    if positions.par_windows(2).any(|pair| pair[0] == pair[1]) {
        let mut kept = 0;
        for i in 0..positions.len() {
            let index = source[i];
            if i == 0 || positions[i] != positions[kept - 1] {
                positions[kept] = positions[i];
                source[kept] = index;
                kept += 1;
            }
            number((kept - 1, &index));
        }
        positions.truncate(kept);
        source.truncate(kept);
    } else {
        source.par_iter().enumerate().for_each(number);
    }
    canonical.into_iter().map(AtomicU32::into_inner).collect()
}

#[cfg(test)]
mod tests;
