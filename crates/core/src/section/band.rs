//! The samples of each contour in their order along it: the band of points that an outline is drawn from.

use super::carry::Sample;
use super::chain::{Chain, NO_NODE};
use super::ruler::Ruler;
use super::tree::Tree;
use super::vec2::{along, cross, distance, dot, onto, sub, unit};
use std::ops::Range;

/// What an outline is drawn from of a sample, with its place along a contour.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark {
    /// Length along the contour's polyline to the foot of the sample.
    pub arc: f64,
    /// See [`Sample`].
    pub raw: [f64; 2],
    /// See [`Sample`].
    pub weight: f64,
    /// See [`Sample`].
    pub blur: f64,
    /// See [`Sample`].
    pub spacing: f64,
    /// How fast the wall moves to the right of the contour with growing height.
    pub growth: f64,
    /// The index of the sample.
    pub source: u32,
}

/// How fast a wall moves to the right of its contour with growing height.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Growth {
    /// The median along the contour.
    pub middle: f64,
    /// What nine tenths of the contour stay under, of either sign.
    pub most: f64,
}

fn quantile(values: &mut [f64], share: f64) -> f64 {
    let at = (values.len().saturating_sub(1) as f64 * share) as usize;
    if values.is_empty() { 0.0 } else { *values.select_nth_unstable_by(at, f64::total_cmp).1 }
}

/// A contour's polyline with its samples, ascending by arc.
#[derive(Clone, Debug)]
pub(crate) struct Band {
    /// The polyline the arcs run along.
    pub chain: Chain,
    /// Arc of each vertex.
    pub arcs: Vec<f64>,
    /// Length of the polyline, the closing segment included.
    pub length: f64,
    /// Ascending by arc, ties by source.
    pub marks: Vec<Mark>,
    vertex_ruler: Ruler,
    mark_ruler: Ruler,
    /// `(marks + 1)` sums of the blurs before each mark.
    blurs: Vec<f64>,
}

/// Gives every sample that is `free` to the nearest contour that runs its way; samples near none are left out.
///
/// `owners` has for each sample its node; where the contours are chains of nodes, those with a node there are placed beside
/// it, and only for the others, and those not close to it, all contours are looked along.
pub(crate) fn assign(samples: &[Sample], owners: &[u32], free: &[bool], chains: Vec<Chain>) -> Vec<Band> {
    let mut bands: Vec<Band> = chains.into_iter().map(empty).collect();
    let mut best = vec![Place { off: f64::INFINITY, band: 0, arc: 0.0, growth: 0.0 }; samples.len()];
    let seats = seats(&bands);
    let mut rest = Vec::new();
    for (i, place) in best.iter_mut().enumerate().filter(|(i, _)| free[*i]) {
        if let Some(&(b, v)) = seats.get(owners[i] as usize).filter(|seat| seat.0 != NO_BAND) {
            place.beside(&samples[i], b, &bands[b as usize], v as usize);
        }
        if place.off > SURE * samples[i].spacing {
            rest.push(i as u32);
        }
    }
    search(samples, &rest, &bands, &mut best);
    deal(samples, &best, &mut bands);
    bands
}

/// Samples this far from the contour beside their node, in spacings, may lie nearer to another stretch: at the tip of a
/// narrow wedge a node stands for both sides.
const SURE: f64 = 0.2;

/// For each node the band it is in and its vertex there.
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

/// The node is in no band.
const NO_BAND: u32 = u32::MAX;

/// Looks along all contours for some of the samples.
fn search(samples: &[Sample], wanted: &[u32], bands: &[Band], best: &mut [Place]) {
    let feet: Vec<[f64; 2]> = wanted.iter().map(|&i| samples[i as usize].foot).collect();
    if feet.is_empty() {
        return;
    }
    let (tree, mut found) = (Tree::new(&feet), Vec::new());
    for (b, band) in bands.iter().enumerate() {
        for v in 0..segments(band) {
            let (from, to) = segment(band, v);
            let (length, spacing) = (distance(from, to), band.chain.vertices[v].spacing);
            // Long segments are looked along in balls of a few spacings, not in one large one.
            let pieces = (length / (3.0 * spacing)).ceil().clamp(1.0, 1e6) as usize;
            for k in 0..pieces {
                let middle = along(from, sub(to, from), (k as f64 + 0.5) / pieces as f64);
                tree.within(middle, 0.5 * length / pieces as f64 + REACH * spacing, &mut found);
                for i in found.iter().map(|&k| wanted[k as usize] as usize) {
                    best[i].meet(&samples[i], b as u32, band.arcs[v], [from, to]);
                }
            }
        }
    }
}

/// How far from a contour samples are looked for, in its own spacings; each then has a say by its own.
const REACH: f64 = 1.5;

/// Where a sample lies along the nearest contour so far.
#[derive(Clone, Copy)]
struct Place {
    /// Distance from the contour, with a part for how much the two run apart: at the tip of a narrow wedge both sides
    /// are near.
    off: f64,
    band: u32,
    arc: f64,
    growth: f64,
}

/// Distance in spacings that counts like running across each other.
const ACROSS: f64 = 0.5;

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
                self.meet(sample, b, band.arcs[v], segment(band, v).into());
            }
        }
    }

    /// Takes a segment, which begins at `start` along its contour, if it is nearer and runs the sample's way.
    fn meet(&mut self, sample: &Sample, band: u32, start: f64, [from, to]: [[f64; 2]; 2]) {
        let (share, off) = onto(from, to, sample.foot);
        if off >= self.off || off > sample.spacing {
            return;
        }
        let direction = unit(sub(to, from));
        let off = off.hypot(ACROSS * sample.spacing * cross(direction, sample.tangent));
        if off < self.off && dot(direction, sample.tangent).abs() >= 0.6 {
            let growth = cross(sample.drift, direction);
            *self = Place { off, band, arc: start + share * distance(from, to), growth };
        }
    }
}

