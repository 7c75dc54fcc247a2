//! The plan: which part of space each tile owns.
//!
//! The occupied cells of a histogram are cut across the axis along which most of the points spread farthest, where that halves the
//! points, and each part again until it has few enough (J. L. Bentley, "Multidimensional binary search trees used for associative searching", CACM 18, 1975). Cuts
//! run between cells, so that every cell, which is a run of the canonical order, has one owner.

use super::histogram::Histogram;
use crate::frame::{Bounds, Grid, cell};

/// Shares of the points that lie below and above most of them.
const TAILS: [f64; 2] = [0.05, 0.95];

/// A part of space and the number of points in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tile {
    /// Least and greatest corner of the core, from the least corner of the cloud, in the unit of the input. A point on the
    /// greatest sides is not the tile's own. Cores do not overlap and hold all points.
    pub core: [[f64; 3]; 2],
    /// Finite points of the input in the core, duplicates included.
    pub count: u64,
}

/// The tiles of a cloud, a function of its set of points and the size wanted.
#[derive(Clone, Debug)]
pub struct Plan {
    pub(super) grid: Grid,
    pub(super) bounds: Bounds,
    /// Halvings of the grid's cube that make its cells.
    pub(super) level: u32,
    /// Codes of the occupied cells, ascending.
    pub(super) codes: Vec<u64>,
    /// Finite points in each of them, duplicates included.
    pub(super) counts: Vec<u64>,
    tiles: Vec<Tile>,
}

/// An occupied cell.
#[derive(Clone, Copy)]
struct Cell {
    at: [u32; 3],
    count: u64,
}

impl Plan {
    /// Tiles of at most `most` points each. A cell of the histogram with more points than that is a tile by itself.
    pub fn new(histogram: &Histogram, most: u64) -> Plan {
        Plan::cut(histogram, most, 0.5)
    }

    /// As [`Plan::new`], but a cut leaves the given share of the points below it.
    pub(super) fn cut(histogram: &Histogram, most: u64, share: f64) -> Plan {
        let Histogram { grid, bounds, level, cells, .. } = histogram;
        let mut own: Vec<Cell> = cells.iter().map(|&(code, count)| Cell { at: cell(code), count }).collect();
        let mut tiles = Vec::new();
        split(&mut own, most, share, &mut |cells| tiles.push(tile(cells, grid.side(*level))));
        let (codes, counts) = cells.iter().copied().unzip();
        Plan { grid: *grid, bounds: *bounds, level: *level, codes, counts, tiles }
    }

    /// The tiles, in an order that depends on the points alone.
    pub fn tiles(&self) -> &[Tile] {
        &self.tiles
    }

    /// The least corner of the cloud, world frame.
    pub fn corner(&self) -> [f64; 3] {
        self.grid.offset
    }
}

impl Tile {
    /// Whether a point, from the least corner of the cloud, is the tile's own.
    pub fn owns(&self, relative: [f64; 3]) -> bool {
        let [min, max] = self.core;
        (0..3).all(|a| min[a] <= relative[a] && relative[a] < max[a])
    }
}

/// The least and greatest cell on each axis.
fn corners(cells: &[Cell]) -> [[u32; 3]; 2] {
    let none = [[u32::MAX; 3], [0; 3]];
    cells.iter().fold(none, |[min, max], c| {
        [[0, 1, 2].map(|a| min[a].min(c.at[a])), [0, 1, 2].map(|a| max[a].max(c.at[a]))]
    })
}

fn tile(cells: &[Cell], side: f64) -> Tile {
    let [min, max] = corners(cells);
    // Cells are powers of two in size, so that their corners are exact.
    let core = [min.map(|c| f64::from(c) * side), max.map(|c| f64::from(c + 1) * side)];
    Tile { core, count: cells.iter().map(|c| c.count).sum() }
}

/// Cuts until each part has at most `most` points, and passes the parts on.
fn split(cells: &mut [Cell], most: u64, share: f64, take: &mut dyn FnMut(&[Cell])) {
    let count: u64 = cells.iter().map(|c| c.count).sum();
    let [min, max] = corners(cells);
    if cells.len() < 2 || count <= most {
        if !cells.is_empty() {
            take(cells);
        }
        return;
    }
    let width = [0, 1, 2].map(|a| (spread(cells, a), max[a] - min[a]));
    let axis = (1..3).fold(0, |best, a| if width[a] > width[best] { a } else { best });
    cells.sort_unstable_by_key(|c| (c.at[axis], c.at));
    let place = place(cells, axis, (share * count as f64) as u64);
    let (low, high) = cells.split_at_mut(place);
    split(low, most, share, take);
    split(high, most, share, take);
}

