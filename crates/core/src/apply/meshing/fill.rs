//! The smallest gaps of a mesh, closed: a hole of a few edges lies below what the points resolve.
//!
//! Each is filled by the triangles of least area over its rim, found by dynamic programming (G. Barequet and M. Sharir, "Filling
//! gaps in the boundary of a polyhedron", Computer Aided Geometric Design 12, 1995).

use std::collections::{BTreeMap, BTreeSet};

use super::surface_mesh::edges;
use crate::math::vec3::{cross, dot, norm, sub, unit};

/// Greatest number of edges of a hole that is filled.
const MOST_EDGES: usize = 9;
/// Least cosine of the turn from a triangle at the rim: a sheet gets no back.
const LEAST_COSINE: f64 = -0.7;
/// Weight of a triangle that joins two sides of a line, as a multiple of its area: where others fit, there is none.
const ACROSS: f64 = 1e3;

/// A mesh whose vertices have one fan each, while it is filled.
struct Gaps<'a, F> {
    points: &'a [[f64; 3]],
    /// The triangle on the left of each directed edge.
    left: BTreeMap<[u32; 2], usize>,
    edges: BTreeSet<[u32; 2]>,
    across: F,
}

/// Fills holes of few edges. `across` says of two vertices whether they lie on different sides of a line.
pub(super) fn fill(points: &[[f64; 3]], triangles: &mut Vec<[u32; 3]>, across: impl Fn(u32, u32) -> bool) {
    let directed = |t: &[u32; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    let left = triangles.iter().enumerate().flat_map(|(n, t)| directed(t).map(|edge| (edge, n))).collect();
    let all = triangles.iter().flat_map(edges).collect();
    let mut gaps = Gaps { points, left, edges: all, across };
    for rim in gaps.rims() {
        if let Some(new) = gaps.patch(&rim, triangles) {
            gaps.edges.extend(new.iter().flat_map(edges));
            triangles.extend(new);
        }
    }
}

impl<F: Fn(u32, u32) -> bool> Gaps<'_, F> {
    /// The rims of holes of few edges, each in the sense of the triangles that fill it.
    fn rims(&self) -> Vec<Vec<u32>> {
        let open = self.left.keys().filter(|&&[a, b]| !self.left.contains_key(&[b, a]));
        let next: BTreeMap<u32, u32> = open.map(|&[a, b]| (b, a)).collect();
        let mut seen = BTreeSet::new();
        let mut rims = Vec::new();
        for &start in next.keys() {
            let mut rim = Vec::new();
            let mut at = start;
            while seen.insert(at) {
                rim.push(at);
                let Some(&then) = next.get(&at) else { break };
                at = then;
            }
            if at == start && (3..=MOST_EDGES).contains(&rim.len()) {
                rims.push(rim);
            }
        }
        rims
    }

    /// The triangles of least weight over a rim; `None` if none fit.
    fn patch(&self, rim: &[u32], triangles: &[[u32; 3]]) -> Option<Vec<[u32; 3]>> {
        let count = rim.len();
        let mut best = vec![vec![(0.0, 0); count]; count];
        for width in 2..count {
            for i in 0..count - width {
                let j = i + width;
                let through = |k: usize| {
                    let own = self.weight(rim, [i, k, j], triangles);
                    (best[i][k].0 + best[k][j].0 + own, k)
                };
                let least = (i + 1..j).map(through).min_by(|a, b| a.0.total_cmp(&b.0));
                best[i][j] = least.unwrap_or((f64::INFINITY, 0));
            }
        }
        if !best[0][count - 1].0.is_finite() {
            return None;
        }
        let mut new = Vec::new();
        let mut open = vec![(0, count - 1)];
        while let Some((i, j)) = open.pop().filter(|(i, j)| j > i) {
            if j - i > 1 {
                let k = best[i][j].1;
                new.push([rim[i], rim[k], rim[j]]);
                open.extend([(i, k), (k, j)]);
            }
        }
        Some(new)
    }

    /// The weight of a triangle over a rim; infinite if it has an edge that is taken, or folds back.
    fn weight(&self, rim: &[u32], corners: [usize; 3], triangles: &[[u32; 3]]) -> f64 {
        let triangle = corners.map(|k| rim[k]);
        let (area, normal) = self.area(triangle);
        let mut weight = area;
        for side in 0..3 {
            let (a, b) = (triangle[side], triangle[(side + 1) % 3]);
            if let Some(&beside) = self.left.get(&[b, a]).filter(|_| !self.left.contains_key(&[a, b])) {
                if dot(normal, self.area(triangles[beside]).1) < LEAST_COSINE {
                    return f64::INFINITY;
                }
            } else if self.edges.contains(&[a.min(b), a.max(b)]) {
                return f64::INFINITY;
            }
            if (self.across)(a, b) {
                weight += ACROSS * area;
            }
        }
        weight
    }

    /// Twice the area of a triangle, and its unit normal.
    fn area(&self, triangle: [u32; 3]) -> (f64, [f64; 3]) {
        let [a, b, c] = triangle.map(|v| self.points[v as usize]);
        let product = cross(sub(b, a), sub(c, a));
        (norm(product), unit(product))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The corners of an octahedron, and its faces.
    fn octahedron() -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
        let points = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
        let faces =
            vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
        (points.map(|p: [i32; 3]| p.map(f64::from)).to_vec(), faces)
    }

    fn open(triangles: &[[u32; 3]]) -> usize {
        let mut all: Vec<[u32; 2]> = triangles.iter().flat_map(edges).collect();
        all.sort_unstable();
        assert!(all.chunk_by(|a, b| a == b).all(|uses| uses.len() <= 2));
        all.chunk_by(|a, b| a == b).filter(|uses| uses.len() == 1).count()
    }

    #[test]
    fn holes_of_one_and_of_two_faces_are_closed_in_the_sense_of_the_mesh() {
        for missing in [vec![0], vec![0, 1]] {
            let (points, faces) = octahedron();
            let mut triangles: Vec<[u32; 3]> =
                (0..8).filter(|f| !missing.contains(f)).map(|f| faces[f]).collect();
            fill(&points, &mut triangles, |a, b| (a.min(b), a.max(b)) == (0, 1));
            assert_eq!((triangles.len(), open(&triangles)), (8, 0));
            let volume = |t: &[u32; 3]| {
                let [a, b, c] = t.map(|v| points[v as usize]);
                dot(a, cross(b, c)) / 6.0
            };
            assert!((triangles.iter().map(volume).sum::<f64>() - 4.0 / 3.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_lone_triangle_gets_no_back() {
        let (points, faces) = octahedron();
        let mut triangles = vec![faces[0]];
        fill(&points, &mut triangles, |_, _| false);
        assert_eq!(triangles.len(), 1);
    }
}
