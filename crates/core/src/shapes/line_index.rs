//! Distance from a point to a set of polylines.

use super::nearest::Tree;
use super::truth::{Truth, TruthCurve};
use crate::math::vec3::{add_scaled, distance, sub, to_segment};

/// Polylines cut into pieces no longer than a step, with a tree over the pieces' ends.
#[derive(Clone, Debug)]
pub struct LineIndex {
    tree: Tree,
    points: Vec<[f64; 3]>,
    /// The points before and after each point on its line (itself where the line ends).
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

    /// Greatest length of a piece.
    pub fn step(&self) -> f64 {
        self.step
    }

    pub(crate) fn of(lines: impl Iterator<Item = Part>, step: f64) -> Self {
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
    /// An index of all lines that must be found: curves without their stretches below `weak_below_deg`.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::network::StripKind;
    use crate::shapes::truth::Fold;
    use crate::shapes::{Rng, bracket, sheet_with_hole};

    #[test]
    fn distance_is_that_to_the_nearest_segment_of_all() {
        let mut rng = Rng::new(2);
        for truth in [bracket().network, sheet_with_hole().network] {
            let index = truth.index(0.05);
            for _ in 0..300 {
                let p = [rng.between(-1.0, 5.0), rng.between(-1.0, 7.0), rng.between(-1.0, 6.0)];
                let segments = truth.curves.iter().flat_map(TruthCurve::segments);
                let exact = segments.map(|[a, b]| to_segment(p, a, b)).fold(f64::INFINITY, f64::min);
                let excess = index.distance(p) - exact;
                assert!((-1e-12..=0.05 * 0.05 / 8.0 / exact + 1e-12).contains(&excess), "{p:?} {excess}");
            }
        }
    }

    #[test]
    fn pieces_are_no_longer_than_the_step_and_keep_the_corners() {
        let square = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let open = densify(&square, false, 0.3);
        let closed = densify(&square, true, 0.3);
        assert_eq!([open.len(), closed.len()], [13, 17]);
        assert_eq!(closed.first(), closed.last());
        assert!(closed.windows(2).all(|w| distance(w[0], w[1]) <= 0.3));
        assert!(square.iter().all(|p| open.contains(p)));
    }

    #[test]
    fn a_loop_falls_into_its_weak_and_sharp_stretches() {
        let points: Vec<[f64; 3]> = (0..8).map(|i| [f64::from(i), f64::from(i * i), 0.0]).collect();
        let folds = vec![50.0, 50.0, 10.0, 10.0, 10.0, 50.0, 50.0, 50.0];
        let curve = TruthCurve::new(StripKind::Crease, points, folds, Fold::Convex, None);
        let truth = Truth { weak_below_deg: 30.0, ..Truth::with_nodes(&[], vec![curve]) };
        let runs = |weak| -> Vec<Vec<f64>> {
            let parts = truth.parts(&truth.curves[0], weak);
            assert!(parts.iter().all(|p| !p.closed));
            parts.iter().map(|p| p.points.iter().map(|q| q[0]).collect()).collect()
        };
        assert_eq!(runs(true), [[2.0, 3.0, 4.0]]);
        assert_eq!(runs(false), [vec![0.0, 1.0], vec![5.0, 6.0, 7.0, 0.0]]);
        let strong = Truth { weak_below_deg: 0.0, ..truth.clone() };
        assert!(strong.parts(&strong.curves[0], false)[0].closed);
        assert!(strong.parts(&strong.curves[0], true).is_empty());
    }
}
