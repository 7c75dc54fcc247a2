//! The features of a mesh, and how many points they need: chains of sharp edges by their extent, the faces between them by their width.

use super::canonical::Surface;
use super::sharp::Edges;
use crate::math::union_find::UnionFind;
use crate::math::vec3::{distance, dot, sub, unit};

/// Cosine of the angle between the normals of two triangles, 30 degrees, above which their edge is sharp.
const SHARP: f64 = 0.866_025;
/// Cosine of the turn at a vertex, 50 degrees, beyond which a chain of such edges ends.
const TURN: f64 = 0.642_788;
/// Spacings that the smallest features get.
const SPACINGS: f64 = 10.0;
/// Share of the length of all features that may be smaller still: slivers, which are no features.
const SLIVERS: f64 = 0.01;
/// Fewest points by default.
const FEWEST: f64 = 20_000.0;
/// Most points by default: so many for each triangle, within bounds. A mesh of few triangles has few features, however small one is.
const A_TRIANGLE: usize = 20;
const MOST: [usize; 2] = [50_000, 200_000];
/// Most points by default of a heap of facets most of whose features would not show in those either.
const A_HEAP: usize = 30_000;
/// Spacings that a chain of sharp edges needs to show as a line at all.
const SHOWN: f64 = 3.0;

/// What decides on the number of points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Features {
    /// The size of the smallest, local frame; `None` for a surface without sharp edges and borders.
    pub size: Option<f64>,
    /// The number of points at which they get ten spacings, within bounds.
    pub samples: usize,
}

impl Features {
    pub(super) fn of(surface: &Surface) -> Self {
        let edges = Edges::new(surface, SHARP);
        let chains = edges.chains(surface);
        let mut most = (A_TRIANGLE * surface.triangles.len()).clamp(MOST[0], MOST[1]);
        if is_heap(&chains, surface, most) {
            most = A_HEAP;
        }
        let widths = least(edges.widths(surface));
        let size = least(chains).map(|chain| widths.map_or(chain, |width| width.min(chain)));
        let needed = size.map_or(0.0, |size| surface.area * (SPACINGS / size).powi(2));
        Self { size, samples: needed.clamp(FEWEST, most as f64) as usize }
    }
}

/// Whether a mesh is a heap of facets, more chains of sharp edges than there are rectangles of two triangles, and less than two
/// thirds of the chains would show in so many points: boxes of sizes over many decades, needles, crumbs on a plate. More points show a few
/// more of them; what they cost is out of proportion.
fn is_heap(chains: &[(f64, f64)], surface: &Surface, points: usize) -> bool {
    let shown = SHOWN * (surface.area / points as f64).sqrt();
    let lines = chains.iter().filter(|(extent, _)| *extent >= shown).count();
    2 * chains.len() > surface.triangles.len() && 3 * lines < 2 * chains.len()
}

/// The least of sizes with their weights, once those of the slivers are left out.
fn least(mut sizes: Vec<(f64, f64)>) -> Option<f64> {
    sizes.retain(|(size, _)| *size > 0.0);
    sizes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut left = SLIVERS * sizes.iter().map(|(_, weight)| weight).sum::<f64>();
    sizes.iter().find_map(|(size, weight)| {
        left -= weight;
        (left <= 0.0).then_some(*size)
    })
}

impl Edges {
    /// The extent and the length of every chain of sharp edges.
    fn chains(&self, surface: &Surface) -> Vec<(f64, f64)> {
        let at = |v: u32| surface.vertices[v as usize];
        let mut ends: Vec<(u32, u32)> =
            self.sharp.iter().zip(0..).flat_map(|((edge, _), e)| edge.map(|v| (v, e))).collect();
        ends.sort_unstable();
        let mut sets = UnionFind::new(self.sharp.len());
        for meeting in ends.chunk_by(|a, b| a.0 == b.0) {
            let [(v, a), (_, b)] = *meeting else { continue };
            let away = |e: u32| {
                let [p, q] = self.sharp[e as usize].0;
                unit(sub(at(p + q - v), at(v)))
            };
            if -dot(away(a), away(b)) >= TURN {
                sets.union(a, b);
            }
        }
        let mut boxes = vec![([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], 0.0); self.sharp.len()];
        for (([p, q], _), e) in self.sharp.iter().zip(0..) {
            let ([low, high], length) = &mut boxes[sets.find(e) as usize];
            for point in [at(*p), at(*q)] {
                *low = std::array::from_fn(|a| low[a].min(point[a]));
                *high = std::array::from_fn(|a| high[a].max(point[a]));
            }
            *length += distance(at(*p), at(*q));
        }
        boxes
            .into_iter()
            .filter(|b| b.1 > 0.0)
            .map(|([low, high], length)| (distance(low, high), length))
            .collect()
    }

    /// The width of every face between sharp edges, twice its area over its boundary, and the length of that. A long strip has its
    /// width, a disc its radius, the wall of a hole its depth.
    fn widths(&self, surface: &Surface) -> Vec<(f64, f64)> {
        let mut sets = UnionFind::new(surface.triangles.len());
        for &[a, b] in &self.smooth {
            sets.union(a, b);
        }
        let mut faces = vec![(0.0, 0.0); surface.triangles.len()];
        for (&area, t) in surface.areas.iter().zip(0..) {
            faces[sets.find(t) as usize].0 += area;
        }
        for ([p, q], beside) in &self.sharp {
            let length = distance(surface.vertices[*p as usize], surface.vertices[*q as usize]);
            beside.iter().for_each(|&t| faces[sets.find(t) as usize].1 += length);
        }
        faces
            .into_iter()
            .filter(|face| face.1 > 0.0)
            .map(|(area, around)| (2.0 * area / around, around))
            .collect()
    }
}
