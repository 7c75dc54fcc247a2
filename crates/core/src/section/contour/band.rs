//! The samples of each contour in their order along it: the band of points that an outline is drawn from.

use super::chain::Chain;
use crate::math::quantile::quantile;
use crate::math::ruler::Ruler;
use crate::math::vec2::{along, distance, sub, unit};
use std::ops::Range;

/// A sample as an outline is drawn from it, with its place along a contour.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark {
    /// Length along the contour's polyline to the foot of the sample.
    pub arc: f64,
    /// See [`Sample`](crate::section::surface::carry::Sample).
    pub raw: [f64; 2],
    /// See [`Sample`](crate::section::surface::carry::Sample).
    pub weight: f64,
    /// See [`Sample`](crate::section::surface::carry::Sample).
    pub blur: f64,
    /// See [`Sample`](crate::section::surface::carry::Sample).
    pub spacing: f64,
    /// Slope of the wall: its movement to the right of the contour with growing height.
    pub growth: f64,
    /// The index of the sample.
    pub source: u32,
}

/// The slope of a wall: its movement to the right of its contour with growing height.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Growth {
    /// The median along the contour.
    pub middle: f64,
    /// The quantile of nine tenths of its size along the contour.
    pub most: f64,
}

/// A contour's polyline with its samples, ascending by arc.
#[derive(Clone, Debug)]
pub(crate) struct Band {
    /// The polyline the arcs run along.
    pub chain: Chain,
    /// Arc of each vertex.
    pub arcs: Vec<f64>,
    /// Unit direction of each segment; zero for one without length.
    pub ways: Vec<[f64; 2]>,
    /// Length of the polyline, the closing segment included.
    pub length: f64,
    /// Ascending by arc, ties by source.
    pub marks: Vec<Mark>,
    vertex_ruler: Ruler,
    mark_ruler: Ruler,
    /// `(marks + 1)` sums of the blurs before each mark.
    blurs: Vec<f64>,
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
    /// A band without marks.
    pub(crate) fn new(chain: Chain) -> Self {
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
        let (ways, marks, blurs) = (Vec::new(), Vec::new(), vec![0.0]);
        let mut band =
            Self { chain, arcs, ways, length, marks, vertex_ruler, mark_ruler: Ruler::default(), blurs };
        let way = |v: usize| {
            let (from, to) = segment(&band, v);
            unit(sub(to, from))
        };
        band.ways = (0..segments(&band)).map(way).collect();
        band
    }

    /// Length of a segment.
    pub(crate) fn reach(&self, v: usize) -> f64 {
        self.arcs.get(v + 1).unwrap_or(&self.length) - self.arcs[v]
    }

    /// An arc of a closed band that may run over its seam, within the band.
    pub(crate) fn wrapped(&self, arc: f64) -> f64 {
        let inside = (0.0..self.length).contains(&arc) || !self.chain.closed || self.length <= 0.0;
        // Seldom needed, and slow.
        if inside { arc } else { arc.rem_euclid(self.length) }
    }

    /// Gives it its marks, ascending by arc.
    pub(crate) fn marked(mut self, marks: Vec<Mark>) -> Self {
        self.mark_ruler = Ruler::new(marks.iter().map(|m| m.arc), self.length);
        let sum = |sum: &mut f64, mark: &Mark| {
            *sum += mark.blur;
            Some(*sum)
        };
        self.blurs = std::iter::once(0.0).chain(marks.iter().scan(0.0, sum)).collect();
        self.marks = marks;
        self
    }

    /// The growth of the wall by its marks; all 0 for none.
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
        let arc = self.wrapped(arc);
        let Some(last) = self.ways.len().checked_sub(1) else { return self.chain.vertices[0].at };
        let v = self.vertex(arc).min(last);
        let ahead = (arc - self.arcs[v]).min(self.reach(v)).max(0.0);
        along(self.chain.vertices[v].at, self.ways[v], ahead)
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

    /// The marks in an arc range, turn by turn of a closed band: the shift of their arcs, and their indices.
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
