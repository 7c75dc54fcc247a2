//! Distance from a point to a set of polylines.

use super::nearest::Tree;
use super::truth::{Truth, TruthCurve};
use crate::math::vec3::{add_scaled, distance, dot, sub};

/// Polylines cut into pieces no longer than a step, with a tree over the pieces' ends.
#[derive(Clone, Debug)]
pub struct LineIndex {
    tree: Tree,
    points: Vec<[f64; 3]>,
    /// For each point, the points before and after it on its line (itself where the line ends).
    beside: Vec<[u32; 2]>,
    step: f64,
}

impl LineIndex {
    /// Distance to the nearest line; infinite if there is none. Exact for lines that turn little within a step and
    /// stay a step apart; otherwise too great by at most an eighth of the step's square over the distance.
    pub fn distance(&self, p: [f64; 3]) -> f64 {
        let Some((i, d2)) = self.tree.nearest(p) else { return f64::INFINITY };
        let here = self.points[i as usize];
        let sides = self.beside[i as usize].map(|j| to_segment(p, here, self.points[j as usize]));
        d2.sqrt().min(sides[0]).min(sides[1])
    }

    /// The length that no piece exceeds.
    pub fn step(&self) -> f64 {
        self.step
    }

    fn of(lines: impl Iterator<Item = Part>, step: f64) -> Self {
        let (mut points, mut beside) = (Vec::new(), Vec::new());
        for Part { points: line, closed } in lines {
            let mut line = densify(&line, closed, step);
            if closed {
                line.pop();
            }
            let (first, n) = (points.len() as u32, line.len() as u32);
            let before = |i: u32| {
                if i > 0 {
                    i - 1
                } else if closed {
                    n - 1
                } else {
                    0
                }
            };
            let after = |i: u32| {
                if i + 1 < n {
                    i + 1
                } else if closed {
                    0
                } else {
                    i
                }
            };
            beside.extend((0..n).map(|i| [first + before(i), first + after(i)]));
            points.append(&mut line);
        }
        Self { tree: Tree::new(&points), points, beside, step }
    }
}

/// A stretch of a curve that is sharp, or weak, throughout.
pub(crate) struct Part {
    pub(crate) points: Vec<[f64; 3]>,
    pub(crate) closed: bool,
}

impl Truth {
    /// An index of all that must be found: curves without their stretches below `weak_below_deg`.
    pub fn index(&self, step: f64) -> LineIndex {
        LineIndex::of(self.curves.iter().flat_map(|c| self.parts(c, false)), step)
    }

    /// An index of the stretches that fold by less than `weak_below_deg`.
    pub fn index_of_weak(&self, step: f64) -> LineIndex {
        LineIndex::of(self.curves.iter().flat_map(|c| self.parts(c, true)), step)
    }

    /// The weak stretches of a curve, or the others.
    pub(crate) fn parts(&self, curve: &TruthCurve, weak: bool) -> Vec<Part> {
        let wanted = |i: usize| (curve.fold_deg.get(i).is_some_and(|&f| f < self.weak_below_deg)) == weak;
        let m = curve.points.len();
        if (0..m).all(wanted) {
            return vec![Part { points: curve.points.clone(), closed: curve.closed }];
        }
        let mut parts: Vec<Part> = Vec::new();
        for k in (0..m + usize::from(curve.closed)).filter(|k| wanted(k % m)) {
            if k == 0 || !wanted(k - 1) {
                parts.push(Part { points: Vec::new(), closed: false });
            }
            if let Some(part) = parts.last_mut() {
                part.points.push(curve.points[k % m]);
            }
        }
        parts.retain(|p| p.points.len() > 1);
        parts
    }
}

/// The points of a polyline with further ones between them, so that no piece is longer than `step`. A closed line
/// ends in its first point again.
pub(crate) fn densify(points: &[[f64; 3]], closed: bool, step: f64) -> Vec<[f64; 3]> {
    let mut out: Vec<[f64; 3]> = points.first().copied().into_iter().collect();
    let closing = if closed { points.first() } else { None };
    for (&a, &b) in points.iter().zip(points.iter().skip(1).chain(closing)) {
        let pieces = (distance(a, b) / step).ceil().max(1.0) as u32;
        let inner = |k| add_scaled(a, sub(b, a), f64::from(k) / f64::from(pieces));
        out.extend((1..pieces).map(inner));
        out.push(b);
    }
    out
}

fn to_segment(p: [f64; 3], a: [f64; 3], b: [f64; 3]) -> f64 {
    let ab = sub(b, a);
    let length2 = dot(ab, ab);
    let along = if length2 > 0.0 { (dot(sub(p, a), ab) / length2).clamp(0.0, 1.0) } else { 0.0 };
    distance(p, add_scaled(a, ab, along))
}
