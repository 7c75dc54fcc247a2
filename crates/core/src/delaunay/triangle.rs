//! Triangles and their edges.

/// A triangle by its corners, ascending.
pub type Triangle = [u32; 3];

/// The edges of a triangle, the lesser end first.
pub(super) fn edges_of(&[a, b, c]: &Triangle) -> [[u32; 2]; 3] {
    [[a, b], [a, c], [b, c]]
}

/// The edges of triangles, ascending.
pub(super) fn edges(triangles: &[Triangle]) -> Vec<[u32; 2]> {
    let mut edges: Vec<[u32; 2]> = triangles.iter().flat_map(edges_of).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}
