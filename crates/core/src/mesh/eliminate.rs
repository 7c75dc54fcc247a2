//! Blue noise from random points: weighted sample elimination (Yuksel, "Sample elimination for generating Poisson disk sample
//! sets", 2015). The point most crowded by others goes, until as many are left as are wanted.
//!
//! Ours: points on faces turned away from each other do not crowd, so that both sides of a thin wall get theirs; and at the
//! start each cell of a fine grid keeps one point, so that faces that lie on each other do not pile up.

use rayon::prelude::*;
use std::ops::Range;

use super::scatter::Candidate;
use crate::math::tournament::Tournament;
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
    let chosen = one_a_cell(candidates, CELL * r_max);
    let mut kept = Grid::new(candidates, &chosen, 2.0 * r_max, 2.0 * r_min).thin(count);
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

/// Candidates by cells as wide as the farthest that count as neighbours, in the order of the cells.
struct Grid {
    places: Vec<Place>,
    /// For each cell that holds places the stretches of `places` in and around it, a row of cells along z each.
    around: Vec<[Range<u32>; 9]>,
    /// Distances at which weights end, and below which they grow no more.
    reach: f64,
    limit: f64,
}

/// A candidate where its neighbours stand beside it in memory.
struct Place {
    position: [f64; 3],
    normal: [f32; 3],
    /// Its cell, counted along `around`, and its number among the candidates.
    cell: u32,
    candidate: u32,
}

impl Grid {
    fn new(candidates: &[Candidate], chosen: &[u32], reach: f64, limit: f64) -> Self {
        let place = |k: usize| (cell(candidates[chosen[k] as usize].position, reach), chosen[k]);
        let mut sorted: Vec<(Cell, u32)> = parallel::map(chosen.len(), parallel::QUICK, place);
        sorted.par_sort_unstable();
        let mut cells: Vec<(Cell, u32)> = sorted.iter().zip(0..).map(|(&(cell, _), at)| (cell, at)).collect();
        cells.dedup_by_key(|(cell, _)| *cell);
        let mut places: Vec<Place> = Vec::with_capacity(sorted.len());
        for (at, &(here, candidate)) in sorted.iter().enumerate() {
            let last = places.last().map_or(0, |p| p.cell + u32::from(sorted[at - 1].0 != here));
            let Candidate { position, normal } = candidates[candidate as usize];
            places.push(Place { position, normal, cell: last, candidate });
        }
        let end = sorted.len() as u32;
        let around = parallel::map(cells.len(), parallel::QUICK, |k| rows(&cells, cells[k].0, end));
        Self { places, around, reach, limit }
    }

    /// Takes out the most crowded place until `count` are left; gives the candidates that stay.
    fn thin(mut self, count: usize) -> Vec<u32> {
        let weights = parallel::map(self.places.len(), parallel::SLOW, |at| self.weight(at));
        let mut crowded = Tournament::new(weights);
        for _ in count..self.places.len() {
            let Some(at) = crowded.first() else { break };
            crowded.take_out(at);
            self.neighbours(at, |other, weight| crowded.lower(other, weight));
            // It crowds nobody any more: no distance to it is less than another.
            self.places[at].position = [f64::NAN; 3];
        }
        let stay = self.places.iter().zip(0..).filter(|&(_, at)| !crowded.is_out(at));
        stay.map(|(place, _)| place.candidate).collect()
    }

    fn weight(&self, at: usize) -> f64 {
        let mut sum = 0.0;
        self.neighbours(at, |_, weight| sum += weight);
        sum
    }

    /// Hands on the places that crowd one, each with its weight.
    fn neighbours(&self, at: usize, mut take: impl FnMut(usize, f64)) {
        let own = &self.places[at];
        for row in &self.around[own.cell as usize] {
            for other in row.start as usize..row.end as usize {
                let next = &self.places[other];
                let apart = distance2(own.position, next.position);
                if other != at && apart < self.reach * self.reach && !turned_away(own, next) {
                    take(other, (1.0 - apart.sqrt().max(self.limit) / self.reach).powi(ALPHA));
                }
            }
        }
    }
}

/// The stretches of places in the nine rows of three cells around one. `cells` has each cell with its first place; `end` is the
/// number of places.
fn rows(cells: &[(Cell, u32)], [x, y, z]: Cell, end: u32) -> [Range<u32>; 9] {
    let first = |from: Cell| cells.get(cells.partition_point(|(c, _)| *c < from)).map_or(end, |(_, at)| *at);
    std::array::from_fn(|k| {
        let (x, y) = (x - 1 + k as i64 / 3, y - 1 + k as i64 % 3);
        first([x, y, z - 1])..first([x, y, z + 2])
    })
}

fn turned_away(a: &Place, b: &Place) -> bool {
    (0..3).map(|k| a.normal[k] * b.normal[k]).sum::<f32>() < AWAY
}
