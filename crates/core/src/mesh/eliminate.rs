//! Blue noise from random points: weighted sample elimination (Yuksel, "Sample elimination for generating Poisson disk sample
//! sets", 2015). The point most crowded by others goes, until as many are left as are wanted.
//!
//! Ours: points on faces turned away from each other do not crowd, so that both sides of a thin wall get theirs; and at the
//! start each cell of a fine grid keeps one point, so that faces that lie on each other do not pile up.

use rayon::prelude::*;
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

use super::scatter::Candidate;
use crate::math::vec3::distance2;
use crate::parallel;

/// Exponent of the weights, and what limits them (section 4.2: alpha, beta; gamma is 1.5).
const ALPHA: i32 = 8;
const BETA: f64 = 0.65;
/// Edge of the first grid's cells in `r_max`.
const CELL: f64 = 0.4;
/// Cosine between normals below which faces are turned away from each other.
const AWAY: f32 = -0.5;

/// The indices of at most `count` candidates, ascending: fewer where faces lie on each other. `area` is that of all faces.
pub(super) fn eliminate(candidates: &[Candidate], area: f64, count: usize) -> Vec<u32> {
    let r_max = (area / (2.0 * 3.0_f64.sqrt() * count as f64)).sqrt();
    let share = count as f64 / candidates.len().max(1) as f64;
    let r_min = r_max * (1.0 - share * share.sqrt()) * BETA;
    let grid = Grid::new(candidates, &one_a_cell(candidates, CELL * r_max), 2.0 * r_max, 2.0 * r_min);
    let mut kept = grid.thin(count);
    kept.sort_unstable();
    kept
}

/// Cells by their coordinates.
type Cell = [i64; 3];

fn cell(position: [f64; 3], edge: f64) -> Cell {
    position.map(|x| (x / edge).floor() as i64)
}

/// The first candidate of every cell.
fn one_a_cell(candidates: &[Candidate], edge: f64) -> Vec<u32> {
    let mut cells =
        parallel::map(candidates.len(), parallel::QUICK, |i| (cell(candidates[i].position, edge), i as u32));
    cells.par_sort_unstable();
    cells.dedup_by_key(|(cell, _)| *cell);
    cells.into_iter().map(|(_, i)| i).collect()
}

/// Candidates by cells as wide as the farthest that count as neighbours.
struct Grid<'a> {
    candidates: &'a [Candidate],
    /// Ascending.
    places: Vec<(Cell, u32)>,
    /// Distances at which weights end, and below which they grow no more.
    reach: f64,
    limit: f64,
}

impl<'a> Grid<'a> {
    fn new(candidates: &'a [Candidate], chosen: &[u32], reach: f64, limit: f64) -> Self {
        let place = |k: usize| (cell(candidates[chosen[k] as usize].position, reach), chosen[k]);
        let mut places = parallel::map(chosen.len(), parallel::QUICK, place);
        places.par_sort_unstable();
        Self { candidates, places, reach, limit }
    }

    /// Takes out the most crowded place until `count` are left; gives the candidates that stay.
    fn thin(&self, count: usize) -> Vec<u32> {
        let mut weights = parallel::map(self.places.len(), parallel::SLOW, |at| self.weight(at));
        let mut heap: BinaryHeap<Crowded> =
            weights.iter().zip(0..).map(|(&w, at)| Crowded(w, Reverse(at))).collect();
        let (mut stays, mut left) = (vec![true; self.places.len()], self.places.len());
        while left > count
            && let Some(Crowded(weight, Reverse(at))) = heap.pop()
        {
            // Weights only ever fall: an entry that is out of date goes back with the weight of now.
            if weight > weights[at] {
                heap.push(Crowded(weights[at], Reverse(at)));
                continue;
            }
            (stays[at], left) = (false, left - 1);
            self.neighbours(at, |other, weight| weights[other] -= weight);
        }
        (0..self.places.len()).filter(|&at| stays[at]).map(|at| self.places[at].1).collect()
    }

    fn weight(&self, at: usize) -> f64 {
        let mut sum = 0.0;
        self.neighbours(at, |_, weight| sum += weight);
        sum
    }

    /// Hands on the places that crowd one, each with its weight.
    fn neighbours(&self, at: usize, mut take: impl FnMut(usize, f64)) {
        let ([x, y, z], own) = self.places[at];
        let own = &self.candidates[own as usize];
        for (dx, dy) in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (dx, dy))) {
            let [from, to] = [z - 1, z + 1].map(|z| [x + dx, y + dy, z]);
            let first = self.places.partition_point(|(cell, _)| *cell < from);
            let row = self.places[first..].iter().take_while(|(cell, _)| *cell <= to);
            for (other, (_, i)) in row.enumerate().map(|(k, place)| (first + k, place)) {
                let next = &self.candidates[*i as usize];
                let apart = distance2(own.position, next.position);
                if other != at && apart < self.reach * self.reach && !turned_away(own, next) {
                    take(other, (1.0 - apart.sqrt().max(self.limit) / self.reach).powi(ALPHA));
                }
            }
        }
    }
}

fn turned_away(a: &Candidate, b: &Candidate) -> bool {
    (0..3).map(|k| a.normal[k] * b.normal[k]).sum::<f32>() < AWAY
}

/// A place by how crowded it is; of several as crowded the first comes out.
struct Crowded(f64, Reverse<usize>);

impl Ord for Crowded {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0).then(self.1.cmp(&other.1))
    }
}

impl PartialOrd for Crowded {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Crowded {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Crowded {}
