//! Delaunay filtering (Gumhold 2001, section 2.1): from the Delaunay tetrahedra of a cloud to the triangles of its surface.
//!
//! 1. `tetrahedra`: the tetrahedra, by a library;
//! 2. `facets`: their triangles, each with the radius of the least empty sphere through its corners, and whether it belongs to
//!    the Gabriel complex;
//! 3. `umbrella`: at each point the first closed fan of Gabriel triangles in ascending order of radius (Adamy, Giesen and John 2000,
//!    simplified as in the paper);
//! 4. `long`: without the triangles of extraordinarily long edges.

mod facets;
mod graph;
mod long;
mod tetrahedra;
mod umbrella;

pub(crate) use facets::{Facet, facets};
pub(crate) use graph::graph;
pub(crate) use long::averages;
pub(crate) use tetrahedra::tetrahedra;
pub(crate) use umbrella::umbrella;

use crate::error::Error;

/// A triangle by its corners, ascending.
pub type Triangle = [u32; 3];

/// The steps of the filter.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Filtered {
    /// Number of tetrahedra.
    pub tetrahedra: usize,
    /// Number of triangles of the Gabriel complex.
    pub gabriel: usize,
    /// `(U, 3)` triangles of the umbrella filter, ascending; without a hole, and with triangles between parts that lie apart.
    pub umbrella: Vec<Triangle>,
    /// `(T, 3)` those of them without extraordinarily long edges.
    pub triangles: Vec<Triangle>,
    /// Seconds for the tetrahedra, and for the filters.
    pub seconds: [f64; 2],
}

/// Filters the Delaunay triangles of distinct, finite points, `(N, 3)`.
///
/// ```
/// let cube = lineament::shapes::cube_386().cloud.positions;
/// let filtered = lineament::delaunay::filter(&cube)?;
/// // Twice as many triangles as points, less four: a closed surface.
/// assert_eq!(filtered.triangles.len(), 2 * cube.len() - 4);
/// # Ok::<(), lineament::Error>(())
/// ```
///
/// # Errors
/// [`Error::TooFewPoints`] for less than four points, or points of which no four span a tetrahedron.
pub fn filter(points: &[[f64; 3]]) -> Result<Filtered, Error> {
    let start = std::time::Instant::now();
    let tetrahedra = tetrahedra(points)?;
    let first = start.elapsed().as_secs_f64();
    let gabriel: Vec<Facet> = facets(points, &tetrahedra).into_iter().filter(|f| f.gabriel).collect();
    let umbrella = umbrella(points.len(), &gabriel);
    let triangles = long::without_long(points, &umbrella);
    let seconds = [first, start.elapsed().as_secs_f64() - first];
    Ok(Filtered { tetrahedra: tetrahedra.len(), gabriel: gabriel.len(), umbrella, triangles, seconds })
}

#[cfg(test)]
mod tests;
