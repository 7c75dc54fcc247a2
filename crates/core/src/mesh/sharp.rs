//! The edges of a mesh, smooth or sharp by the angle between their triangles.

use super::canonical::Surface;
use crate::math::vec3::dot;

/// Edges between triangles.
pub(super) struct Edges {
    /// Vertices of sharp edges and borders, and the triangles beside them.
    pub sharp: Vec<([u32; 2], Vec<u32>)>,
    /// Pairs of triangles that an edge joins smoothly.
    pub smooth: Vec<[u32; 2]>,
}

impl Edges {
    /// An edge is smooth where two triangles meet whose normals have at least this cosine, as they stand in one sense.
    pub fn new(surface: &Surface, smooth_from: f64) -> Self {
        let sides = |(t, v): (usize, &[u32; 3])| {
            let side = |i: usize, j: usize| ([v[i].min(v[j]), v[i].max(v[j])], t as u32, v[i] < v[j]);
            [side(0, 1), side(1, 2), side(2, 0)]
        };
        let mut all: Vec<([u32; 2], u32, bool)> =
            surface.triangles.iter().enumerate().flat_map(sides).collect();
        all.sort_unstable();
        let (mut sharp, mut smooth) = (Vec::new(), Vec::new());
        for beside in all.chunk_by(|a, b| a.0 == b.0) {
            match beside {
                [(_, a, up), (_, b, down)] if cosine(surface, *a, *b, up == down) >= smooth_from => {
                    smooth.push([*a, *b])
                }
                _ => sharp.push((beside[0].0, beside.iter().map(|side| side.1).collect())),
            }
        }
        Self { sharp, smooth }
    }
}

/// The cosine of the angle between the normals of two triangles; `same` says that both run along their edge in one sense, so that one
/// of them is the wrong way round.
fn cosine(surface: &Surface, a: u32, b: u32, same: bool) -> f64 {
    let [n, m] = [a, b].map(|t| surface.normals[t as usize]);
    if same { -dot(n, m) } else { dot(n, m) }
}
