//! The graph of one kind of line: vertices with their properties, and the edges between them.

use crate::math::vec3::{add_scaled, distance, sub};
use crate::measure::Evidence;

/// A graph on some of the points of the cloud.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LineGraph {
    /// `(V)` point of the cloud for each vertex: the point itself or the nearest one.
    pub points: Vec<u32>,
    /// `(V, 3)` position of each vertex, which may differ from that of its point.
    pub positions: Vec<[f64; 3]>,
    /// `(V)` penalty of each vertex, 0 to 1; `None` from a linker without penalties.
    pub penalty: Vec<Option<f32>>,
    /// `(V)` preference of a direction at each vertex: 0 at a corner, 1 on a line.
    pub corner: Vec<f32>,
    /// `(V)` evidence of the cross-sections at all points of the vertex; `None` where none was taken.
    pub evidence: Vec<Option<Evidence>>,
    /// `(V)` radius of the round whose design edge each vertex lies on; 0 on lines of other kinds.
    pub radius: Vec<f32>,
    /// `(V)` neighbours of each vertex in the graph, ascending.
    pub edges: Vec<Vec<u32>>,
    /// Vertices that are nodes though only two edges meet in them: corners, and places where the other pattern ends.
    pub nodes: Vec<u32>,
}

impl LineGraph {
    /// The number of edges.
    pub fn edge_count(&self) -> usize {
        self.edges.iter().map(Vec::len).sum::<usize>() / 2
    }

    /// Joins `a` and `b`.
    pub fn add_edge(&mut self, a: u32, b: u32) {
        for (v, w) in [(a, b), (b, a)] {
            let list = &mut self.edges[v as usize];
            if let Err(at) = list.binary_search(&w) {
                list.insert(at, w);
            }
        }
    }

    /// Adds a vertex of `point` at `position`, without further properties.
    pub fn push_vertex(&mut self, point: u32, position: [f64; 3]) -> u32 {
        self.push(point, position, Some(1.0), 1.0)
    }

    /// Adds a vertex at `position`, otherwise like `model` but without evidence.
    pub fn add_vertex(&mut self, model: u32, position: [f64; 3]) -> u32 {
        let m = model as usize;
        self.push(self.points[m], position, self.penalty[m], self.corner[m])
    }

    fn push(&mut self, point: u32, position: [f64; 3], penalty: Option<f32>, corner: f32) -> u32 {
        self.points.push(point);
        self.positions.push(position);
        self.penalty.push(penalty);
        self.corner.push(corner);
        self.evidence.push(None);
        self.radius.push(0.0);
        self.edges.push(Vec::new());
        (self.edges.len() - 1) as u32
    }

    /// Length of the strip from a loose `end` to the next vertex with one edge or more than two.
    pub fn strip_length(&self, end: u32) -> f64 {
        let (mut before, mut at) = (end, self.edges[end as usize][0]);
        let step = |a: u32, b: u32| distance(self.positions[a as usize], self.positions[b as usize]);
        let mut length = step(before, at);
        while let [a, b] = *self.edges[at as usize].as_slice() {
            let next = if a == before { b } else { a };
            (before, at) = (at, next);
            length += step(before, at);
            if at == end {
                break;
            }
        }
        length
    }

    /// `(V)` whether strips end at each vertex: where one, three or more edges meet, and at the `nodes`.
    pub fn is_node(&self) -> Vec<bool> {
        let mut is_node: Vec<bool> = self.edges.iter().map(|e| !matches!(e.len(), 0 | 2)).collect();
        self.nodes
            .iter()
            .filter(|&&v| self.edges[v as usize].len() == 2)
            .for_each(|&v| is_node[v as usize] = true);
        is_node
    }

    /// Divides the edge between `a` and `b` into `pieces` edges of equal length.
    pub fn subdivide(&mut self, a: u32, b: u32, pieces: u32) {
        let [from, to] = [a, b].map(|v| self.positions[v as usize]);
        self.remove_edge(a, b);
        let mut before = a;
        for piece in 1..pieces {
            let share = f64::from(piece) / f64::from(pieces);
            let model = if share < 0.5 { a } else { b };
            let next = self.add_vertex(model, add_scaled(from, sub(to, from), share));
            self.add_edge(before, next);
            before = next;
        }
        self.add_edge(before, b);
    }

    /// Removes the edge between `a` and `b`.
    pub fn remove_edge(&mut self, a: u32, b: u32) {
        self.edges[a as usize].retain(|&x| x != b);
        self.edges[b as usize].retain(|&x| x != a);
    }
}
