//! A mesh as OFF.

use lineament::apply::SurfaceMesh;
use std::io::{self, Write};

/// Writes vertices and faces.
pub(super) fn write(out: &mut dyn Write, mesh: &SurfaceMesh) -> io::Result<()> {
    writeln!(out, "OFF\n{} {} 0", mesh.vertices.len(), mesh.triangles.len())?;
    for [x, y, z] in &mesh.vertices {
        writeln!(out, "{x:?} {y:?} {z:?}")?;
    }
    for [a, b, c] in &mesh.triangles {
        writeln!(out, "3 {a} {b} {c}")?;
    }
    Ok(())
}
