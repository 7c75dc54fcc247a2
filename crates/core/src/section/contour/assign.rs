//! Region assignment (Kyriazis et al., section 3, figure 5): the contour to which each sample belongs, and its place along it.
//!
//! The paper avoids false assignments, as of a sample near the opposite side of a thin wall, by the regions of its neighbours.
//! Here each sample carries the tangent of its own neighbourhood, and it is assigned to the nearest contour that runs in this
//! direction, not simply to the nearest. `outline/regions.rs` then cuts the samples of a contour into regions by their order.

use std::ops::Range;

use super::band::{Band, Mark, segments};
use super::chain::{Chain, NO_NODE};
use crate::math::counting_sort::dealt;
use crate::math::trees::packed::Packed;
use crate::math::vec2::{along, cross, dot, sub};
use crate::section::surface::carry::Sample;

/// Distance of a sample from the contour at its node up to which no other stretch is tried, spacings: at the tip of a narrow
/// wedge one node represents both sides.
const SURE_DISTANCE: f64 = 0.2;
/// The band of a node that is in none.
const NO_BAND: u32 = u32::MAX;
/// Number of segments that are first searched together.
const STRETCH: usize = 16;
/// Greatest distance from a contour at which samples are searched, in the contour's spacings; the sample's own spacing decides
/// then.
const SEARCH_REACH: f64 = 1.5;
/// Distance that counts as much as directions at right angles, spacings.
const ACROSS_COST: f64 = 0.5;

/// Assigns every sample that is `free` to the nearest contour that runs in its direction; samples near none are left out.
///
/// `owners` is the node of each sample. If that node is on a contour, the sample is placed beside it; only the other samples, and
/// those not close to their node's contour, are searched along all contours.
pub(crate) fn assign(samples: &[Sample], owners: &[u32], free: &[bool], chains: Vec<Chain>) -> Vec<Band> {
    let bands: Vec<Band> = chains.into_iter().map(Band::new).collect();
    let mut best = vec![Place { off: f64::INFINITY, band: 0, arc: 0.0, growth: 0.0 }; samples.len()];
    let seats = seats(&bands);
    let mut rest = Vec::new();
    for (i, place) in best.iter_mut().enumerate().filter(|(i, _)| free[*i]) {
        if let Some(&(b, v)) = seats.get(owners[i] as usize).filter(|seat| seat.0 != NO_BAND) {
            place.beside(&samples[i], b, &bands[b as usize], v as usize);
        }
        if place.off > SURE_DISTANCE * samples[i].spacing {
            rest.push(i as u32);
        }
    }
    search(samples, &rest, &bands, &mut best);
    let marks = marks(samples, &best, &bands);
    bands.into_iter().zip(marks).map(|(band, marks)| band.marked(marks)).collect()
}

/// The band of each node and its vertex there.
fn seats(bands: &[Band]) -> Vec<(u32, u32)> {
    let mut seats = Vec::new();
    for (b, band) in (0u32..).zip(bands) {
        for (v, vertex) in (0u32..).zip(&band.chain.vertices).filter(|(_, vertex)| vertex.node != NO_NODE) {
            let node = vertex.node as usize;
            seats.resize(seats.len().max(node + 1), (NO_BAND, 0));
            seats[node] = (b, v);
        }
    }
    seats
}

/// Searches along all contours for the `wanted` samples.
fn search(samples: &[Sample], wanted: &[u32], bands: &[Band], best: &mut [Place]) {
    let feet: Vec<[f64; 2]> = wanted.iter().map(|&i| samples[i as usize].foot).collect();
    if feet.is_empty() {
        return;
    }
    let (tree, mut found) = (Packed::new(&feet), Vec::new());
    for (b, band) in bands.iter().enumerate() {
        let all = segments(band);
        for first in (0..all).step_by(STRETCH) {
            let stretch = first..(first + STRETCH).min(all);
            // Wanted samples are few and close together: most stretches have none.
            let (centre, radius) = around(band, stretch.clone());
            if tree.any(centre, radius) {
                for v in stretch {
                    near(band, v, &tree, &mut found, |k| {
                        let i = wanted[k as usize] as usize;
                        best[i].meet(&samples[i], b as u32, band, v);
                    });
                }
            }
        }
    }
}

/// A ball that holds everything near some segments of a band.
fn around(band: &Band, stretch: Range<usize>) -> ([f64; 2], f64) {
    let from = band.chain.vertices[stretch.start].at;
    let length: f64 = stretch.clone().map(|v| band.reach(v)).sum();
    let widest = stretch.map(|v| band.chain.vertices[v].spacing).fold(0.0, f64::max);
    (from, length + SEARCH_REACH * widest)
}

