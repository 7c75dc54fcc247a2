//! Meshes: the faces that readers hand on, and the points that are taken of them.

use super::{Decoded, Planned, ReadOptions, Sampled};
use lineament::mesh::{Faces, MeshPoints, plan, sample};

/// Corners up to which a face is read.
pub(super) const MOST_CORNERS: u64 = 1 << 16;

/// The number of a vertex that there is not.
pub(super) const NO_VERTEX: u32 = u32::MAX;

/// What the points of a mesh were taken of, or would be.
#[derive(Default)]
pub(super) struct Taken {
    pub sampled: Option<Sampled>,
    pub planned: Option<Planned>,
}

/// With the points that the options ask for in place of the vertices.
pub(super) fn taken(mut decoded: Decoded, options: &ReadOptions) -> (Decoded, Taken) {
    let Some(points) = options.mesh else { return (decoded, Taken::default()) };
    let faces = sound(&mut decoded);
    let chosen = options.every.is_some() || options.voxel.is_some() || options.bounds.is_some();
    let taken = if options.plan && !chosen {
        let planned = plan(&decoded.cloud.positions, &faces, points);
        Taken { planned: planned.map(|plan| Planned { faces: faces.len(), plan }), sampled: None }
    } else {
        Taken { sampled: replaced(&mut decoded, &faces, points), planned: None }
    };
    if taken.sampled.is_none() && taken.planned.is_none() {
        if !faces.is_empty() {
            decoded.ignored.push(format!("{} faces: the vertices stand for them", faces.len()));
        }
    } else if !decoded.cloud.attributes.is_empty() {
        decoded.cloud.attributes.clear();
        decoded.ignored.push("attributes of the vertices: the points lie between them".into());
    }
    (decoded, taken)
}

/// Puts points sampled over the faces in the place of the vertices, where they are to be; with how many faces these are, and their
/// spacing.
fn replaced(decoded: &mut Decoded, faces: &Faces, points: MeshPoints) -> Option<Sampled> {
    let found = sample(&decoded.cloud.positions, faces, points)?;
    decoded.cloud.positions = found.points;
    Some(Sampled { faces: faces.len(), spacing: found.spacing, feature: found.feature, folds: found.folds })
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
