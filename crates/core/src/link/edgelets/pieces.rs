//! Smooth pieces of a cross-section and the corners between them.

use super::knobs;
use super::moments::{Moments, Parabola};
use super::section::{Across, Section};
use crate::math::union_find::UnionFind;
use crate::math::vec3::add_scaled;

type P2 = [f64; 2];

fn sub(a: P2, b: P2) -> P2 {
    [a[0] - b[0], a[1] - b[1]]
}
fn dot(a: P2, b: P2) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}
fn norm(a: P2) -> f64 {
    dot(a, a).sqrt()
}

/// A corner of a cross-section in space.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edgelet {
    pub(super) place: [f64; 3],
    pub(super) along: [f64; 3],
    /// Directions of both faces away from the edge.
    pub(super) arms: [[f64; 3]; 2],
    pub(super) weight: f64,
}

/// `y = c0 + c1 x + c2 x^2` over an axis.
#[derive(Clone, Copy)]
struct Curve {
    axis: P2,
    c: [f64; 3],
    count: f64,
    extent: [f64; 2],
}

impl Curve {
    fn fit(points: &[Across], of: &[u32], variance: f64) -> Option<Curve> {
        let mut moments = Moments::default();
        of.iter().for_each(|&i| moments.add(&points[i as usize]));
        let Parabola { axis, c, .. } = moments.fit(variance)?;
        let mut extent = [f64::INFINITY, f64::NEG_INFINITY];
        for &i in of {
            let x = dot(points[i as usize].raw, axis);
            extent = [extent[0].min(x), extent[1].max(x)];
        }
        Some(Curve { axis, c, count: of.len() as f64, extent })
    }

    fn value(&self, p: P2) -> (f64, P2, f64) {
        let (x, y) = (dot(p, self.axis), self.axis[0] * p[1] - self.axis[1] * p[0]);
        let slope = self.c[1] + 2.0 * self.c[2] * x;
        let f = y - self.c[0] - self.c[1] * x - self.c[2] * x * x;
        // Gradient: the left normal less the slope along the axis.
        let g = [-self.axis[1] - slope * self.axis[0], self.axis[0] - slope * self.axis[1]];
        (f, g, x)
    }

    fn offset(&self, p: P2) -> f64 {
        let (f, g, x) = self.value(p);
        let over = (x - self.extent[1]).max(self.extent[0] - x).max(0.0);
        (f / norm(g)).hypot(over)
    }

    fn length(&self) -> f64 {
        self.extent[1] - self.extent[0]
    }

    /// The unit direction at `p` towards the middle of the piece.
    fn arm(&self, p: P2) -> P2 {
        let (_, g, x) = self.value(p);
        let t = [g[1], -g[0]];
        let n = norm(t).max(1e-12);
        let ahead = 0.5 * (self.extent[0] + self.extent[1]) > x;
        let sign = if (dot(t, self.axis) > 0.0) == ahead { 1.0 } else { -1.0 };
        [sign * t[0] / n, sign * t[1] / n]
    }
}

fn meet(a: &Curve, b: &Curve, start: P2) -> Option<P2> {
    let mut p = start;
    for _ in 0..6 {
        let ((fa, ga, _), (fb, gb, _)) = (a.value(p), b.value(p));
        let det = ga[0] * gb[1] - ga[1] * gb[0];
        if det.abs() < 0.1 * norm(ga) * norm(gb) {
            return None;
        }
        p = [p[0] - (fa * gb[1] - fb * ga[1]) / det, p[1] - (ga[0] * fb - gb[0] * fa) / det];
        if norm(sub(p, start)) > 4.0 {
            return None;
        }
    }
    Some(p)
}

struct Link {
    a: u32,
    b: u32,
    weight: f64,
}

const NEAR: usize = 6;

/// Points of a section in square cells.
struct Cells {
    size: f64,
    wide: usize,
    first: Vec<u32>,
    order: Vec<u32>,
}

const HALF_WIDTH: f64 = 5.0;

impl Cells {
    fn new(points: &[Across], size: f64) -> Cells {
        let wide = (2.0 * HALF_WIDTH / size).ceil() as usize + 1;
        let mut cells = Cells { size, wide, first: vec![0; wide * wide + 1], order: vec![0; points.len()] };
        let of: Vec<usize> = points.iter().map(|p| cells.row(p.place[1]) * wide + cells.row(p.place[0])).collect();
        of.iter().for_each(|&c| cells.first[c + 1] += 1);
        (0..wide * wide).for_each(|c| cells.first[c + 1] += cells.first[c]);
        let mut next = cells.first.clone();
        for (i, &c) in of.iter().enumerate() {
            cells.order[next[c] as usize] = i as u32;
            next[c] += 1;
        }
        cells
    }

    fn row(&self, x: f64) -> usize {
        (((x + HALF_WIDTH) / self.size).max(0.0) as usize).min(self.wide - 1)
    }

