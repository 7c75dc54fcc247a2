//! A cross-section cut to smooth pieces: grown along its links, merged as long as one parabola describes two of them as well as
//! two do, and settled point by point.

use super::links::{Link, Links};
use super::moments::{Moments, Parabola};
use super::section::{Across, Section};
use crate::math::union_find::UnionFind;

/// What a piece tolerates beyond its greatest link, in degrees, over its number of points: the constant of Felzenszwalb and
/// Huttenlocher (2004).
const GROWTH_DEG: f64 = 50.0;
/// Pieces of fewer points go to the piece beside them.
const SCRAPS: u32 = 5;
/// Deviation of a face from a parabola across the section, in spacings: standard deviation beside the noise.
const MODEL: f64 = 0.06;
/// Rounds in which each point goes to the piece that fits it best.
const SETTLING: usize = 2;
/// Weight of the squared sine between a point's normal and the piece's against squared offsets in standard deviations.
const NORMAL: f64 = 4.0;

/// A smooth piece of a section.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) curve: Parabola,
    pub(super) count: f64,
    /// Least and greatest coordinate along the axis.
    pub(super) extent: [f64; 2],
}

impl Piece {
    pub(super) fn length(&self) -> f64 {
        self.extent[1] - self.extent[0]
    }

    /// The distance of `p` from the piece, which ends where its points end.
    pub(super) fn offset(&self, p: [f64; 2]) -> f64 {
        let (off, gradient, u) = self.curve.value(p);
        let over = (u - self.extent[1]).max(self.extent[0] - u).max(0.0);
        (off / gradient[0].hypot(gradient[1])).hypot(over)
    }
}

/// The pieces of a section; a piece without a curve has too few points.
#[derive(Clone, Debug, Default)]
pub(super) struct Pieces {
    pub(super) all: Vec<Option<Piece>>,
    /// The piece of every point.
    pub(super) label: Vec<u32>,
    sums: Vec<Moments>,
    costs: Vec<f64>,
    pairs: Vec<Pair>,
    best: Vec<f64>,
    next: Vec<u32>,
}

/// Two pieces side by side and what merging them costs.
#[derive(Clone, Copy, Debug)]
struct Pair {
    a: u32,
    b: u32,
    loss: f64,
}

impl Pieces {
    /// Cuts a section; two pieces stay two if one parabola is worse by `evidence` (half of it is a log likelihood).
    pub(super) fn cut(&mut self, section: &Section, links: &Links, evidence: f64) {
        let points = &section.points;
        let variance = variance(section);
        self.grow(points.len(), &links.all);
        self.merge(points, &links.all, variance, evidence);
        for _ in 0..SETTLING {
            self.fit(points, variance);
            self.settle(points, &links.all, variance);
        }
        self.merge(points, &links.all, variance, evidence);
        self.fit(points, variance);
    }

    /// Joins points along links that are no worse than those within the pieces that they join.
    fn grow(&mut self, count: usize, links: &[Link]) {
        let growth = GROWTH_DEG.to_radians();
        let mut sets = UnionFind::new(count);
        let inner = &mut self.best;
        inner.clear();
        inner.resize(count, 0.0);
        for link in links {
            let (a, b) = (sets.find(link.a), sets.find(link.b));
            let limit = |r: u32, size: u32| inner[r as usize] + growth / f64::from(size);
            if a != b && link.weight <= limit(a, sets.size(a)).min(limit(b, sets.size(b))) {
                sets.union(a, b);
                inner[sets.find(a) as usize] = link.weight;
            }
        }
        for link in links {
            let (a, b) = (sets.find(link.a), sets.find(link.b));
            if a != b && sets.size(a).min(sets.size(b)) < SCRAPS {
                sets.union(a, b);
            }
        }
        self.label.clear();
        self.label.extend((0..count as u32).map(|i| sets.find(i)));
        self.renumber();
    }

    /// Labels without gaps, in the order of their first points.
    fn renumber(&mut self) {
        self.next.clear();
        self.next.resize(self.label.len().max(self.all.len()), u32::MAX);
        let mut count = 0;
        for label in &mut self.label {
            let new = &mut self.next[*label as usize];
            if *new == u32::MAX {
                *new = count;
                count += 1;
            }
            *label = *new;
        }
        self.all.clear();
        self.all.resize(count as usize, None);
    }

    fn sum(&mut self, points: &[Across]) {
        self.sums.clear();
        self.sums.resize(self.all.len(), Moments::default());
        for (p, &label) in points.iter().zip(&self.label) {
            self.sums[label as usize].add(p);
        }
    }

    /// Merges the two pieces that lose least, again and again, until any two would lose `evidence`.
    fn merge(&mut self, points: &[Across], links: &[Link], variance: f64, evidence: f64) {
        self.renumber();
        self.sum(points);
        let cost = |m: &Moments| m.fit(variance).map_or(f64::INFINITY, |p| p.cost);
        self.costs.clear();
        self.costs.extend(self.sums.iter().map(cost));
        self.pair_up(links);
        let loss = |sums: &[Moments], costs: &[f64], a: u32, b: u32| {
            let (a, b) = (a as usize, b as usize);
            cost(&sums[a].with(&sums[b])) - costs[a] - costs[b]
        };
        for pair in &mut self.pairs {
            pair.loss = loss(&self.sums, &self.costs, pair.a, pair.b);
        }
        let mut joined = UnionFind::new(self.all.len());
        let order = |x: &&Pair, y: &&Pair| x.loss.total_cmp(&y.loss).then((x.a, x.b).cmp(&(y.a, y.b)));
        while let Some(&Pair { a, b, loss: least }) = self.pairs.iter().min_by(order) {
            if least >= evidence {
                break;
            }
            joined.union(a, b);
            self.sums[a as usize] = self.sums[a as usize].with(&self.sums[b as usize]);
            self.costs[a as usize] = cost(&self.sums[a as usize]);
            self.unite(a, b);
            for pair in self.pairs.iter_mut().filter(|p| p.a == a || p.b == a) {
                pair.loss = loss(&self.sums, &self.costs, pair.a, pair.b);
            }
        }
        self.label.iter_mut().for_each(|label| *label = joined.find(*label));
        self.renumber();
    }

