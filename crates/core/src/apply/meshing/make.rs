//! The steps to a mesh.

use super::filters::candidates;
use super::finish::finish;
use super::grow::grow;
use super::surface_mesh::SurfaceMesh;
use super::vertices::Vertices;
use crate::apply::ground::Terrain;
use crate::delaunay::{facets, scattered, tetrahedra};
use crate::error::Error;
use crate::extract::Extraction;
use crate::measure::Class;
use crate::params::Params;

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
    let points = scattered(&vertices.points);
    let candidates = candidates(&points, &facets(&points, &tetrahedra(&points)?), crossing.as_ref());
    let grown = grow(&points, &candidates, |i| vertices.kinds[i] != Class::Smooth);
    let across = |i, j| crossing.as_ref().is_some_and(|crossing| crossing.between(i, j));
    Ok(finish(&vertices, grown, across, |p| found.frame.to_world(p)))
}
