//! Meshes: the faces that readers hand on, and the points that are taken of them.

use super::{Decoded, ReadOptions, Sampled};
use lineament::mesh::{Faces, sample};

/// Corners up to which a face is read.
pub(super) const MOST_CORNERS: u64 = 1 << 16;

/// The number of a vertex that there is not.
pub(super) const NO_VERTEX: u32 = u32::MAX;

/// With the points that the options ask for in place of the vertices; with how many faces they were sampled on, and their spacing.
pub(super) fn sampled(mut decoded: Decoded, options: &ReadOptions) -> (Decoded, Option<Sampled>) {
    let Some(points) = options.mesh else { return (decoded, None) };
    let faces = sound(&mut decoded);
    let Some(found) = sample(&decoded.cloud.positions, &faces, points) else {
        if !faces.is_empty() {
            decoded.ignored.push(format!("{} faces: the vertices stand for them", faces.len()));
        }
        return (decoded, None);
    };
    if !decoded.cloud.attributes.is_empty() {
        decoded.cloud.attributes.clear();
        decoded.ignored.push("attributes of the vertices: the points lie between them".into());
    }
    decoded.cloud.positions = found.points;
    (decoded, Some(Sampled { faces: faces.len(), spacing: found.spacing, folds: found.folds }))
}

/// Takes the faces whose vertices are all there, and warns of the others.
pub(super) fn sound(decoded: &mut Decoded) -> Faces {
    let points = decoded.cloud.len();
    let mut faces = std::mem::take(&mut decoded.faces);
    if faces.greatest().is_some_and(|most| most as usize >= points) {
        let mut kept = Faces::default();
        faces
            .iter()
            .filter(|face| face.iter().all(|&v| (v as usize) < points))
            .for_each(|face| kept.push(face));
        decoded.odd_faces += (faces.len() - kept.len()) as u64;
        faces = kept;
    }
    if decoded.odd_faces > 0 {
        let what = format!("{} faces without vertices that exist: they are left out", decoded.odd_faces);
        decoded.warnings.push(what);
    }
    faces
}
