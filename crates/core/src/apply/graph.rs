//! The neighbour graph without the edges that cross a crease (Gumhold 2001, section 5.1): "we can easily remove all edges that
//! cut the creases and corners. Thus our feature extraction stage not only produces the feature lines for the point cloud mesher,
//! but also a sophisticated neighbor graph."
//!
//! The paper takes the groups of its wedge and corner fits for this (sections 4.1 and 4.2). Here the sides of a strip are those
//! that patches are flooded by: the half-lines in which the surface leaves the strip in its cross-section, and beside the strip
//! itself, where its own error would decide, the tangent planes of both sides.

use super::ground::Terrain;
use crate::delaunay;
use crate::error::Error;
use crate::extract::Extraction;
use crate::parallel;
use crate::params::Params;
use crate::patch::Crossing;

/// The edges of the neighbour graph, as pairs of indices of the input: the lesser first, in ascending order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CutGraph {
    /// `(E, 2)` edges along the surface.
    pub edges: Vec<[u32; 2]>,
    /// `(C, 2)` edges that lead from one side of a crease to the other.
    pub cut: Vec<[u32; 2]>,
}

/// Which graph is cut.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum GraphKind {
    /// The Riemannian graph: of each point the edges to its `neighbors.k` nearest.
    #[default]
    Riemannian,
    /// The edges of the filtered Delaunay triangles: about three for each point, none between parts that lie apart.
    Delaunay,
}

/// The neighbour graph of `world`, the `(N, 3)` positions that `found` was extracted from by `params`, parted into the edges
/// along the surface and those that cross a line of `found`. Points that were dropped and clutter have no edges; of points at
/// one place one has them all.
///
/// # Errors
/// [`Error::TooFewPoints`] for a Delaunay graph of points of which no four span a tetrahedron.
///
/// ```
/// use lineament::{Params, extract, shapes};
/// use lineament::apply::{GraphKind, cut_graph};
///
/// let cloud = shapes::cube_386().cloud;
/// let found = extract(&cloud, &Params::default())?;
/// let graph = cut_graph(&cloud, &found, &Params::default(), GraphKind::Riemannian)?;
/// assert!(!graph.cut.is_empty() && graph.edges.len() > graph.cut.len());
/// # Ok::<(), lineament::Error>(())
/// ```
pub fn cut_graph(
    world: &(impl AsRef<[[f64; 3]]> + ?Sized),
    found: &Extraction,
    params: &Params,
    kind: GraphKind,
) -> Result<CutGraph, Error> {
    let mut terrain = Terrain::new(world.as_ref(), found, params);
    if kind == GraphKind::Delaunay {
        terrain.graph = delaunay::graph(&terrain.positions)?;
    }
    let crossing =
        (!terrain.network.strips.is_empty()).then(|| Crossing::new(&terrain.ground(), &terrain.network));
    let crosses = |i: usize, j: usize| crossing.as_ref().is_some_and(|c| c.between(i, j));
    let mut all = parallel::flat_map(terrain.positions.len(), parallel::QUICK, |i, all| {
        let of_one = |&j: &u32| terrain.graph.of(j as usize).contains(&(i as u32));
        // An edge to a stray point stands in one list alone.
        let once = |j: &&u32| **j as usize > i || !of_one(j);
        for &j in terrain.graph.of(i).iter().filter(once) {
            let ends = [found.source[i], found.source[j as usize]];
            all.push(([ends[0].min(ends[1]), ends[0].max(ends[1])], crosses(i, j as usize)));
        }
    });
    all.sort_unstable();
    let of = |cut: bool| all.iter().filter(|(_, c)| *c == cut).map(|(edge, _)| *edge).collect();
    Ok(CutGraph { edges: of(false), cut: of(true) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::extract::extract;
    use crate::shapes::{Sampling, Scan, cube};

    /// The face of a cube of edge 10 from `low` on that is nearest to a point, and the distances of the next two.
    fn faces(p: [f64; 3], low: f64) -> (usize, f64, f64) {
        let off = |face: usize| (p[face % 3] - low - if face > 2 { 10.0 } else { 0.0 }).abs();
        let mut order = [0, 1, 2, 3, 4, 5];
        order.sort_by(|&a, &b| off(a).total_cmp(&off(b)));
        (order[0], off(order[1]), off(order[2]))
    }

    #[test]
    fn no_edge_joins_two_faces_of_a_cube_and_hardly_any_other_is_lost() {
        let cloud = cube(10.0).sample(&Scan::new(Sampling::BlueNoise { count: 4000 }).seed(2)).cloud;
        let low = cloud.positions.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min).round();
        let params = Params::default();
        let found = extract(&cloud, &params).unwrap();
        let graph = cut_graph(&cloud, &found, &params, GraphKind::Riemannian).unwrap();
        // A point on an edge of the cube belongs to both faces; within a spacing of a corner the lines are not yet apart.
        let faces = |i: u32| faces(cloud.positions[i as usize], low);
        let of = |i: u32| Some(faces(i)).filter(|f| f.1 > 0.02).map(|f| f.0);
        let joins = |e: &&[u32; 2]| matches!((of(e[0]), of(e[1])), (Some(a), Some(b)) if a != b);
        let amid = |e: &&[u32; 2]| e.iter().all(|&i| faces(i).2 > found.report.spacing);
        let crossing = graph.cut.iter().filter(joins).count();
        let kept = graph.edges.iter().filter(joins).filter(amid).count();
        assert!(crossing > 1000, "{crossing}");
        assert!(200 * kept <= crossing, "{kept} of {crossing} are left");
        let lost = graph.cut.len() - crossing;
        assert!(50 * lost <= graph.edges.len(), "{lost} of {} are lost", graph.edges.len());
    }

    #[test]
    fn the_graph_of_a_smooth_surface_is_whole() {
        let cloud =
            crate::shapes::sphere(3.0).sample(&Scan::new(Sampling::BlueNoise { count: 800 }).seed(2)).cloud;
        let found = extract(&cloud, &Params::default()).unwrap();
        let of = |kind| cut_graph(&cloud, &found, &Params::default(), kind).unwrap();
        // Euler's formula for a closed surface of triangles.
        assert_eq!(of(GraphKind::Delaunay).edges.len(), 3 * 800 - 6);
        let graph = of(GraphKind::Riemannian);
        assert!(graph.cut.is_empty() && graph.edges.len() > 800 * 12 / 2);
        assert!(graph.edges.windows(2).all(|w| w[0] < w[1]) && graph.edges.iter().all(|e| e[0] < e[1]));
    }
}
