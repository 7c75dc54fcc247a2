//! A set of points of a tile with their lists of nearest neighbours: all of them, or those that the stage `surface` keeps.

use super::part::Part;
use super::plan::Plan;
use crate::frame::{BITS, Frame};
use crate::neighbors::{Neighbors, all_nearest, among, riemannian};
use crate::prepare::numbers;
use crate::reach::{Ground, Known};

/// The points in canonical order, local frame.
pub(super) struct Set {
    /// `(N, 3)` positions.
    pub(super) positions: Vec<[f64; 3]>,
    /// `(N)` index of each in the input.
    pub(super) source: Vec<u32>,
    /// `(N)` whether each is the tile's own.
    pub(super) owned: Vec<bool>,
    /// `(N)` distance up to which nothing is missing or in doubt.
    pub(super) room: Vec<f64>,
    /// Lists of the nearest neighbours, and where they are those of the whole cloud.
    pub(super) nearest: Neighbors,
    pub(super) lists: Known,
    k: usize,
}

impl Set {
    /// All points of a tile, with `k` neighbours each.
    pub(super) fn all(part: &Part, k: usize) -> Set {
        let nearest = all_nearest(&part.positions, k);
        let ground = Ground { points: &part.positions, room: part.room.clone() };
        let lists = ground.lists(&nearest, k);
        let Part { positions, source, owned, room, .. } = part;
        Set {
            positions: positions.clone(),
            source: source.clone(),
            owned: owned.clone(),
            room: room.clone(),
            nearest,
            lists,
            k,
        }
    }

    /// The positions with the room around each.
    pub(super) fn ground(&self) -> Ground<'_> {
        Ground { points: &self.positions, room: self.room.clone() }
    }

    /// The points that represent themselves; `known` says where that is known.
    pub(super) fn kept(self, stands: &[u32], known: &Known) -> Set {
        let number = numbers(stands);
        let blind: Vec<[f64; 3]> =
            self.positions.iter().zip(&known.0).filter(|(_, known)| !*known).map(|(p, _)| *p).collect();
        let stays = |i: usize| number[i] != u32::MAX;
        let positions: Vec<[f64; 3]> = left(&self.positions, stays);
        let room = self.ground().seen(&positions, left(&self.room, stays), &blind).room;
        let nearest = among(self.nearest, self.k, &number, &positions);
        let lists = Ground { points: &positions, room: room.clone() }.lists(&nearest, self.k);
        let (source, owned) = (left(&self.source, stays), left(&self.owned, stays));
        Set { positions, source, owned, room, nearest, lists, k: self.k }
    }

    /// Positions of own points whose neighbours are farther than the room around them.
    pub(super) fn lonely(&self) -> Vec<[f64; 3]> {
        self.own().filter(|&i| !self.lists.0[i]).map(|i| self.positions[i]).collect()
    }

    /// The neighbour graph, and where its rows are those of the whole cloud.
    pub(super) fn graph(&self) -> (Neighbors, Known) {
        let graph = riemannian::graph(&self.positions, &self.nearest);
        let rows = self.ground().rows(&self.nearest, &graph, self.k, &self.lists);
        (graph, rows)
    }

    /// The tile's own points.
    pub(super) fn own(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.owned.len()).filter(|&i| self.owned[i])
    }

    /// Whether a value is known at all own points.
    pub(super) fn is_known(&self, known: &Known) -> bool {
        self.own().all(|i| known.0[i])
    }

    /// The own points with their places in the canonical order of the whole cloud; `firsts` are those of the first points of the
    /// plan's cells.
    pub(super) fn ranks(&self, plan: &Plan, frame: Frame, firsts: &[usize]) -> Vec<(usize, usize)> {
        let (mut last, mut next) = (None, 0);
        let rank = |i: usize| {
            let cell = plan.cell(self.positions[i].map(|x| x * frame.scale));
            if last != Some(cell) {
                (last, next) = (Some(cell), firsts.get(cell).copied().unwrap_or(0));
            }
            next += 1;
            (i, next - 1)
        };
        self.own().map(rank).collect()
    }
}

fn left<T: Copy>(values: &[T], stays: impl Fn(usize) -> bool) -> Vec<T> {
    values.iter().enumerate().filter(|(i, _)| stays(*i)).map(|(_, v)| *v).collect()
}

impl Plan {
    /// The number of the occupied cell that holds a point, from the least corner of the cloud.
    pub(super) fn cell(&self, relative: [f64; 3]) -> usize {
        let code = self.grid.code(relative, 0) >> (3 * (BITS - self.level));
        self.codes.partition_point(|&c| c < code)
    }
}
