//! Meshes of triangles: one file for each format.

mod glb;
mod obj;
mod off;
mod ply;
mod stl;

use crate::error::Error;
use crate::format::{MeshFormat, mesh_format};
use crate::output::Output;
use lineament::apply::SurfaceMesh;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes a mesh to a file, whole or not at all, in the format of the extension. `path` must be none of `inputs`.
///
/// # Errors
/// Those of [`mesh_format`] and [`Output::create`], a failed write, and [`Error::Inconsistent`] for a corner that is not there.
pub fn write_mesh(path: &Path, inputs: &[PathBuf], mesh: &SurfaceMesh) -> Result<(), Error> {
    let format = mesh_format(path)?;
    let count = mesh.vertices.len();
    let missing = mesh.triangles.iter().flatten().find(|&&corner| corner as usize >= count);
    let what = match missing {
        Some(corner) => Some(format!("a triangle has the corner {corner} of {count}")),
        None if mesh.kinds.len() != count => Some(format!("{} kinds of {count} vertices", mesh.kinds.len())),
        None => None,
    };
    match what {
        Some(what) => Err(Error::Inconsistent { name: path.display().to_string(), what }),
        None => Output::whole(path, inputs, |out| write_mesh_to(out, format, mesh)),
    }
}

/// Writes a mesh to a stream; its corners are there.
///
/// # Errors
/// Those of the stream.
pub fn write_mesh_to(out: &mut dyn Write, format: MeshFormat, mesh: &SurfaceMesh) -> io::Result<()> {
    match format {
        MeshFormat::Ply => ply::write(out, mesh),
        MeshFormat::Obj => obj::write(out, mesh),
        MeshFormat::Stl => stl::write(out, mesh),
        MeshFormat::Off => off::write(out, mesh),
        MeshFormat::Glb => glb::write(out, mesh),
    }
}
