//! The lines of a mesh: edges at which its faces meet at an angle, and edges with a face on one side alone, end to end.
//!
//! Runs go on through vertices where two such edges of one kind meet and turn little.

use super::canonical::Surface;
use super::faces::Faces;
use super::sharp::Edges;
use crate::math::vec3::{dot, sub, unit};

/// Cosine of the turn at a vertex, 50 degrees, from which on a run ends.
const TURN: f64 = 0.642_788;

/// A run of edges of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshLine {
    /// Whether there is a face on one side alone.
    pub border: bool,
    /// Whether the last point is joined to the first.
    pub closed: bool,
    /// `(M, 3)` vertices in order, world frame.
    pub points: Vec<[f64; 3]>,
}

/// The lines of a mesh whose faces meet at more than `angle_deg` degrees, and its borders; none where the faces have no area.
/// `vertices` is `(V, 3)` f64, world frame. Neither the order of the faces nor which way round they are makes a difference; vertices
/// at one place are one.
pub fn lines(vertices: &[[f64; 3]], faces: &Faces, angle_deg: f64) -> Vec<MeshLine> {
    let Some(surface) = Surface::new(vertices, faces) else { return Vec::new() };
    let edges = Edges::new(&surface, angle_deg.to_radians().cos());
    let kinds: Vec<bool> = edges.sharp.iter().map(|(_, beside)| beside.len() == 1).collect();
    let mut runs = Runs::new(&surface, edges.sharp.into_iter().map(|(ends, _)| ends).collect(), kinds);
    let mut all = Vec::new();
    // From the ends of runs first; what is left are loops.
    for from_ends in [true, false] {
        for edge in 0..runs.edges.len() {
            for at in runs.edges[edge] {
                if !runs.used[edge] && (!from_ends || runs.next(edge, at).is_none()) {
                    all.push(runs.walk(edge, at));
                }
            }
        }
    }
    all
}

/// Edges with the way on from each of their ends.
struct Runs<'a> {
    surface: &'a Surface,
    edges: Vec<[u32; 2]>,
    border: Vec<bool>,
    used: Vec<bool>,
    /// Pairs of a vertex and an edge there, sorted.
    at: Vec<(u32, usize)>,
}

impl<'a> Runs<'a> {
    fn new(surface: &'a Surface, edges: Vec<[u32; 2]>, border: Vec<bool>) -> Self {
        let mut at: Vec<(u32, usize)> =
            edges.iter().enumerate().flat_map(|(e, ends)| ends.map(|v| (v, e))).collect();
        at.sort_unstable();
        let used = vec![false; edges.len()];
        Self { surface, edges, border, used, at }
    }

    /// The edge that goes on behind the end `v` of an edge.
    fn next(&self, edge: usize, v: u32) -> Option<usize> {
        let first = self.at.partition_point(|a| a.0 < v);
        let here = &self.at[first..self.at.partition_point(|a| a.0 <= v)];
        let &[(_, a), (_, b)] = here else { return None };
        let other = if a == edge { b } else { a };
        let away = |e: usize| {
            let [p, q] = self.edges[e];
            unit(sub(self.place(p + q - v), self.place(v)))
        };
        let straight = -dot(away(edge), away(other)) > TURN;
        (straight && self.border[edge] == self.border[other]).then_some(other)
    }

    fn place(&self, v: u32) -> [f64; 3] {
        self.surface.vertices[v as usize]
    }

    /// The run that begins with the end `from` of an edge.
    fn walk(&mut self, edge: usize, from: u32) -> MeshLine {
        let (mut edge, mut at, border) = (edge, from, self.border[edge]);
        let mut vertices = vec![from];
        loop {
            self.used[edge] = true;
            let [p, q] = self.edges[edge];
            at = p + q - at;
            vertices.push(at);
            match self.next(edge, at) {
                Some(next) if !self.used[next] => edge = next,
                _ => break,
            }
        }
        let closed = vertices.len() > 3 && at == from;
        if closed {
            vertices.pop();
        }
        let points = vertices.into_iter().map(|v| self.surface.to_world(self.place(v))).collect();
        MeshLine { border, closed, points }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An open box of quadrangles: its five faces, two of them turned over.
    fn open_box() -> (Vec<[f64; 3]>, Faces) {
        let corner = |i: usize| [i & 1, i >> 1 & 1, i >> 2].map(|c| c as f64 + 100.0);
        let mut faces = Faces::default();
        for face in [[0, 1, 3, 2], [0, 1, 5, 4], [2, 3, 7, 6], [6, 4, 0, 2], [1, 3, 7, 5]] {
            faces.push(&face);
        }
        ((0..8).map(corner).collect(), faces)
    }

    #[test]
    fn an_open_box_has_eight_creases_and_four_borders() {
        let (vertices, faces) = open_box();
        let found = lines(&vertices, &faces, 30.0);
        assert_eq!(found.iter().filter(|l| l.border).count(), 4);
        assert_eq!(found.iter().filter(|l| !l.border).count(), 8);
        assert!(found.iter().all(|l| !l.closed && l.points.len() == 2));
        assert!(found.iter().flat_map(|l| &l.points).all(|p| vertices.contains(p)));
        assert!(lines(&vertices, &faces, 95.0).iter().all(|l| l.border));
    }

    #[test]
    fn a_drum_has_two_round_lines_and_none_between_its_facets() {
        let (n, mut vertices, mut faces) = (40u32, Vec::new(), Faces::default());
        for i in 0..n {
            let (y, x) = (std::f64::consts::TAU * f64::from(i) / f64::from(n)).sin_cos();
            vertices.extend([[x, y, 0.0], [x, y, 1.0]]);
        }
        for i in 0..n {
            let j = (i + 1) % n;
            faces.push(&[2 * i, 2 * j, 2 * j + 1, 2 * i + 1]);
        }
        faces.push(&(0..n).map(|i| 2 * i).collect::<Vec<_>>());
        faces.push(&(0..n).map(|i| 2 * i + 1).collect::<Vec<_>>());
        let found = lines(&vertices, &faces, 30.0);
        assert_eq!(found.len(), 2);
        assert!(found.iter().all(|l| l.closed && !l.border && l.points.len() == n as usize));
        assert_eq!(lines(&vertices, &faces, 5.0).len(), 2 * n as usize + n as usize);
    }
}