fn deal(samples: &[Sample], best: &[Place], bands: &mut [Band]) {
    // Arcs are not negative: their bits order as they do. Band, arc and index go into one number.
    let placed = best.iter().zip(0u32..).filter(|(place, _)| place.off.is_finite());
    let number =
        |(p, i): (&Place, u32)| u128::from(p.band) << 96 | u128::from(p.arc.to_bits()) << 32 | u128::from(i);
    let mut order: Vec<u128> = placed.map(number).collect();
    order.sort_unstable();
    for i in order.into_iter().map(|number| number as u32) {
        let (place, s) = (&best[i as usize], &samples[i as usize]);
        let Place { arc, growth, .. } = *place;
        let Sample { raw, weight, blur, spacing, .. } = *s;
        let mark = Mark { arc, raw, weight, blur, spacing, growth, source: i };
        bands[place.band as usize].marks.push(mark);
    }
    for band in bands {
        band.mark_ruler = Ruler::new(band.marks.iter().map(|m| m.arc), band.length);
        band.blurs.push(0.0);
        let sum = |sum: &mut f64, mark: &Mark| {
            *sum += mark.blur;
            Some(*sum)
        };
        band.blurs.extend(band.marks.iter().scan(0.0, sum));
    }
}

fn empty(chain: Chain) -> Band {
    let mut arcs = Vec::with_capacity(chain.vertices.len());
    let mut arc = 0.0;
    for (i, v) in chain.vertices.iter().enumerate() {
        if i > 0 {
            arc += distance(chain.vertices[i - 1].at, v.at);
        }
        arcs.push(arc);
    }
    let length = chain.length();
    let vertex_ruler = Ruler::new(arcs.iter().copied(), length);
    let (marks, blurs) = (Vec::new(), Vec::new());
    Band { chain, arcs, length, marks, vertex_ruler, mark_ruler: Ruler::default(), blurs }
}

/// The number of segments of a band's polyline.
pub(crate) fn segments(band: &Band) -> usize {
    let n = band.chain.vertices.len();
    if band.chain.closed { n } else { n.saturating_sub(1) }
}

/// The ends of a segment.
pub(crate) fn segment(band: &Band, v: usize) -> ([f64; 2], [f64; 2]) {
    let n = band.chain.vertices.len();
    (band.chain.vertices[v].at, band.chain.vertices[(v + 1) % n].at)
}

impl Band {
    /// What its marks say of the wall; all 0 for none.
    pub(crate) fn growth(&self) -> Growth {
        let mut all: Vec<f64> = self.marks.iter().map(|m| m.growth).collect();
        let middle = quantile(&mut all, 0.5);
        all.iter_mut().for_each(|g| *g = g.abs());
        Growth { middle, most: quantile(&mut all, 0.9) }
    }

    /// The last vertex that does not lie after an arc.
    pub(crate) fn vertex(&self, arc: f64) -> usize {
        self.vertex_ruler.first(arc, |v| self.arcs[v] <= arc).saturating_sub(1)
    }

    /// The point of the polyline at an arc; arcs of a closed band may run over its seam.
    pub(crate) fn at(&self, arc: f64) -> [f64; 2] {
        let inside = (0.0..self.length).contains(&arc) || !self.chain.closed || self.length <= 0.0;
        let arc = if inside { arc } else { arc.rem_euclid(self.length) };
        let last = segments(self).saturating_sub(1);
        let v = self.vertex(arc).min(last);
        let (from, to) = segment(self, v);
        let length = distance(from, to);
        let share = if length > 0.0 { ((arc - self.arcs[v]) / length).clamp(0.0, 1.0) } else { 0.0 };
        along(from, sub(to, from), share)
    }

    /// Calls `visit` with every mark in the arc range, as (arc unrolled over the seam of a closed band, mark).
    pub(crate) fn visit(&self, from: f64, to: f64, mut visit: impl FnMut(f64, &Mark)) {
        for (shift, range) in self.ranges(from, to) {
            self.marks[range].iter().for_each(|mark| visit(mark.arc + shift, mark));
        }
    }

    /// The mean blur of the marks in an arc range; 0 for none.
    pub(crate) fn blur(&self, from: f64, to: f64) -> f64 {
        let (mut sum, mut count) = (0.0, 0);
        for (_, range) in self.ranges(from, to) {
            sum += self.blurs[range.end] - self.blurs[range.start];
            count += range.len();
        }
        sum / count.max(1) as f64
    }

    /// The marks in an arc range, turn by turn of a closed band: what their arcs are shifted by, and their indices.
    fn ranges(&self, from: f64, to: f64) -> impl Iterator<Item = (f64, Range<usize>)> {
        let turns: &[f64] = if self.chain.closed { &[-1.0, 0.0, 1.0] } else { &[0.0] };
        let shifts = turns.iter().map(|turn| turn * self.length);
        let reached = shifts.filter(move |&shift| shift <= to && shift + self.length >= from);
        reached.map(move |shift| {
            let (first, last) = (from - shift, to - shift);
            let start = self.mark_ruler.first(first, |m| self.marks[m].arc < first);
            let within = self.marks[start..].iter().take_while(|m| m.arc <= last).count();
            (shift, start..start + within)
        })
    }
}
