//! Smooth pieces of a cross-section and the corners between them.

use super::env;
use super::section::{Across, Section};
use crate::math::least_squares::least_squares;
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
    origin: P2,
    axis: P2,
    c: [f64; 3],
    cost: f64,
    count: f64,
    extent: [f64; 2],
}

impl Curve {
    fn fit(points: &[Across], of: &[u32], variance: f64) -> Option<Curve> {
        let n = of.len() as f64;
        let raw = |&i: &u32| points[i as usize].raw;
        let sum = of.iter().map(raw).fold([0.0; 2], |s, p| [s[0] + p[0], s[1] + p[1]]);
        let origin = [sum[0] / n, sum[1] / n];
        // The axis from the normals and the spread of the points.
        let mut m = [0.0; 3];
        for i in of {
            let d = sub(raw(i), origin);
            let k = points[*i as usize].normal;
            m[0] += d[0] * d[0] + 0.3 * k[1] * k[1];
            m[1] += d[0] * d[1] - 0.3 * k[0] * k[1];
            m[2] += d[1] * d[1] + 0.3 * k[0] * k[0];
        }
        let angle = 0.5 * (2.0 * m[1]).atan2(m[0] - m[2]);
        let axis = [angle.cos(), angle.sin()];
        let local = |i: &u32| {
            let d = sub(raw(i), origin);
            (dot(d, axis), axis[0] * d[1] - axis[1] * d[0])
        };
        let prior = variance.sqrt() / env("CURVE", 0.08);
        let slope = variance.sqrt() / 0.5;
        let rows = of.iter().map(|i| {
            let (x, y) = local(i);
            ([1.0, x, x * x], y)
        });
        let c = least_squares(rows.chain([([0.0, 0.0, prior], 0.0), ([0.0, slope, 0.0], 0.0)]))?;
        let mut cost = (prior * c[2]).powi(2) + (slope * c[1]).powi(2);
        let mut extent = [f64::INFINITY, f64::NEG_INFINITY];
        for i in of {
            let (x, y) = local(i);
            cost += (y - c[0] - c[1] * x - c[2] * x * x).powi(2);
            extent = [extent[0].min(x), extent[1].max(x)];
        }
        Some(Curve { origin, axis, c, cost: cost / variance, count: n, extent })
    }

    fn value(&self, p: P2) -> (f64, P2, f64) {
        let d = sub(p, self.origin);
        let (x, y) = (dot(d, self.axis), self.axis[0] * d[1] - self.axis[1] * d[0]);
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

fn links(points: &[Across], noise: f64) -> Vec<Link> {
    let n = points.len();
    let mut links = Vec::new();
    let farthest = 0.7 + noise;
    let mut near: Vec<(f64, usize)> = Vec::new();
    for i in 0..n {
        near.clear();
        for j in 0..n {
            let d = norm(sub(points[i].place, points[j].place));
            if j != i && d < farthest {
                near.push((d, j));
            }
        }
        near.sort_by(|x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
        near.truncate(NEAR);
        for &(d, j) in &near {
            let (p, q) = (&points[i], &points[j]);
            let step = sub(q.place, p.place);
            let off = dot(p.normal, step).abs().min(dot(q.normal, step).abs());
            let angle = dot(p.normal, q.normal).abs().min(1.0).acos();
            let over = (off - d * (0.5 * angle).sin() - 0.1 - 0.3 * noise).max(0.0);
            links.push(Link { a: i.min(j) as u32, b: i.max(j) as u32, weight: angle + 3.0 * over });
        }
    }
    links.sort_by(|x, y| x.weight.total_cmp(&y.weight).then((x.a, x.b).cmp(&(y.a, y.b))));
    links.dedup_by(|x, y| (x.a, x.b) == (y.a, y.b));
    links
}

fn grow(points: usize, links: &[Link]) -> Vec<u32> {
    let growth = env("GROWTH", 50.0).to_radians();
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
    let limit = env("PIECE", 14.0);
    loop {
        let pieces = members(label);
        let of = |l: u32| pieces.iter().position(|p| p.0 == l).unwrap_or(0);
        let curves: Vec<Option<Curve>> = pieces.iter().map(|p| Curve::fit(points, &p.1, variance)).collect();
        let mut pairs: Vec<(usize, usize)> = links
            .iter()
            .filter(|l| label[l.a as usize] != label[l.b as usize])
            .map(|l| {
                let (a, b) = (of(label[l.a as usize]), of(label[l.b as usize]));
                (a.min(b), a.max(b))
            })
            .collect();
        pairs.sort_unstable();
        pairs.dedup();
        let mut best: Option<(f64, usize, usize)> = None;
        for (a, b) in pairs {
            let (Some(ca), Some(cb)) = (curves[a], curves[b]) else { continue };
            let both: Vec<u32> = pieces[a].1.iter().chain(&pieces[b].1).copied().collect();
            let Some(joint) = Curve::fit(points, &both, variance) else { continue };
            let loss = joint.cost - ca.cost - cb.cost;
            if loss < limit && best.is_none_or(|x| loss < x.0) {
                best = Some((loss, a, b));
            }
        }
        let Some((_, a, b)) = best else { return };
        let (to, from) = (pieces[a].0, pieces[b].0);
        label.iter_mut().filter(|l| **l == from).for_each(|l| *l = to);
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
    let variance = section.noise.powi(2) + env("MODEL", 0.06).powi(2);
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
    let least = env("FOLD", 28.0);
    let shortest = env("SHORT", 0.8) + section.noise;
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
            if norm(sub(p, middle)) > gap || norm(p) > env("CENTRE", 2.5) || ca.offset(p).max(cb.offset(p)) > gap {
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