    fn near(&self, p: P2) -> impl Iterator<Item = usize> + '_ {
        let (x, y) = (self.row(p[0]), self.row(p[1]));
        (y.saturating_sub(1)..(y + 2).min(self.wide)).flat_map(move |r| {
            let from = self.first[r * self.wide + x.saturating_sub(1)] as usize;
            let to = self.first[r * self.wide + (x + 2).min(self.wide)] as usize;
            self.order[from..to].iter().map(|&i| i as usize)
        })
    }
}

fn links(points: &[Across], noise: f64) -> Vec<Link> {
    let farthest = 0.7 + noise;
    let cells = Cells::new(points, farthest);
    let mut links = Vec::with_capacity(points.len() * NEAR);
    let mut near: Vec<(f64, usize)> = Vec::new();
    for i in 0..points.len() {
        near.clear();
        for j in cells.near(points[i].place) {
            let d = sub(points[i].place, points[j].place);
            let d2 = dot(d, d);
            if j != i && d2 < farthest * farthest {
                near.push((d2, j));
            }
        }
        let order = |x: &(f64, usize), y: &(f64, usize)| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1));
        if near.len() > NEAR {
            near.select_nth_unstable_by(NEAR, order);
            near.truncate(NEAR);
        }
        for &(d2, j) in &near {
            let d = d2.sqrt();
            let (p, q) = (&points[i], &points[j]);
            let step = sub(q.place, p.place);
            let off = dot(p.normal, step).abs().min(dot(q.normal, step).abs());
            let angle = dot(p.normal, q.normal).abs().min(1.0).acos();
            let over = (off - d * (0.5 * angle).sin() - 0.1 - 0.3 * noise).max(0.0);
            links.push(Link { a: i.min(j) as u32, b: i.max(j) as u32, weight: angle + 3.0 * over });
        }
    }
    links.sort_unstable_by(|x, y| x.weight.total_cmp(&y.weight).then((x.a, x.b).cmp(&(y.a, y.b))));
    links.dedup_by(|x, y| (x.a, x.b) == (y.a, y.b));
    links
}

fn grow(points: usize, links: &[Link]) -> Vec<u32> {
    let growth = knobs().growth.to_radians();
    let mut sets = UnionFind::new(points);
    let mut inner = vec![0.0; points];
    for l in links {
        let (a, b) = (sets.find(l.a), sets.find(l.b));
        if a == b {
            continue;
        }
        let limit = |r: u32, s: u32| inner[r as usize] + growth / f64::from(s);
        let (sa, sb) = (sets.size(a), sets.size(b));
        if l.weight <= limit(a, sa).min(limit(b, sb)) {
            sets.union(a, b);
            let r = sets.find(a);
            inner[r as usize] = l.weight;
        }
    }
    for l in links {
        let (a, b) = (sets.find(l.a), sets.find(l.b));
        if a != b && sets.size(a).min(sets.size(b)) < 5 {
            sets.union(a, b);
        }
    }
    (0..points as u32).map(|i| sets.find(i)).collect()
}

fn members(label: &[u32]) -> Vec<(u32, Vec<u32>)> {
    let mut order: Vec<u32> = (0..label.len() as u32).collect();
    order.sort_by_key(|&i| (label[i as usize], i));
    order.chunk_by(|&a, &b| label[a as usize] == label[b as usize]).map(|c| (label[c[0] as usize], c.to_vec())).collect()
}

/// Merges pieces as long as one curve describes two of them as well as two do.
fn merge(points: &[Across], links: &[Link], label: &mut [u32], variance: f64) {
    let limit = knobs().piece;
    let pieces = members(label);
    let mut of = vec![0u32; label.len()];
    let mut sets: Vec<Vec<u32>> = Vec::with_capacity(pieces.len());
    for (k, (_, list)) in pieces.into_iter().enumerate() {
        list.iter().for_each(|&i| of[i as usize] = k as u32);
        sets.push(list);
    }
    let cost = |m: &Moments| m.fit(variance).map_or(f64::INFINITY, |p| p.cost);
    let mut sums: Vec<Moments> = vec![Moments::default(); sets.len()];
    for (m, set) in sums.iter_mut().zip(&sets) {
        set.iter().for_each(|&i| m.add(&points[i as usize]));
    }
    let mut costs: Vec<f64> = sums.iter().map(cost).collect();
    let mut beside: Vec<std::collections::BTreeSet<usize>> = vec![Default::default(); sets.len()];
    for l in links {
        let (a, b) = (of[l.a as usize] as usize, of[l.b as usize] as usize);
        if a != b {
            beside[a].insert(b);
            beside[b].insert(a);
        }
    }
    let loss = |sums: &[Moments], costs: &[f64], a: usize, b: usize| cost(&sums[a].with(&sums[b])) - costs[a] - costs[b];
    let mut losses: std::collections::BTreeMap<(usize, usize), f64> = Default::default();
    for a in 0..sets.len() {
        for &b in beside[a].range(a + 1..) {
            losses.insert((a, b), loss(&sums, &costs, a, b));
        }
    }
    loop {
        let best = losses.iter().min_by(|x, y| x.1.total_cmp(y.1).then(x.0.cmp(y.0))).map(|(&k, &v)| (k, v));
        let Some(((a, b), least)) = best else { break };
        if least >= limit {
            break;
        }
        let moved = std::mem::take(&mut sets[b]);
        sets[a].extend(moved);
        sums[a] = sums[a].with(&sums[b]);
        costs[a] = cost(&sums[a]);
        let others: Vec<usize> = beside[b].iter().copied().collect();
        for &o in &others {
            losses.remove(&(b.min(o), b.max(o)));
            beside[o].remove(&b);
            if o != a {
                beside[o].insert(a);
                beside[a].insert(o);
            }
        }
        beside[b].clear();
        let others: Vec<usize> = beside[a].iter().copied().collect();
        for o in others {
            losses.insert((a.min(o), a.max(o)), loss(&sums, &costs, a, o));
        }
    }
    for (k, set) in sets.iter().enumerate() {
        set.iter().for_each(|&i| label[i as usize] = k as u32);
    }
}