/// How far most of the points spread along an axis, in cells: strays would make long thin tiles.
fn spread(cells: &[Cell], axis: usize) -> u32 {
    let mut along: Vec<(u32, u64)> = cells.iter().map(|c| (c.at[axis], c.count)).collect();
    along.sort_unstable();
    let count: u64 = along.iter().map(|c| c.1).sum();
    let [low, high] = TAILS.map(|share| {
        let (mut below, wanted) = (0, (share * count as f64) as u64);
        along.iter().find(|c| {
            below += c.1;
            below > wanted
        })
    });
    high.zip(low).map_or(0, |(high, low)| high.0 - low.0)
}

/// Where to cut sorted cells between two of different coordinates, so that about `wanted` points lie below; the first of equals.
fn place(cells: &[Cell], axis: usize, wanted: u64) -> usize {
    let (mut below, mut best) = (0, (u64::MAX, 0));
    for (i, pair) in cells.windows(2).enumerate() {
        below += pair[0].count;
        if pair[0].at[axis] != pair[1].at[axis] && below.abs_diff(wanted) < best.0 {
            best = (below.abs_diff(wanted), i + 1);
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::Rng;

    /// Two dense balls, and a few points between and far from them.
    fn uneven() -> Vec<[f64; 3]> {
        let mut rng = Rng::new(5);
        let mut at = |c: f64, r: f64| [0; 3].map(|_: i32| c + r * (rng.uniform() - 0.5));
        let mut points: Vec<[f64; 3]> = (0..20_000).map(|_| at(0.0, 2.0)).collect();
        points.extend((0..5000).map(|_| at(9.0, 0.1)));
        points.extend((0..50).map(|_| at(5.0, 10.0)));
        points.push([-300.0, 4.0, 1.0]);
        points
    }

    #[test]
    fn every_point_has_one_owner_and_no_tile_more_points_than_allowed() {
        let points = uneven();
        let plan = Plan::new(&Histogram::of(&points, 1 << 14).unwrap(), 1000);
        let mut counts = vec![0; plan.tiles().len()];
        for &p in &points {
            let owners: Vec<usize> =
                (0..counts.len()).filter(|&t| plan.tiles()[t].owns(plan.grid.relative(p))).collect();
            assert_eq!(owners.len(), 1, "{p:?}");
            counts[owners[0]] += 1;
        }
        assert!(plan.tiles().iter().map(|t| t.count).eq(counts.iter().copied()));
        assert!(counts.iter().all(|&c| c <= 1000), "{counts:?}");
        assert!(counts.len() < 60, "{}", counts.len());
    }

    #[test]
    fn the_plan_depends_neither_on_the_order_of_the_points_nor_on_the_origin() {
        let mut points = uneven();
        let tiles =
            |points: &[[f64; 3]]| Plan::new(&Histogram::of(points, 4096).unwrap(), 3000).tiles().to_vec();
        let first = tiles(&points);
        points.reverse();
        points.rotate_left(777);
        assert_eq!(tiles(&points), first);
        // A translation that is exact in f64.
        let grid = |x: f64| (x * 1024.0).round() / 1024.0;
        let here: Vec<[f64; 3]> = points.iter().map(|p| p.map(grid)).collect();
        let there: Vec<[f64; 3]> = here.iter().map(|p| p.map(|x| x + 4096.0)).collect();
        assert_eq!(tiles(&here), tiles(&there));
    }

    #[test]
    fn points_that_fall_together_are_one_tile() {
        let plan = Plan::new(&Histogram::of(&[[2.0; 3]; 500], 64).unwrap(), 10);
        assert_eq!((plan.tiles().len(), plan.tiles()[0].count), (1, 500));
        assert_eq!(plan.corner(), [2.0; 3]);
        assert!(Plan::new(&Histogram::of(&[], 64).unwrap(), 10).tiles().is_empty());
    }
}
