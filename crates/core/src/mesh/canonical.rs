//! The surface of a mesh in a form that depends on where its faces lie alone: not on their order, on the numbers of the vertices,
//! on how often either is there, nor on the origin.

use rayon::prelude::*;

use super::faces::Faces;
use super::triangles;
use crate::math::vec3::{cross, norm, scale, sub};
use crate::parallel;

/// Triangles that share the vertices they meet in.
pub(super) struct Surface {
    /// `(V, 3)` the vertices that faces use, each once, ascending; local frame: the least corner is the origin and the longest side
    /// of the box lies between 1 and 2.
    pub vertices: Vec<[f64; 3]>,
    /// Triangles with an area, by their vertices, the least first, each once, ascending.
    pub triangles: Vec<[u32; 3]>,
    /// `(T)` their areas and unit normals.
    pub areas: Vec<f64>,
    pub normals: Vec<[f64; 3]>,
    /// The sum of the areas.
    pub area: f64,
    /// Local length of a world unit, a power of two, and the world position of the local origin.
    pub scale: f64,
    offset: [f64; 3],
}

/// Share of the squared extent below which the whole area is none.
const NO_AREA: f64 = 1e-20;

impl Surface {
    /// The surface of the faces whose vertices are finite; `None` if they have no area, or if a face names a vertex that there is
    /// not.
    pub(super) fn new(world: &[[f64; 3]], faces: &Faces) -> Option<Self> {
        if faces.greatest()? as usize >= world.len() {
            return None;
        }
        let finite = |face: &&[u32]| face.iter().all(|&v| world[v as usize].iter().all(|c| c.is_finite()));
        let used = || faces.iter().filter(finite).flatten().map(|&v| world[v as usize]);
        let first = used().next()?;
        let [low, high] = used().fold([first; 2], |[low, high], p| {
            [std::array::from_fn(|a| low[a].min(p[a])), std::array::from_fn(|a| high[a].max(p[a]))]
        });
        let extent = (0..3).map(|a| high[a] - low[a]).fold(0.0, f64::max);
        let scale = (-extent.log2().floor()).exp2();
        if !(extent.is_finite() && scale.is_finite() && scale > 0.0) {
            return None;
        }
        let local = |v: u32| sub(world[v as usize], low).map(|c| c * scale);
        let mut soup = Vec::with_capacity(faces.len());
        for face in faces.iter().filter(finite) {
            triangles::split(face, local, &mut soup);
        }
        let (vertices, triangles) =
            welded(parallel::map(soup.len(), parallel::QUICK, |t| soup[t].map(local)));
        Self { vertices, triangles, areas: Vec::new(), normals: Vec::new(), area: 0.0, scale, offset: low }
            .measured()
    }

    /// With areas and normals, without triangles that have no area.
    fn measured(mut self) -> Option<Self> {
        let vector = |t: usize| {
            let [a, b, c] = self.corners(&self.triangles[t]);
            scale(cross(sub(b, a), sub(c, a)), 0.5)
        };
        let vectors = parallel::map(self.triangles.len(), parallel::QUICK, vector);
        let mut areas = vectors.iter().map(|&v| norm(v));
        self.triangles.retain(|_| areas.next().is_some_and(|area| area > 0.0));
        let kept = vectors.into_iter().filter(|&v| norm(v) > 0.0);
        (self.areas, self.normals) = kept.map(|v| (norm(v), scale(v, 1.0 / norm(v)))).unzip();
        self.area = self.areas.iter().sum();
        (self.area > NO_AREA).then_some(self)
    }

    /// The corners of a triangle.
    pub(super) fn corners(&self, triangle: &[u32; 3]) -> [[f64; 3]; 3] {
        triangle.map(|v| self.vertices[v as usize])
    }

    /// The world coordinates of a local point.
    pub(super) fn to_world(&self, local: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|a| self.offset[a] + local[a] / self.scale)
    }
}

fn order(a: &[f64; 3], b: &[f64; 3]) -> std::cmp::Ordering {
    let by = |axis: usize| a[axis].total_cmp(&b[axis]);
    by(0).then_with(|| by(1)).then_with(|| by(2))
}

/// Vertices once each, and triangles as their numbers, once each; of those that differ by their sense of rotation one stays.
fn welded(soup: Vec<[[f64; 3]; 3]>) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let mut vertices: Vec<[f64; 3]> = soup.iter().flatten().copied().collect();
    vertices.par_sort_unstable_by(order);
    vertices.dedup();
    let number = |p: &[f64; 3]| vertices.partition_point(|v| order(v, p).is_lt()) as u32;
    let numbered = |t: usize| {
        let [a, b, c] = soup[t].each_ref().map(number);
        if a <= b && a <= c {
            [a, b, c]
        } else if b <= c {
            [b, c, a]
        } else {
            [c, a, b]
        }
    };
    let mut triangles = parallel::map(soup.len(), parallel::QUICK, numbered);
    let set = |t: &[u32; 3]| [t[0], t[1].min(t[2]), t[1].max(t[2])];
    triangles.par_sort_unstable_by_key(|t| (set(t), *t));
    triangles.dedup_by_key(|t| set(t));
    (vertices, triangles)
}
