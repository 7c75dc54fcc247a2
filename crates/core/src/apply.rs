//! Applications of a result (Gumhold 2001, section 5): the neighbour graph cut at the creases, pictures.

mod graph;
mod ground;
pub mod render;

pub use graph::{CutGraph, cut_graph};
