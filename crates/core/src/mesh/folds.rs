//! The edges at which the faces of a mesh fold.

use super::canonical::Surface;
use super::sharp::Edges;
use crate::math::vec3::{add_scaled, dot, norm, scale, sub};

/// Cosine of the least fold that is told, 5 degrees.
const SMOOTH: f64 = 0.996_195;

/// An edge at which two triangles of a mesh fold by five degrees or more, in the frame and unit of the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Fold {
    /// Its vertices.
    pub ends: [[f64; 3]; 2],
    /// Unit directions of both triangles away from the edge, across it.
    pub arms: [[f64; 3]; 2],
    /// The height of the lower triangle over the edge: what is flatter says less of its plane.
    pub height: f64,
}

impl Fold {
    /// The turn from one triangle to the other, radians: 0 where they are one plane.
    pub fn turn(&self) -> f64 {
        let [a, b] = self.arms;
        (-dot(a, b).clamp(-1.0, 1.0)).acos()
    }
}

/// The edges with two triangles that fold, world frame; in an order that depends on the surface alone. Edges of one triangle or of more than
/// two are left out: where faces of different files or solids meet they say nothing.
pub(super) fn folds(surface: &Surface) -> Vec<Fold> {
    let edges = Edges::new(surface, SMOOTH);
    edges.sharp.iter().filter_map(|(edge, beside)| fold(surface, *edge, beside)).collect()
}

fn fold(surface: &Surface, edge: [u32; 2], beside: &[u32]) -> Option<Fold> {
    let &[a, b] = beside else { return None };
    let [p, q] = edge.map(|v| surface.vertices[v as usize]);
    let length = norm(sub(q, p));
    let along = scale(sub(q, p), 1.0 / length);
    let across = |t: u32| {
        let third = surface.triangles[t as usize].into_iter().find(|v| !edge.contains(v))?;
        let side = sub(surface.vertices[third as usize], p);
        let across = add_scaled(side, along, -dot(side, along));
        let height = norm(across);
        (height > 0.0).then(|| (scale(across, 1.0 / height), height))
    };
    let (first, second) = (across(a)?, across(b)?);
    let ends = [p, q].map(|end| surface.to_world(end));
    Some(Fold { ends, arms: [first.0, second.0], height: first.1.min(second.1) / surface.scale })
}
