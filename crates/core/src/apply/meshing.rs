//! Meshes with the creases of a result as edges (Gumhold 2001, sections 5.1 and 5.2): the filtered Delaunay triangles of the
//! enriched cloud, with the third filter that the paper proposes, "that removes triangles, that interconnected different sides of a
//! crease".
//!
//! 1. `vertices`: the points, thinned beside the lines, and points on the lines;
//! 2. `crate::delaunay`: the triangles of their Delaunay tetrahedra;
//! 3. `filters`: without long edges, and without those that cross a line;
//! 4. `grow`: a manifold out of them, most plausible triangles first;
//! 5. `finish`: fans that touch in a vertex parted, and every part turned outwards.

mod filters;
mod finish;
mod grow;
mod vertices;

use super::ground::Terrain;
use crate::delaunay::{facets, tetrahedra};
use crate::error::Error;
use crate::extract::Extraction;
use crate::measure::Class;
use crate::params::Params;
use vertices::Vertices;

/// How a mesh is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshOptions {
    /// Distance between the vertices along a line, in spacings of the cloud there; `None` puts none there.
    pub step: Option<f64>,
    /// Whether triangles that join two sides of a line are left out.
    pub apart: bool,
}

impl Default for MeshOptions {
    fn default() -> Self {
        MeshOptions { step: Some(0.7), apart: true }
    }
}

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
        let mut edges: Vec<[u32; 2]> = self.triangles.iter().flat_map(|t| finish::edges(t)).collect();
        edges.sort_unstable();
        edges.chunk_by(|a, b| a == b).filter(|uses| uses.len() == 1).count()
    }
}

/// A mesh over `world`, the `(N, 3)` positions that `found` was extracted from by `params`, whose edges follow the lines of `found`.
///
/// ```
/// use lineament::{Params, extract, shapes};
/// use lineament::apply::{MeshOptions, mesh_surface};
///
/// let cloud = shapes::cube_386().cloud;
/// let params = Params::default();
/// let mesh = mesh_surface(&cloud, &extract(&cloud, &params)?, &params, &MeshOptions::default())?;
/// assert_eq!(mesh.open_edges(), 0);
/// # Ok::<(), lineament::Error>(())
/// ```
///
/// # Errors
/// [`Error::TooFewPoints`] for points of which no four span a tetrahedron.
pub fn mesh_surface(
    world: &(impl AsRef<[[f64; 3]]> + ?Sized),
    found: &Extraction,
    params: &Params,
    options: &MeshOptions,
) -> Result<SurfaceMesh, Error> {
    let terrain = Terrain::new(world.as_ref(), found, params);
    let vertices = Vertices::new(&terrain, found, options.step);
    let crossing = options.apart.then(|| vertices.crossing(&terrain, params)).flatten();
    let tetrahedra = tetrahedra(&vertices.points)?;
    let kept = filters::kept(&vertices.points, facets(&vertices.points, &tetrahedra), crossing.as_ref());
    let grown = grow::grow(&vertices.points, &kept, |i| vertices.kinds[i] != Class::Smooth);
    Ok(finish::finish(&vertices, grown, |p| found.frame.to_world(p)))
}

#[cfg(test)]
mod tests;
