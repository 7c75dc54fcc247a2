//! The graph of chains: a vertex for each edgelet.

use super::chain::Chain;
use crate::math::vec3::{add_scaled, cross, norm, sub, unit};
use crate::measure::{Edgelet, Evidence};
use crate::pattern::LineGraph;

/// Evidence at which an edgelet is as likely right as wrong.
const EVEN: f64 = 50.0;
/// Vertices on either side of one over which the direction there is taken; at an end twice as many.
const BESIDE: usize = 3;

/// Lines along chains, and the edgelet of each vertex.
#[derive(Debug, Default)]
pub(super) struct Graph {
    pub(super) lines: LineGraph,
    pub(super) edgelets: Vec<Edgelet>,
}

/// The line along a piece of chain: a place, a unit direction, and the curvature of the piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Straight {
    pub(super) place: [f64; 3],
    pub(super) along: [f64; 3],
    pub(super) bend: f64,
}

impl Graph {
    pub(super) fn new(chains: &[Chain]) -> Graph {
        let mut graph = Graph::default();
        for chain in chains {
            let added: Vec<u32> = chain.members.iter().map(|e| graph.push(e)).collect();
            added.windows(2).for_each(|w| graph.lines.add_edge(w[0], w[1]));
            if chain.closed {
                graph.lines.add_edge(added[0], added[added.len() - 1]);
            }
        }
        graph
    }

    /// Adds the vertex of an edgelet.
    pub(super) fn push(&mut self, e: &Edgelet) -> u32 {
        let v = self.lines.push_vertex(e.point, e.place);
        let doubt = EVEN * EVEN / (EVEN * EVEN + e.evidence * e.evidence);
        self.lines.penalty[v as usize] = Some(doubt as f32);
        let (shown, fold) = (e.evidence as f32, e.turn() as f32);
        self.lines.evidence[v as usize] = Some(Evidence { sharp: shown, expected: shown, fold });
        self.lines.radius[v as usize] = e.radius as f32;
        self.edgelets.push(*e);
        v
    }

    pub(super) fn place(&self, v: u32) -> [f64; 3] {
        self.lines.positions[v as usize]
    }

    /// The spacing of the cloud at a vertex.
    pub(super) fn spacing(&self, v: u32) -> f64 {
        self.edgelets[v as usize].spacing
    }

    /// The neighbours of a vertex, ascending.
    pub(super) fn beside(&self, v: u32) -> &[u32] {
        &self.lines.edges[v as usize]
    }

    /// Whether a chain ends at a vertex without meeting another.
    pub(super) fn is_loose(&self, v: u32) -> bool {
        self.beside(v).len() == 1
    }

    /// The vertices with edges, ascending.
    pub(super) fn vertices(&self) -> impl Iterator<Item = u32> + '_ {
        (0..self.edgelets.len() as u32).filter(|&v| !self.beside(v).is_empty())
    }

    /// Up to `most` vertices from `v` on over `next`, both included, as far as no line branches.
    pub(super) fn walk(&self, v: u32, next: u32, most: usize) -> Vec<u32> {
        let mut row = vec![v, next];
        while row.len() < most {
            let [before, at] = [row[row.len() - 2], row[row.len() - 1]];
            match *self.beside(at) {
                [a, b] if a != v && b != v => row.push(if a == before { b } else { a }),
                _ => break,
            }
        }
        row
    }

    /// The line through the vertices on both sides of `v`; at an end it leads outwards.
    pub(super) fn straight(&self, v: u32) -> Straight {
        let row = self.around(v);
        let (half, third) = (row.len() / 2, row.len() / 3);
        let chord = |from: &[u32], to: &[u32]| sub(self.mean(to), self.mean(from));
        let whole = chord(&row[..half], &row[row.len() - half..]);
        if norm(whole) == 0.0 {
            let own = &self.edgelets[v as usize];
            return Straight { place: own.place, along: own.along, bend: 0.0 };
        }
        let [first, last] = [
            chord(&row[..third], &row[third..2 * third]),
            chord(&row[third..2 * third], &row[row.len() - third..]),
        ];
        let turn = norm(cross(first, last)) / (norm(first) * norm(last)).max(f64::MIN_POSITIVE);
        let bend = turn / (0.5 * (norm(first) + norm(last))).max(f64::MIN_POSITIVE);
        Straight { place: self.mean(&row), along: unit(whole), bend: if third > 0 { bend } else { 0.0 } }
    }

    /// The vertices on both sides of `v`, in order; `v` is the last where it is an end.
    fn around(&self, v: u32) -> Vec<u32> {
        let count = if self.is_loose(v) { 2 * BESIDE } else { BESIDE + 1 };
        let mut sides = self.beside(v).iter().take(2).map(|&next| self.walk(v, next, count));
        let mut row = sides.next().unwrap_or_else(|| vec![v]);
        row.reverse();
        row.extend(sides.next().iter().flat_map(|side| &side[1..]));
        row
    }

    fn mean(&self, row: &[u32]) -> [f64; 3] {
        let share = 1.0 / row.len().max(1) as f64;
        row.iter().fold([0.0; 3], |sum, &v| add_scaled(sum, self.place(v), share))
    }

    /// The edges, each once, with the spacing of the cloud there.
    pub(super) fn edges(&self) -> impl Iterator<Item = ([f64; 3], [f64; 3], f64)> + '_ {
        let all = self.vertices().flat_map(|a| self.beside(a).iter().map(move |&b| (a, b)));
        all.filter(|(a, b)| a < b).map(|(a, b)| (self.place(a), self.place(b), self.spacing(a)))
    }
}
