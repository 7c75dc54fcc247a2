//! Contours as rings of vertices.

use lineament::section::Contour;

/// Vertex indices of a contour in order, the first again at the end of a closed one; `first` is its first vertex.
pub(super) fn ring(contour: &Contour, first: usize) -> impl Iterator<Item = usize> {
    let n = contour.points.len();
    (first..first + n).chain(contour.closed.then_some(first))
}
