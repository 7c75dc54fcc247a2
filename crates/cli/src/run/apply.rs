//! The applications of lines: graphs, enriched clouds, meshes.

pub mod enrich;
pub mod graph;
pub mod mesh;
