//! The data of a contour that curves are fitted to: its samples in their order, taken together in blocks of half a spacing.

use crate::curve::moments::Squares;
use crate::curve::pieces::search::Row;
use crate::curve::planar::PlaneMoments;
use crate::math::quantile::quantile;

/// One place on the contour.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Datum {
    /// Position in the slicing plane.
    pub at: [f64; 2],
    /// Weight, inverse to the square of its error.
    pub weight: f64,
    /// Length along the outline to its foot there.
    pub arc: f64,
}

/// Length of a block, spacings.
const BLOCK: f64 = 0.5;
/// Blocks in a window of which the error is taken.
const WINDOW: usize = 8;
/// Share of the windows whose error is less than that of the data: the others may hold corners.
const CALM: f64 = 0.3;
/// Least error of a datum, spacings: the tangent planes, and the tiles that share one, are no better.
const LEAST_ERROR: f64 = 0.03;

/// The data of a contour in blocks.
#[derive(Clone, Debug)]
pub(super) struct Blocks {
    /// In order along the contour, with a mean weight of 1.
    pub data: Vec<Datum>,
    /// The first datum of each block, and the number of data.
    pub starts: Vec<usize>,
    /// The sums over each block.
    pub sums: Vec<PlaneMoments>,
}

impl Blocks {
    /// Of data in order along the outline, whose corners lie at ascending arcs.
    pub(super) fn new(data: Vec<Datum>, spacing: f64, corners: &[f64]) -> Self {
        let mut starts: Vec<usize> = Vec::new();
        let (mut end, mut corners) = (f64::NEG_INFINITY, corners.iter().peekable());
        for (k, datum) in data.iter().enumerate() {
            let mut corner = false;
            while corners.next_if(|&&c| c <= datum.arc).is_some() {
                corner = true;
            }
            if corner || datum.arc >= end {
                starts.push(k);
                end = datum.arc + BLOCK * spacing;
            }
        }
        starts.push(data.len());
        let sum = |w: &[usize]| {
            let mut sum = PlaneMoments::at(data[w[0]].at);
            data[w[0]..w[1]].iter().for_each(|d| sum.push(d.at, d.weight));
            sum
        };
        let sums = starts.windows(2).map(sum).collect();
        Self { data, starts, sums }
    }

    /// The same ring of data, beginning at a block.
    pub(super) fn turned(&self, block: usize) -> Self {
        let first = self.starts[block];
        let n = self.data.len();
        let turned = |k: usize| self.starts[block..].iter().take(k).copied();
        let blocks = self.sums.len();
        let mut starts: Vec<usize> = turned(blocks - block).map(|s| s - first).collect();
        starts.extend(self.starts[..block].iter().map(|s| s + n - first));
        starts.push(n);
        let mut data = self.data.clone();
        data.rotate_left(first);
        let mut sums = self.sums.clone();
        sums.rotate_left(block);
        Self { data, starts, sums }
    }

    /// The sums over some blocks.
    pub(super) fn sum(&self, first: usize, last: usize) -> PlaneMoments {
        let mut sum = self.sums[first];
        self.sums[first + 1..last].iter().for_each(|s| sum.add(s));
        sum
    }

    /// The sums over the data `first..last`.
    pub(super) fn of(&self, first: usize, last: usize) -> PlaneMoments {
        let mut sum = PlaneMoments::at(self.data[first].at);
        self.data[first..last].iter().for_each(|d| sum.push(d.at, d.weight));
        sum
    }

    /// The sums over the blocks within the data `first..last`, those at the ends in part.
    pub(super) fn within(&self, first: usize, last: usize) -> Vec<PlaneMoments> {
        let inner = self.starts.iter().copied().filter(|s| (first + 1..last).contains(s));
        let starts: Vec<usize> = std::iter::once(first).chain(inner).chain([last]).collect();
        starts.windows(2).map(|w| self.of(w[0], w[1])).collect()
    }

    /// The standard deviation of a datum of weight 1 from lines and arcs over a few spacings.
    pub(super) fn error(&self, spacing: f64) -> f64 {
        let window = WINDOW.min(self.sums.len());
        let variance = |first: usize| {
            let sum = self.sum(first, first + window);
            let count = self.starts[first + window] - self.starts[first];
            let Squares { line, circle } = sum.squares();
            let freedom = |parameters: f64| (count as f64 - parameters).max(1.0);
            (line / freedom(2.0)).min(circle / freedom(3.0))
        };
        let mut all: Vec<f64> = (0..=self.sums.len() - window).map(variance).collect();
        quantile(&mut all, CALM).max(0.0).sqrt().max(LEAST_ERROR * spacing)
    }
}

impl Row for Blocks {
    type Sum = PlaneMoments;

    fn last(&self) -> usize {
        self.sums.len()
    }

    fn block(&self, k: usize) -> PlaneMoments {
        self.sums[k]
    }

    fn empty(&self, k: usize) -> PlaneMoments {
        PlaneMoments::at(self.data[self.starts[k]].at)
    }

    fn add(&self, sum: &mut PlaneMoments, other: &PlaneMoments) {
        sum.add(other);
    }

    fn push(&self, sum: &mut PlaneMoments, k: usize) {
        sum.add(&self.sums[k]);
    }

    fn close(&self, _: &mut PlaneMoments, _: usize) {}

    fn squares(&self, sum: &PlaneMoments) -> Squares {
        sum.squares()
    }
}
