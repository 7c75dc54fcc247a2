//! Meshes with the creases of a result as edges (Gumhold 2001, sections 5.1 and 5.2): the filtered Delaunay triangles of the
//! enriched cloud, with the third filter that the paper proposes, "that removes triangles, that interconnected different sides of a
//! crease".
//!
//! 1. `vertices`: the points, thinned beside the lines, and points on the lines;
//! 2. `crate::delaunay`: the triangles of their Delaunay tetrahedra;
//! 3. `filters`: without long edges, and without those that cross a line;
//! 4. `grow`: a manifold out of them, most plausible triangles first;
//! 5. `finish`: fans that touch in a vertex parted, small gaps filled (`fill`), and every part turned outwards.

mod fill;
mod filters;
mod finish;
mod grow;
mod make;
mod surface_mesh;
mod vertices;

pub use make::{MeshOptions, mesh_surface};
pub use surface_mesh::SurfaceMesh;

#[cfg(test)]
mod tests;
