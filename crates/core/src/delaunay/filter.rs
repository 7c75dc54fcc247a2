//! All steps of the filter.

use super::facets::{Facet, facets};
use super::long::without_long;
use super::tetrahedra::{scattered, tetrahedra};
use super::triangle::Triangle;
use super::umbrella::umbrella;
use crate::error::Error;

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
/// use lineament::shapes::{self, Sampling, Scan};
///
/// let sphere = shapes::sphere(3.0).sample(&Scan::new(Sampling::BlueNoise { count: 900 }).seed(6)).cloud.positions;
/// let filtered = lineament::delaunay::filter(&sphere)?;
/// // Twice as many triangles as points, less four: a closed surface.
/// assert_eq!(filtered.triangles.len(), 2 * 900 - 4);
/// # Ok::<(), lineament::Error>(())
/// ```
///
/// # Errors
/// [`Error::TooFewPoints`] for less than four points, or points of which no four span a tetrahedron.
pub fn filter(points: &[[f64; 3]]) -> Result<Filtered, Error> {
    let start = std::time::Instant::now();
    let points = &scattered(points);
    let tetrahedra = tetrahedra(points)?;
    let first = start.elapsed().as_secs_f64();
    let gabriel: Vec<Facet> = facets(points, &tetrahedra).into_iter().filter(|f| f.gabriel).collect();
    let umbrella = umbrella(points.len(), &gabriel);
    let triangles = without_long(points, &umbrella);
    let seconds = [first, start.elapsed().as_secs_f64() - first];
    Ok(Filtered { tetrahedra: tetrahedra.len(), gabriel: gabriel.len(), umbrella, triangles, seconds })
}
