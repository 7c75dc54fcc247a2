//! The command lines of the applications of lines: graphs, enriched clouds, meshes.

mod enrich;
mod graph;
mod mesh;

pub use enrich::{ABOUT as ENRICH, Enrich};
pub use graph::{ABOUT as GRAPH, Graph};
pub use mesh::{ABOUT as MESH, Mesh};
