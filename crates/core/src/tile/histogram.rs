//! The density of a cloud on a grid as fine as a given number of cells allows: one pass over the points, in any order.

use crate::error::Error;
use crate::frame::{BITS, Bounds, Grid, finite};

/// Points whose codes are sorted together.
const CHUNK: usize = 1 << 16;

/// The number of points in each occupied cell of a grid, a function of the set of points alone.
///
/// The grid is the cube in which canonical order sorts the points, halved again and again: a cell holds a run of that order. Counting begins
/// with the finest cells; whenever more are occupied than allowed, eight become one. So the level is in the end the
/// finest that the whole cloud allows, in whatever order its points came, and a stray point far out costs one cell.
#[derive(Clone, Debug)]
pub struct Histogram {
    pub(super) grid: Grid,
    pub(super) bounds: Bounds,
    /// Halvings of the cube.
    pub(super) level: u32,
    /// Code and count of each occupied cell, ascending.
    pub(super) cells: Vec<(u64, u64)>,
    most: usize,
}

impl Histogram {
    /// An empty histogram for points within `bounds`, least and greatest coordinates in the world frame, of at most `most` cells
    /// (and at least one).
    ///
    /// # Errors
    /// [`Error::Extent`] where the bounds lie more than 1e150 apart.
    pub fn new(bounds: [[f64; 3]; 2], most: usize) -> Result<Histogram, Error> {
        let [min, max] = bounds;
        let bounds = Bounds { min, max };
        let grid = Grid::new(bounds.corner(), bounds.extent()?);
        Ok(Histogram { grid, bounds, level: BITS, cells: Vec::new(), most: most.max(1) })
    }

    /// The histogram of `(N, 3)` positions, world frame: bounds first, then counts.
    ///
    /// # Errors
    /// As [`Histogram::new`].
    pub fn of(points: &[[f64; 3]], most: usize) -> Result<Histogram, Error> {
        let Bounds { min, max } = Bounds::of(points);
        let mut histogram = Histogram::new([min, max], most)?;
        histogram.add(points)?;
        Ok(histogram)
    }

    /// Counts `(N, 3)` positions, world frame; points with a coordinate that is not finite are left out.
    ///
    /// # Errors
    /// [`Error::OutOfBounds`] for the first point beyond the bounds; nothing of `points` may be counted twice after that.
    pub fn add(&mut self, points: &[[f64; 3]]) -> Result<(), Error> {
        for chunk in points.chunks(CHUNK) {
            let mut codes = Vec::with_capacity(chunk.len());
            for &p in chunk.iter().filter(|p| finite(p)) {
                self.within(p)?;
                codes.push(self.grid.code(self.grid.relative(p), 0) >> (3 * (BITS - self.level)));
            }
            codes.sort_unstable();
            self.merge(codes.into_iter().map(|code| (code, 1)));
            while self.cells.len() > self.most && self.level > 0 {
                self.coarsen();
            }
        }
        Ok(())
    }

    fn within(&self, p: [f64; 3]) -> Result<(), Error> {
        let Bounds { min, max } = self.bounds;
        match (0..3).find(|&axis| !(min[axis]..=max[axis]).contains(&p[axis])) {
            Some(axis) => Err(Error::OutOfBounds { axis, value: p[axis], min: min[axis], max: max[axis] }),
            None => Ok(()),
        }
    }

    /// Adds counts by ascending code.
    fn merge(&mut self, mut added: impl Iterator<Item = (u64, u64)>) {
        let mut merged: Vec<(u64, u64)> = Vec::with_capacity(self.cells.len());
        let mut own = std::mem::take(&mut self.cells).into_iter().peekable();
        let mut other = added.next();
        loop {
            let next = match (own.peek(), other) {
                (Some(&(a, _)), Some((b, count))) if b < a => {
                    other = added.next();
                    (b, count)
                }
                (None, Some(cell)) => {
                    other = added.next();
                    cell
                }
                _ => match own.next() {
                    Some(cell) => cell,
                    None => break,
                },
            };
            match merged.last_mut() {
                Some(last) if last.0 == next.0 => last.1 += next.1,
                _ => merged.push(next),
            }
        }
        self.cells = merged;
    }

    /// Makes one cell of eight.
    fn coarsen(&mut self) {
        self.level -= 1;
        let cells = std::mem::take(&mut self.cells);
        self.merge(cells.into_iter().map(|(code, count)| (code >> 3, count)));
    }

    /// The number of finite points.
    pub fn count(&self) -> u64 {
        self.cells.iter().map(|cell| cell.1).sum()
    }

    /// The side of a cell, in the unit of the input.
    pub fn side(&self) -> f64 {
        self.grid.side(self.level)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::Rng;

    fn scattered(count: usize) -> Vec<[f64; 3]> {
        let mut rng = Rng::new(3);
        (0..count).map(|_| [rng.uniform(), 7.0 * rng.uniform(), 0.2 * rng.uniform()]).collect()
    }

    #[test]
    fn the_level_is_the_finest_of_few_enough_cells_whatever_the_order() {
        let mut points = scattered(200_000);
        let whole = Histogram::of(&points, 3000).unwrap();
        assert_eq!(whole.count(), 200_000);
        assert!(whole.cells.len() <= 3000 && whole.cells.len() > 300, "{}", whole.cells.len());
        points.reverse();
        let Bounds { min, max } = Bounds::of(&points);
        let mut other = Histogram::new([min, max], 3000).unwrap();
        points.chunks(777).for_each(|some| other.add(some).unwrap());
        assert_eq!((whole.level, &whole.cells), (other.level, &other.cells));
    }

    #[test]
    fn a_stray_point_far_out_takes_no_cells_from_the_cloud() {
        let mut points = scattered(50_000);
        let near = Histogram::of(&points, 3000).unwrap();
        points.push([3e4; 3]);
        let far = Histogram::of(&points, 3000).unwrap();
        assert!(far.cells.len() > near.cells.len() / 16, "{} and {}", near.cells.len(), far.cells.len());
    }

    #[test]
    fn points_beyond_the_bounds_are_refused_with_their_coordinate_and_infinite_ones_left_out() {
        let mut histogram = Histogram::new([[0.0; 3], [1.0; 3]], 100).unwrap();
        histogram.add(&[[0.5; 3], [f64::NAN, 0.0, 0.0], [1.0; 3]]).unwrap();
        assert_eq!(histogram.count(), 2);
        let message = histogram.add(&[[0.5, 2.5, 0.5]]).unwrap_err().to_string();
        assert!(message.contains("2.5") && message.contains("axis 1"), "{message}");
    }
}
