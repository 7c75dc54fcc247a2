//! Meshes: the faces that readers hand on, and the points that are taken of them.

use super::{Decoded, ReadOptions, by_format, detect, open};
use crate::error::Error;
use crate::format::Format;
use crate::source::Source;
use lineament::mesh::{Faces, MeshPoints, sample};
use std::path::Path;

/// Corners up to which a face is read.
pub(super) const MOST_CORNERS: u64 = 1 << 16;

/// The number of a vertex that there is not.
pub(super) const NO_VERTEX: u32 = u32::MAX;

/// A mesh as a file holds it.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// `(V, 3)` f64, in the frame and the unit of the file.
    pub vertices: Vec<[f64; 3]>,
    /// `(T, 3)` vertices of each triangle; faces of more corners are cut into fans.
    pub triangles: Vec<[u32; 3]>,
    /// What makes it doubtful that the mesh is the one that was meant, one sentence each.
    pub warnings: Vec<String>,
}

/// Reads the mesh in the file at `path`.
///
/// # Errors
/// An input that cannot be opened, is empty, of no known format, breaks its format's rules, holds no faces, or has a vertex that is not
/// finite.
pub fn read_mesh(path: &Path) -> Result<MeshFile, Error> {
    let name = path.display().to_string();
    let (mut source, length) = open(path, false)?;
    let start = source.peek(1 << 16)?.to_vec();
    if start.is_empty() {
        return Err(Error::Empty { name });
    }
    let format = detect::detect(&start, length, &name)?;
    let (decoded, faces) = with_faces(&mut source, format, "is no mesh", "give a mesh, such as PLY or STL")?;
    let vertices = decoded.cloud.positions;
    if let Some(odd) = vertices.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
        let what = format!("vertex {odd} is {:?}", vertices[odd]);
        return Err(Error::Unsupported { name, what, advice: "give finite vertices".into() });
    }
    let fan = |face: &[u32]| face.windows(2).skip(1).map(|w| [face[0], w[0], w[1]]).collect::<Vec<_>>();
    Ok(MeshFile { vertices, triangles: faces.iter().flat_map(fan).collect(), warnings: decoded.warnings })
}

/// Reads vertices and faces; refuses an input without faces, telling what it is not, and what to do.
pub(super) fn with_faces(
    source: &mut Source,
    format: Format,
    is_not: &str,
    advice: &str,
) -> Result<(Decoded, Faces), Error> {
    let options =
        ReadOptions { attributes: false, mesh: Some(MeshPoints::Vertices), ..ReadOptions::default() };
    let mut decoded = by_format(source, format, &options)?;
    let faces = sound(&mut decoded);
    if faces.is_empty() {
        let what = format!("{format} without faces {is_not}");
        return Err(Error::Unsupported { name: source.name().into(), what, advice: advice.into() });
    }
    Ok((decoded, faces))
}

/// With the points that the options ask for in place of the vertices; with how many faces they were sampled on, and their spacing.
pub(super) fn sampled(mut decoded: Decoded, options: &ReadOptions) -> (Decoded, Option<(usize, f64)>) {
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
    (decoded, Some((faces.len(), found.spacing)))
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
