//! The strips of the spanning graph where no chain is.

use super::graph::Graph;
use super::samples::Samples;
use crate::math::union_find::UnionFind;
use crate::math::vec3::distance;
use crate::neighbors::Index;
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// Distance from a chain within which a strip is the same line, in spacings.
const SAME: f64 = 1.0;
/// Distance from a strip at which a loose end of a chain goes on along it, in spacings.
const GOES_ON: f64 = 2.0;
/// Least length of a piece of strip between chains that do not end there, in spacings.
const LENGTH: f64 = 4.0;
/// Distance within which a piece runs beside a chain all along, in spacings, and its least length there: points beside an edge whose
/// chain was led on to a corner make such a piece.
const BESIDE: (f64, f64) = (1.6, 8.0);

/// Strips, and the part of them that lies beside no chain.
struct Free<'a> {
    strips: &'a LineGraph,
    scales: Scales<'a>,
    /// `(V)` whether each vertex lies beside no chain, or stays with its strip.
    free: Vec<bool>,
    /// `(V)` whether each vertex lies at a distance from a chain that other lines have seldom.
    beside: Vec<bool>,
    /// `(V)` a vertex that stands for the connected piece of free vertices.
    piece: Vec<u32>,
}

/// A free vertex that continues a chain.
struct Joint {
    vertex: u32,
    chain: u32,
    loose: bool,
}

/// The chains, the strips that stay `whole`, and the pieces of the others that lie beside no chain.
pub(super) fn overlay(graph: Graph, strips: &LineGraph, whole: &[bool], scales: Scales) -> LineGraph {
    let free = Free::new(&graph, strips, whole, scales);
    let joints = free.joints(&graph);
    let kept = free.kept(&joints);
    let mut lines = graph.lines;
    let number = free.append(&mut lines, &kept);
    for joint in joints.iter().filter(|j| number[j.vertex as usize] != NONE) {
        lines.add_edge(number[joint.vertex as usize], joint.chain);
    }
    lines
}

/// The number of a vertex that is left out.
const NONE: u32 = u32::MAX;

impl<'a> Free<'a> {
    fn new(graph: &Graph, strips: &'a LineGraph, whole: &[bool], scales: Scales<'a>) -> Free<'a> {
        let count = strips.edges.len();
        let samples = Samples::new(graph.edges());
        let mut free = Free { strips, scales, free: Vec::new(), beside: Vec::new(), piece: Vec::new() };
        let near = |v: usize, reach: f64| {
            samples.nearest(strips.positions[v], reach * free.spacing(v), |_| true).is_some()
        };
        let clear = (0..count).map(|v| whole[v] || !near(v, SAME)).collect();
        (free.beside, free.free) = ((0..count).map(|v| !whole[v] && near(v, BESIDE.0)).collect(), clear);
        let mut sets = UnionFind::new(count);
        for (a, b) in free.pairs().filter(|&(a, b)| free.free[a] && free.free[b]) {
            sets.union(a as u32, b as u32);
        }
        free.piece = (0..count as u32).map(|v| sets.find(v)).collect();
        free
    }

    fn spacing(&self, v: usize) -> f64 {
        self.scales.at(self.strips.points[v] as usize).spacing
    }

    /// The edges of the strips, each in both directions.
    fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + use<'a> {
        let lists = self.strips.edges.iter().enumerate();
        lists.flat_map(|(a, list)| list.iter().map(move |&b| (a, b as usize)))
    }

    /// Where free vertices have a neighbour beside a chain: with the loose end of a chain near it, or else with the vertex nearest to it.
    fn joints(&self, graph: &Graph) -> Vec<Joint> {
        let vertices: Vec<u32> = graph.vertices().collect();
        let places: Vec<[f64; 3]> = vertices.iter().map(|&v| graph.place(v)).collect();
        let index = Index::build(&places);
        let (mut joints, mut found) = (Vec::new(), Vec::new());
        for (a, b) in self.pairs().filter(|&(a, b)| self.free[a] && !self.free[b]) {
            index.within(self.strips.positions[b], GOES_ON * self.spacing(b), &mut found);
            let mut near = found.iter().map(|f| vertices[f.index as usize]);
            let loose = near.clone().find(|&v| graph.is_loose(v));
            if let Some(chain) = loose.or_else(|| near.next()) {
                joints.push(Joint { vertex: a as u32, chain, loose: loose.is_some() });
            }
        }
        joints
    }

    /// `(V)` whether each free piece stays, at the vertex that stands for it: all but short ones between chains that go on without
    /// them.
    fn kept(&self, joints: &[Joint]) -> Vec<bool> {
        let mut length = vec![0.0; self.free.len()];
        for (a, b) in self.pairs().filter(|&(a, b)| self.free[a] && (a < b || !self.free[b])) {
            let step = distance(self.strips.positions[a], self.strips.positions[b]);
            length[self.piece[a] as usize] += step / self.spacing(a);
        }
        let mut apart = vec![false; self.free.len()];
        let off = (0..self.free.len()).filter(|&v| self.free[v] && !self.beside[v]);
        off.for_each(|v| apart[self.piece[v] as usize] = true);
        let least = |piece: usize| if apart[piece] { LENGTH } else { BESIDE.1 };
        let mut kept = vec![true; self.free.len()];
        let pieces = || joints.iter().map(|j| (self.piece[j.vertex as usize] as usize, j.loose));
        pieces().for_each(|(piece, _)| kept[piece] = length[piece] >= least(piece));
        pieces().filter(|(_, loose)| *loose).for_each(|(piece, _)| kept[piece] = true);
        kept
    }

    /// Appends the free vertices that stay, and the edges between them; returns their numbers.
    fn append(&self, lines: &mut LineGraph, kept: &[bool]) -> Vec<u32> {
        let strips = self.strips;
        let mut number = vec![NONE; self.free.len()];
        let stays =
            |v: &usize| self.free[*v] && kept[self.piece[*v] as usize] && !strips.edges[*v].is_empty();
        for v in (0..number.len()).filter(stays) {
            let n = lines.push_vertex(strips.points[v], strips.positions[v]);
            lines.penalty[n as usize] = strips.penalty[v];
            lines.corner[n as usize] = strips.corner[v];
            lines.evidence[n as usize] = strips.evidence[v];
            number[v] = n;
        }
        let both = |&(a, b): &(usize, usize)| a < b && number[a] != NONE && number[b] != NONE;
        self.pairs().filter(both).for_each(|(a, b)| lines.add_edge(number[a], number[b]));
        lines.nodes.extend(strips.nodes.iter().map(|&v| number[v as usize]).filter(|&n| n != NONE));
        number
    }
}
