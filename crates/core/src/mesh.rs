//! Meshes as inputs: the lines at which their faces meet at an angle; and where their vertices are too few to show the surface, points
//! sampled over the faces.
//!
//! A CAD program writes a box with eight vertices and twelve triangles: the surface is there, but not in the vertices. The
//! mesh of a scan, on the other hand, has a vertex wherever the scanner measured a point.

mod canonical;
mod dense;
mod edges;
mod eliminate;
mod faces;
mod features;
mod folds;
mod scatter;
mod sharp;
mod triangles;

pub use edges::{MeshLine, lines};
pub use faces::Faces;
pub use folds::Fold;

use canonical::Surface;
use features::Features;

/// The points to take of a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeshPoints {
    /// The vertices where they are dense, otherwise points sampled over the faces, as many as their features need.
    #[default]
    Auto,
    /// The vertices alone.
    Vertices,
    /// So many points sampled over the faces.
    Sampled(usize),
}

/// Points sampled over the faces of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshSample {
    /// `(N, 3)` f64, world frame.
    pub points: Vec<[f64; 3]>,
    /// Mean distance of neighbouring points, unit of the input.
    pub spacing: f64,
    /// The size of the smallest features, unit of the input, where the mesh has any: the extent of sharp edges, the width of the
    /// faces between them.
    pub feature: Option<f64>,
    /// The edges at which its faces fold, world frame.
    pub folds: Vec<Fold>,
}

/// What sampling a mesh would give, without the points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshPlan {
    /// The number of points; fewer stay where faces lie on each other.
    pub points: usize,
    /// Mean distance of neighbouring points, unit of the input.
    pub spacing: f64,
    /// The size of the smallest features, as [`MeshSample::feature`].
    pub feature: Option<f64>,
}

/// The most points that can be asked for.
pub const MOST_SAMPLES: usize = 2_000_000;

/// Samples the faces of a mesh if that is asked for, or needed; `None` where the vertices are to be taken: as that was asked for,
/// as they are dense, or as the faces have no area.
///
/// The points are a blue noise. They do not depend on the order of faces and vertices, on faces that are there twice, or on the
/// place of the origin. `vertices` is `(V, 3)` f64, world frame.
pub fn sample(vertices: &[[f64; 3]], faces: &Faces, points: MeshPoints) -> Option<MeshSample> {
    let (surface, count, feature) = planned(vertices, faces, points)?;
    let candidates = scatter::scatter(&surface, scatter::FACTOR * count);
    let kept = eliminate::eliminate(&candidates, surface.area, count);
    let points: Vec<[f64; 3]> =
        kept.iter().map(|&i| surface.to_world(candidates[i as usize].position)).collect();
    let spacing = spacing(&surface, points.len());
    let feature = feature.map(|size| size / surface.scale);
    Some(MeshSample { points, spacing, feature, folds: folds::folds(&surface) })
}

/// How many points [`sample`] would take, at a small part of its cost; `None` where it takes the vertices.
pub fn plan(vertices: &[[f64; 3]], faces: &Faces, points: MeshPoints) -> Option<MeshPlan> {
    let (surface, points, feature) = planned(vertices, faces, points)?;
    let spacing = spacing(&surface, points);
    Some(MeshPlan { points, spacing, feature: feature.map(|size| size / surface.scale) })
}

/// The surface to sample, with how many points, and the size of its smallest features, local frame.
fn planned(
    vertices: &[[f64; 3]],
    faces: &Faces,
    points: MeshPoints,
) -> Option<(Surface, usize, Option<f64>)> {
    if points == MeshPoints::Vertices || faces.is_empty() {
        return None;
    }
    let surface = Surface::new(vertices, faces)?;
    let Features { size: feature, samples } = Features::of(&surface);
    let count = match points {
        MeshPoints::Sampled(count) => count.clamp(1, MOST_SAMPLES),
        _ if dense::is_dense(&surface, feature) => return None,
        _ => samples,
    };
    Some((surface, count, feature))
}

/// Mean distance of so many points on the surface, unit of the input.
fn spacing(surface: &Surface, points: usize) -> f64 {
    (surface.area / points.max(1) as f64).sqrt() / surface.scale
}

#[cfg(test)]
mod tests;
