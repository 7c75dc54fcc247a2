//! Delaunay filtering (Gumhold 2001, section 2.1): from the Delaunay tetrahedra of a cloud to the triangles of its surface.
//!
//! 1. `tetrahedra`: the tetrahedra, by a library;
//! 2. `facets`: their triangles, each with the radius of the least empty sphere through its corners, and whether it belongs to
//!    the Gabriel complex;
//! 3. `umbrella`: at each point the first closed fan of Gabriel triangles in ascending order of radius (Adamy, Giesen and John 2000,
//!    simplified as in the paper);
//! 4. `long`: without the triangles of extraordinarily long edges.

mod facets;
mod filter;
mod graph;
mod long;
mod tetrahedra;
mod triangle;
mod umbrella;

pub(crate) use facets::{Facet, facets};
pub use filter::{Filtered, filter};
pub(crate) use graph::graph;
pub(crate) use long::usual_lengths;
pub(crate) use tetrahedra::{scattered, tetrahedra};
pub use triangle::Triangle;
pub(crate) use umbrella::umbrella;

#[cfg(test)]
mod tests;
