//! A mesh as OBJ.

use lineament::apply::SurfaceMesh;
use std::io::{self, Write};

/// Writes vertices and faces; corners count from 1.
pub(super) fn write(out: &mut dyn Write, mesh: &SurfaceMesh) -> io::Result<()> {
    for [x, y, z] in &mesh.vertices {
        writeln!(out, "v {x:?} {y:?} {z:?}")?;
    }
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|corner| u64::from(corner) + 1);
        writeln!(out, "f {a} {b} {c}")?;
    }
    Ok(())
}
