//! Meshes for themselves: vertices and faces by the readers of points.

use super::mesh::sound;
use super::{Decoded, ReadOptions, by_format, detect, open};
use crate::error::Error;
use crate::format::Format;
use crate::source::Source;
use lineament::mesh::{Faces, MeshPoints};
use std::path::Path;

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
