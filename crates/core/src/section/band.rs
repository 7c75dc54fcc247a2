//! The samples of each contour in their order along it: the band of points that an outline is drawn from.

use super::carry::Sample;
use super::link::Chain;
use super::tree::Tree;
use super::vec2::{along, distance, dot, onto, sub, unit};

/// A sample with its place along a contour.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark {
    /// Length along the contour's polyline to the foot of the sample.
    pub arc: f64,
    /// The sample.
    pub sample: Sample,
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
}

/// Gives every sample to the nearest contour that runs its way; samples nearer to none are left out.
pub(crate) fn assign(samples: &[Sample], chains: Vec<Chain>) -> Vec<Band> {
    let mut bands: Vec<Band> = chains.into_iter().map(empty).collect();
    let (mut places, mut owners) = (Vec::new(), Vec::new());
    for (b, band) in bands.iter().enumerate() {
        for v in 0..segments(band) {
            let (from, to) = segment(band, v);
            let pieces =
                (distance(from, to) / band.chain.vertices[v].spacing).ceil().clamp(1.0, 64.0) as usize;
            for k in 0..pieces {
                places.push(along(from, sub(to, from), (k as f64 + 0.5) / pieces as f64));
                owners.push((b as u32, v as u32));
            }
        }
    }
    let tree = Tree::new(&places);
    let mut best = Vec::new();
    for sample in samples {
        tree.nearest(sample.foot, 4, &mut best);
        let nearest = best.iter().filter_map(|&(_, i)| place(&bands, owners[i as usize], sample));
        let pick = nearest.min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        if let Some((b, _, arc)) = pick {
            bands[b as usize].marks.push(Mark { arc, sample: *sample });
        }
    }
    for band in &mut bands {
        band.marks.sort_by(|a, b| a.arc.total_cmp(&b.arc).then(a.sample.source.cmp(&b.sample.source)));
    }
    bands
}

fn place(bands: &[Band], (b, v): (u32, u32), sample: &Sample) -> Option<(u32, f64, f64)> {
    let band = &bands[b as usize];
    let (from, to) = segment(band, v as usize);
    let (share, off) = onto(from, to, sample.foot);
    let runs = dot(unit(sub(to, from)), sample.tangent).abs();
    if runs < 0.6 || off > sample.spacing {
        return None;
    }
    Some((b, off, band.arcs[v as usize] + share * distance(from, to)))
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
    Band { chain, arcs, length, marks: Vec::new() }
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
    /// The point of the polyline at an arc; arcs of a closed band may run over its seam.
    pub(crate) fn at(&self, arc: f64) -> [f64; 2] {
        let arc = if self.chain.closed && self.length > 0.0 { arc.rem_euclid(self.length) } else { arc };
        let last = segments(self).saturating_sub(1);
        let v = self.arcs.partition_point(|&a| a <= arc).saturating_sub(1).min(last);
        let (from, to) = segment(self, v);
        let length = distance(from, to);
        let share = if length > 0.0 { ((arc - self.arcs[v]) / length).clamp(0.0, 1.0) } else { 0.0 };
        along(from, sub(to, from), share)
    }

    /// Calls `visit` with every mark in the arc range, as (arc unrolled over the seam of a closed band, sample).
    pub(crate) fn visit(&self, from: f64, to: f64, mut visit: impl FnMut(f64, &Sample)) {
        let turns: &[f64] = if self.chain.closed { &[-1.0, 0.0, 1.0] } else { &[0.0] };
        for turn in turns {
            let shift = turn * self.length;
            let start = self.marks.partition_point(|m| m.arc + shift < from);
            for mark in self.marks[start..].iter().take_while(|m| m.arc + shift <= to) {
                visit(mark.arc + shift, &mark.sample);
            }
        }
    }
}