    /// Pairs of pieces with a link between them.
    fn pair_up(&mut self, links: &[Link]) {
        let label = |i: u32| self.label[i as usize];
        self.pairs.clear();
        self.pairs.extend(links.iter().filter_map(|l| {
            let (a, b) = (label(l.a), label(l.b));
            (a != b).then(|| Pair { a: a.min(b), b: a.max(b), loss: 0.0 })
        }));
        self.pairs.sort_unstable_by_key(|p| (p.a, p.b));
        self.pairs.dedup_by_key(|p| (p.a, p.b));
    }

    /// Piece `b` is now part of `a`.
    fn unite(&mut self, a: u32, b: u32) {
        for pair in &mut self.pairs {
            for end in [&mut pair.a, &mut pair.b] {
                if *end == b {
                    *end = a;
                }
            }
            (pair.a, pair.b) = (pair.a.min(pair.b), pair.a.max(pair.b));
        }
        self.pairs.retain(|p| p.a != p.b);
        self.pairs.sort_unstable_by_key(|p| (p.a, p.b));
        self.pairs.dedup_by_key(|p| (p.a, p.b));
    }

    /// How much worse one parabola describes two pieces than two do.
    pub(super) fn loss(&self, (a, b): (u32, u32), variance: f64) -> f64 {
        let both = self.sums[a as usize].with(&self.sums[b as usize]);
        cost(&both, variance) - self.cost((a, b), variance)
    }

    /// The sum of squares of two pieces about their parabolas over the variance.
    pub(super) fn cost(&self, (a, b): (u32, u32), variance: f64) -> f64 {
        cost(&self.sums[a as usize], variance) + cost(&self.sums[b as usize], variance)
    }

    fn fit(&mut self, points: &[Across], variance: f64) {
        self.sum(points);
        for (piece, sums) in self.all.iter_mut().zip(&self.sums) {
            let ends = [f64::INFINITY, f64::NEG_INFINITY];
            *piece = sums.fit(variance).map(|curve| Piece { curve, count: sums.count(), extent: ends });
        }
        for (p, &label) in points.iter().zip(&self.label) {
            if let Some(piece) = &mut self.all[label as usize] {
                let [a, b] = piece.curve.axis;
                let u = a * p.raw[0] + b * p.raw[1];
                piece.extent = [piece.extent[0].min(u), piece.extent[1].max(u)];
            }
        }
    }

    /// Gives every point to the piece that fits it best of its own and those of its links.
    fn settle(&mut self, points: &[Across], links: &[Link], variance: f64) {
        let misfit = |i: usize, label: u32| {
            let Some(piece) = &self.all[label as usize] else { return f64::INFINITY };
            let p = &points[i];
            let off = piece.offset(p.raw);
            let (_, g, _) = piece.curve.value(p.raw);
            let cosine = (g[0] * p.normal[0] + g[1] * p.normal[1]) / g[0].hypot(g[1]);
            off * off / variance + NORMAL * (1.0 - cosine * cosine)
        };
        self.best.clear();
        self.best.resize(points.len(), f64::INFINITY);
        self.next.clear();
        self.next.extend_from_slice(&self.label);
        for link in links {
            let (a, b) = (link.a as usize, link.b as usize);
            if self.label[a] == self.label[b] {
                continue;
            }
            for (i, other) in [(a, self.label[b]), (b, self.label[a])] {
                if self.best[i] == f64::INFINITY {
                    self.best[i] = misfit(i, self.label[i]);
                }
                let off = misfit(i, other);
                if off < self.best[i] || (off == self.best[i] && other < self.next[i]) {
                    self.best[i] = off;
                    self.next[i] = other;
                }
            }
        }
        self.label.copy_from_slice(&self.next);
    }
}

/// Where the curves of two pieces meet near a place, by Newton's method.
pub(super) fn meet(a: &Piece, b: &Piece, start: [f64; 2]) -> Option<[f64; 2]> {
    let mut p = start;
    for _ in 0..6 {
        let ((fa, ga, _), (fb, gb, _)) = (a.curve.value(p), b.curve.value(p));
        let det = ga[0] * gb[1] - ga[1] * gb[0];
        if det.abs() < 0.1 * ga[0].hypot(ga[1]) * gb[0].hypot(gb[1]) {
            return None;
        }
        p = [p[0] - (fa * gb[1] - fb * ga[1]) / det, p[1] - (ga[0] * fb - gb[0] * fa) / det];
        if (p[0] - start[0]).hypot(p[1] - start[1]) > 4.0 {
            return None;
        }
    }
    Some(p)
}

/// The sum of squares of points about their parabola over the variance; infinite without one.
fn cost(sums: &Moments, variance: f64) -> f64 {
    sums.fit(variance).map_or(f64::INFINITY, |p| p.cost)
}

/// The variance of a point across the surface, squared spacings.
pub(super) fn variance(section: &Section) -> f64 {
    section.noise * section.noise + MODEL * MODEL
}
