//! The mesh: the result.

use crate::measure::Class;

/// A mesh of triangles, a manifold: an edge has one or two of them, and those at a vertex form one fan.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceMesh {
    /// `(V, 3)` f64, world frame.
    pub vertices: Vec<[f64; 3]>,
    /// `(V)` [`Class::Smooth`] for a point of the input, the kind of line for others.
    pub kinds: Vec<Class>,
    /// `(T, 3)` vertices of each triangle, counter-clockwise seen from outside. A part that is not closed has its outside away
    /// from its middle.
    pub triangles: Vec<[u32; 3]>,
}

impl SurfaceMesh {
    /// The number of edges of one triangle.
    pub fn open_edges(&self) -> usize {
        let mut edges: Vec<[u32; 2]> = self.triangles.iter().flat_map(edges).collect();
        edges.sort_unstable();
        edges.chunk_by(|a, b| a == b).filter(|uses| uses.len() == 1).count()
    }
}

/// The edges of a triangle, the lesser end first.
pub(super) fn edges(&[a, b, c]: &[u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)])
}