/// Visits the samples near a segment of a band, in balls of a few spacings along it rather than in one large ball.
fn near(band: &Band, v: usize, tree: &Packed, found: &mut Vec<u32>, mut visit: impl FnMut(u32)) {
    let (from, way, length) = (band.chain.vertices[v].at, band.ways[v], band.reach(v));
    let spacing = band.chain.vertices[v].spacing;
    let pieces = (length / (3.0 * spacing)).ceil().clamp(1.0, 1e6) as usize;
    for k in 0..pieces {
        let middle = along(from, way, length * (k as f64 + 0.5) / pieces as f64);
        tree.within(middle, 0.5 * length / pieces as f64 + SEARCH_REACH * spacing, found);
        found.iter().for_each(|&k| visit(k));
    }
}

/// The place of a sample along the best contour so far.
#[derive(Clone, Copy)]
struct Place {
    /// Distance from the contour, with a part for the difference of directions: at the tip of a narrow wedge both sides are
    /// near.
    off: f64,
    band: u32,
    arc: f64,
    growth: f64,
}

impl Place {
    /// Takes the nearest of the four segments around a vertex.
    fn beside(&mut self, sample: &Sample, b: u32, band: &Band, vertex: usize) {
        let n = segments(band);
        for step in 0..4 {
            let v = if band.chain.closed {
                Some((vertex + 2 * n + step - 2) % n)
            } else {
                (vertex + step).checked_sub(2)
            };
            if let Some(v) = v.filter(|&v| v < n) {
                self.meet(sample, b, band, v);
            }
        }
    }

    /// Takes a segment of the band `b` if it is nearer and runs in the sample's direction.
    fn meet(&mut self, sample: &Sample, b: u32, band: &Band, v: usize) {
        let (from, way) = (band.chain.vertices[v].at, band.ways[v]);
        let apart = sub(sample.foot, from);
        let ahead = dot(apart, way).min(band.reach(v)).max(0.0);
        let gap = along(apart, way, -ahead);
        let off2 = dot(gap, gap);
        if off2 >= self.off * self.off || off2 > sample.spacing * sample.spacing {
            return;
        }
        let across = ACROSS_COST * sample.spacing * cross(way, sample.tangent);
        let off = (off2 + across * across).sqrt();
        if off < self.off && dot(way, sample.tangent).abs() >= 0.6 {
            *self = Place { off, band: b, arc: band.arcs[v] + ahead, growth: cross(sample.drift, way) };
        }
    }
}

/// The marks of each band, ascending by arc, ties by source.
fn marks(samples: &[Sample], best: &[Place], bands: &[Band]) -> Vec<Vec<Mark>> {
    let placed: Vec<u32> = (0..best.len() as u32).filter(|&i| best[i as usize].off.is_finite()).collect();
    let places = || placed.iter().map(|&i| &best[i as usize]);
    let mut counts = vec![0u32; bands.len()];
    places().for_each(|p| counts[p.band as usize] += 1);
    // As many cells along each band as it has samples: those in one cell are sorted, the rest are in order by their cells.
    let firsts = counts.iter().scan(0, |sum, &count| Some(std::mem::replace(sum, *sum + count)));
    let per_length = |(band, &count): (&Band, &u32)| f64::from(count) / band.length.max(f64::MIN_POSITIVE);
    let rows: Vec<(u32, f64)> = firsts.zip(bands.iter().zip(&counts).map(per_length)).collect();
    let cell = |p: &Place| {
        let (first, per_length) = rows[p.band as usize];
        first + ((p.arc * per_length) as u32).min(counts[p.band as usize] - 1)
    };
    let (mut order, starts) = dealt(&places().map(cell).collect::<Vec<u32>>());
    for cell in starts.windows(2).map(|w| w[0] as usize..w[1] as usize).filter(|cell| cell.len() > 1) {
        let arc = |&k: &u32| best[placed[k as usize] as usize].arc;
        order[cell].sort_unstable_by(|a, b| arc(a).total_cmp(&arc(b)).then(a.cmp(b)));
    }
    let mut marks: Vec<Vec<Mark>> = counts.iter().map(|&count| Vec::with_capacity(count as usize)).collect();
    for source in order.into_iter().map(|k| placed[k as usize]) {
        let Place { band, arc, growth, .. } = best[source as usize];
        let Sample { raw, weight, blur, spacing, .. } = samples[source as usize];
        marks[band as usize].push(Mark { arc, raw, weight, blur, spacing, growth, source });
    }
    marks
}
