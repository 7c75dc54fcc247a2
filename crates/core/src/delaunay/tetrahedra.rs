//! The Delaunay tetrahedra of a cloud. The library stands behind this file alone.
//!
//! Points on one sphere, as those of a grid are, have many triangulations, and those that the library chooses need not fit
//! together as a surface. So every point is moved by a chance offset far below the spacing beforehand, and all tests that follow are
//! of the points as they were moved.

use simple_delaunay_lib::delaunay_3d::delaunay_struct_3d::DelaunayStructure3D;
use simple_delaunay_lib::delaunay_3d::simplicial_struct_3d::Node;

use crate::error::Error;

/// Greatest offset on each axis, as a share of the mean distance between points that fill their box as a surface.
const OFFSET: f64 = 1e-6;
/// Points of a tetrahedron.
const CORNERS: usize = 4;

/// `(T, 4)` the tetrahedra over distinct, finite points in general position, `(N, 3)`, such as [`scattered`] makes them.
///
/// # Errors
/// [`Error::TooFewPoints`] for points of which no four span a tetrahedron.
pub(crate) fn tetrahedra(points: &[[f64; 3]]) -> Result<Vec<[u32; 4]>, Error> {
    let too_few = || Error::TooFewPoints { read: points.len(), distinct: points.len(), needed: CORNERS };
    if points.len() < CORNERS {
        return Err(too_few());
    }
    let mut structure = DelaunayStructure3D::new();
    structure.insert_vertices(&points.to_vec(), true).map_err(|_| too_few())?;
    let simplices = structure.get_simplicial();
    let mut found = Vec::with_capacity(7 * points.len());
    for t in 0..simplices.get_nb_tetrahedra() {
        let nodes = simplices.get_tetrahedron(t).map_err(|_| too_few())?.nodes();
        let mut corners = [0; 4];
        let finite = nodes.iter().zip(&mut corners).all(|(node, corner)| match node {
            Node::Value(index) => {
                *corner = *index as u32;
                true
            }
            Node::Infinity => false,
        });
        if finite {
            found.push(corners);
        }
    }
    Ok(found)
}

/// The points with chance offsets, which depend on their places in the list alone.
pub(crate) fn scattered(points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let bounds = |axis: usize| {
        let along = points.iter().map(|p| p[axis]);
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    };
    let [x, y, z] = [0, 1, 2].map(|axis| bounds(axis)[1] - bounds(axis)[0]);
    let spacing = ((x * y + y * z + z * x) / points.len() as f64).sqrt();
    let offset = |number: u64| OFFSET * spacing * (2.0 * chance(number) - 1.0);
    let moved =
        |(p, i): (&[f64; 3], u64)| [p[0] + offset(3 * i), p[1] + offset(3 * i + 1), p[2] + offset(3 * i + 2)];
    points.iter().zip(0..).map(moved).collect()
}

/// A number from 0 to 1 that follows from another as if by chance (G. Steele, D. Lea and C. Flood, "Fast splittable pseudorandom
/// number generators", OOPSLA 2014).
fn chance(number: u64) -> f64 {
    let mut z = number.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}