/// Gives every point to the nearest of the curves near it.
fn reassign(points: &[Across], links: &[Link], label: &mut [u32], variance: f64) {
    let pieces = members(label);
    let curves: Vec<(u32, Option<Curve>)> = pieces.iter().map(|p| (p.0, Curve::fit(points, &p.1, variance))).collect();
    let mut choices: Vec<Vec<u32>> = label.iter().map(|&l| vec![l]).collect();
    for l in links {
        choices[l.a as usize].push(label[l.b as usize]);
        choices[l.b as usize].push(label[l.a as usize]);
    }
    for (i, list) in choices.iter_mut().enumerate() {
        list.sort_unstable();
        list.dedup();
        if list.len() < 2 {
            continue;
        }
        let offset = |l: u32| {
            let curve = curves.iter().find(|c| c.0 == l).and_then(|c| c.1);
            curve.map_or(f64::INFINITY, |c| {
                let off = c.offset(points[i].raw);
                let (_, g, _) = c.value(points[i].raw);
                let cosine = dot(g, points[i].normal).abs() / norm(g).max(1e-12);
                off * off / variance + 4.0 * (1.0 - cosine * cosine)
            })
        };
        label[i] = list.iter().copied().map(|l| (offset(l), l)).min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))).map_or(label[i], |x| x.1);
    }
}

pub(super) fn corners(section: &Section) -> Vec<Edgelet> {
    let points = &section.points;
    if points.len() < 20 {
        return Vec::new();
    }
    let variance = section.noise.powi(2) + knobs().model.powi(2);
    let links = links(points, section.noise);
    let mut label = grow(points.len(), &links);
    merge(points, &links, &mut label, variance);
    for _ in 0..2 {
        reassign(points, &links, &mut label, variance);
    }
    merge(points, &links, &mut label, variance);
    let pieces = members(&label);
    let curves: Vec<Option<Curve>> = pieces.iter().map(|p| Curve::fit(points, &p.1, variance)).collect();
    let mut found = Vec::new();
    let least = knobs().fold;
    let shortest = knobs().short + section.noise;
    for a in 0..pieces.len() {
        for b in a + 1..pieces.len() {
            let (Some(ca), Some(cb)) = (curves[a], curves[b]) else { continue };
            if ca.length().min(cb.length()) < shortest || ca.count.min(cb.count) < 8.0 {
                continue;
            }
            let (mut sum, mut n) = ([0.0; 2], 0.0);
            for l in &links {
                let (x, y) = (label[l.a as usize], label[l.b as usize]);
                if (x == pieces[a].0 && y == pieces[b].0) || (x == pieces[b].0 && y == pieces[a].0) {
                    for p in [l.a, l.b].map(|i| points[i as usize].place) {
                        sum = [sum[0] + p[0], sum[1] + p[1]];
                        n += 1.0;
                    }
                }
            }
            if n < 6.0 {
                continue;
            }
            let middle = [sum[0] / n, sum[1] / n];
            let Some(p) = meet(&ca, &cb, middle) else { continue };
            let gap = 0.6 + 2.0 * section.noise;
            if norm(sub(p, middle)) > gap || norm(p) > knobs().centre || ca.offset(p).max(cb.offset(p)) > gap {
                continue;
            }
            let (x, y) = (ca.arm(p), cb.arm(p));
            let turn = 180.0 - dot(x, y).clamp(-1.0, 1.0).acos().to_degrees();
            if turn < least || turn > 150.0 {
                continue;
            }
            let [_, u, v] = section.axes;
            let space = |q: P2| add_scaled(add_scaled([0.0; 3], u, q[0]), v, q[1]);
            let offset = space(p);
            found.push(Edgelet {
                place: add_scaled(section.origin, offset, section.unit),
                along: section.axes[0],
                arms: [space(x), space(y)],
                weight: ca.count.min(cb.count).min(30.0) / (1.0 + 0.3 * norm(p)) * (section.stations as f64),
            });
        }
    }
    found
}
