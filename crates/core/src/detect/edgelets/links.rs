//! Neighbours within a cross-section and how unlikely each two are to lie on one smooth piece.

use super::section::{Across, WIDE};

/// Nearest neighbours to which a point is linked.
const NEAR: usize = 6;
/// Greatest length of a link, in spacings, to which the noise is added.
const FAR: f64 = 0.7;
/// Least distance ahead or behind of the nearest point of the next row, in spacings: rows of points may run along the line, and the
/// nearest neighbours are then all of one row.
const ROW: f64 = 0.3;
/// Offset of a neighbour from the tangent that counts nothing, in spacings, and the share of the noise added to it.
const FLAT: (f64, f64) = (0.1, 0.3);
/// Radians for a spacing of offset beyond it.
const OFFSET: f64 = 3.0;
/// Half the side of the square that the cells cover: places may lie a little outside of the section.
const HALF: f64 = WIDE + 0.8;

/// A pair of neighbours with the angle between their normals and the step between their tangents, in radians.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    pub(super) a: u32,
    pub(super) b: u32,
    pub(super) weight: f64,
}

/// Links of a section in ascending order of weight.
#[derive(Clone, Debug, Default)]
pub(super) struct Links {
    pub(super) all: Vec<Link>,
    cells: Cells,
    near: Vec<u64>,
    pairs: Vec<u64>,
}

impl Links {
    pub(super) fn find(&mut self, points: &[Across], noise: f64) {
        self.pair_up(points, FAR + noise);
        let Links { all, pairs, .. } = self;
        all.clear();
        all.extend(pairs.iter().map(|&pair| {
            let (a, b) = unpacked(pair);
            Link { a, b, weight: weight(&points[a as usize], &points[b as usize], noise) }
        }));
        // Keys of one word sort several times as fast as links.
        pairs.clear();
        pairs.extend(all.iter().zip(0..).map(|(link, i)| packed((link.weight as f32).to_bits(), i)));
        pairs.sort_unstable();
        let unsorted = std::mem::take(all);
        all.extend(pairs.iter().map(|&key| unsorted[unpacked(key).1 as usize]));
    }

    /// The pairs of each point and its nearest neighbours, each once.
    fn pair_up(&mut self, points: &[Across], far: f64) {
        let Links { cells, near, pairs, .. } = self;
        cells.fill(points, far);
        pairs.clear();
        for (i, p) in (0..).zip(points) {
            near.clear();
            let mut rows = [u64::MAX; 2];
            cells.around(p.place, |j| {
                let (along, off) = from_tangent(p, &points[j as usize]);
                let d2 = along * along + off * off;
                if j != i && d2 < far * far {
                    let key = packed((d2 as f32).to_bits(), j);
                    near.push(key);
                    if along.abs() > ROW.max(off.abs()) {
                        let row = &mut rows[usize::from(along > 0.0)];
                        *row = key.min(*row);
                    }
                }
            });
            if near.len() > NEAR {
                near.select_nth_unstable(NEAR);
                near.truncate(NEAR);
            }
            near.extend(rows.into_iter().filter(|&key| key != u64::MAX));
            pairs.extend(near.iter().map(|&key| unpacked(key).1).map(|j| packed(i.min(j), i.max(j))));
        }
        pairs.sort_unstable();
        pairs.dedup();
    }
}

/// How far `q` lies along the tangent at `p`, and off it.
fn from_tangent(p: &Across, q: &Across) -> (f64, f64) {
    let ([a, b], [x, y]) = (p.normal, [q.place[0] - p.place[0], q.place[1] - p.place[1]]);
    (x * b - y * a, x * a + y * b)
}

/// Two numbers in one, ordered by the first and then by the second.
fn packed(first: u32, second: u32) -> u64 {
    u64::from(first) << 32 | u64::from(second)
}

fn unpacked(key: u64) -> (u32, u32) {
    ((key >> 32) as u32, key as u32)
}

/// The angle between two normals and the step beyond what a bend by this angle explains.
fn weight(p: &Across, q: &Across, noise: f64) -> f64 {
    let step = [q.place[0] - p.place[0], q.place[1] - p.place[1]];
    let length = (step[0] * step[0] + step[1] * step[1]).sqrt();
    let along = |n: [f64; 2]| (n[0] * step[0] + n[1] * step[1]).abs();
    let off = along(p.normal).min(along(q.normal));
    let cosine = (p.normal[0] * q.normal[0] + p.normal[1] * q.normal[1]).abs().min(1.0);
    let half_sine = (0.5 * (1.0 - cosine)).sqrt();
    let (flat, noisy) = FLAT;
    cosine.acos() + OFFSET * (off - length * half_sine - flat - noisy * noise).max(0.0)
}

/// Points in square cells.
#[derive(Clone, Debug, Default)]
struct Cells {
    size: f64,
    wide: usize,
    first: Vec<u32>,
    order: Vec<u32>,
    of: Vec<u32>,
}

impl Cells {
    fn fill(&mut self, points: &[Across], size: f64) {
        self.size = size;
        self.wide = (2.0 * HALF / size).ceil() as usize + 1;
        self.first.clear();
        self.first.resize(self.wide * self.wide + 2, 0);
        let mut of = std::mem::take(&mut self.of);
        of.clear();
        of.extend(points.iter().map(|p| (self.line(p.place[1]) * self.wide + self.line(p.place[0])) as u32));
        self.of = of;
        // Counts two places on, so that after the points are laid out each cell's entry is its beginning.
        self.of.iter().for_each(|&c| self.first[c as usize + 2] += 1);
        (2..self.first.len()).for_each(|c| self.first[c] += self.first[c - 1]);
        self.order.clear();
        self.order.resize(points.len(), 0);
        for (i, &c) in self.of.iter().enumerate() {
            let next = &mut self.first[c as usize + 1];
            self.order[*next as usize] = i as u32;
            *next += 1;
        }
    }

    fn line(&self, x: f64) -> usize {
        (((x + HALF) / self.size).max(0.0) as usize).min(self.wide - 1)
    }

    fn around(&self, p: [f64; 2], mut take: impl FnMut(u32)) {
        let (x, y) = (self.line(p[0]), self.line(p[1]));
        for row in y.saturating_sub(1)..(y + 2).min(self.wide) {
            let from = self.first[row * self.wide + x.saturating_sub(1)] as usize;
            let to = self.first[row * self.wide + (x + 2).min(self.wide)] as usize;
            self.order[from..to].iter().for_each(|&j| take(j));
        }
    }
}
