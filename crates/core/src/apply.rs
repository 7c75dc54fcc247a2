//! Applications of a result (Gumhold 2001, section 5): the neighbour graph cut at the creases, points along the lines, meshes, pictures.

mod enrich;
mod graph;
mod ground;
mod meshing;
pub mod render;
mod shown;

pub use enrich::{LinePoint, enriched, line_points};
pub use graph::{CutGraph, GraphKind, cut_graph};
pub use meshing::{MeshOptions, SurfaceMesh, mesh_surface};
pub use shown::Shown;
