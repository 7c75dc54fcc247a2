//! What the linker leaves: a graph of points for each kind of line.

use crate::network::StripKind;

/// The crease pattern and the border pattern (Gumhold 2001, figure 1), local frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pattern {
    /// Points that creases run through.
    pub crease: LineGraph,
    /// Points that borders run through.
    pub border: LineGraph,
}

/// A graph on some of the points of the cloud.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LineGraph {
    /// `(V)` the point of the cloud that each vertex is or lies nearest to.
    pub points: Vec<u32>,
    /// `(V, 3)` where the vertex lies, which need not be where its point lies.
    pub positions: Vec<[f64; 3]>,
    /// `(V)` penalty of each vertex, 0 to 1.
    pub penalty: Vec<f32>,
    /// `(V)` how little a direction is preferred at the vertex: 0 at a corner, 1 on a line.
    pub corner: Vec<f32>,
    /// `(V)` evidence that the line is sharp, in variances of the noise; see
    /// [`Penalties`](crate::measure::Penalties).
    pub evidence: Vec<f32>,
    /// `(V)` the evidence that a sharp fold of the measured angle would give.
    pub expected: Vec<f32>,
    /// `(V)` angle between the faces, radians; zero where unknown.
    pub fold: Vec<f32>,
    /// `(V)` neighbours of each vertex in the graph, ascending.
    pub edges: Vec<Vec<u32>>,
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

    /// A new vertex at `position`, otherwise like `model` but without evidence of its own.
    pub fn add_vertex(&mut self, model: u32, position: [f64; 3]) -> u32 {
        let m = model as usize;
        self.points.push(self.points[m]);
        self.positions.push(position);
        self.penalty.push(self.penalty[m]);
        self.corner.push(self.corner[m]);
        self.evidence.push(0.0);
        self.expected.push(0.0);
        self.fold.push(0.0);
        self.edges.push(Vec::new());
        (self.edges.len() - 1) as u32
    }

    /// Takes the edge between `a` and `b` away.
    pub fn remove_edge(&mut self, a: u32, b: u32) {
        self.edges[a as usize].retain(|&x| x != b);
        self.edges[b as usize].retain(|&x| x != a);
    }
}

impl Pattern {
    /// The graph of one kind of line.
    pub fn of(&self, kind: StripKind) -> &LineGraph {
        match kind {
            StripKind::Crease => &self.crease,
            StripKind::Border => &self.border,
        }
    }
}
