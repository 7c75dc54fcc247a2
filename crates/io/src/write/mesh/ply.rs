//! A mesh as PLY with elements `vertex` and `face`.

use crate::write::encode::ply;
use lineament::apply::SurfaceMesh;
use std::io::{self, Write};

/// Writes double coordinates with the kind of each vertex (0 smooth, 1 crease, 2 border, 3 corner), and lists of three corners.
pub(super) fn write(out: &mut dyn Write, mesh: &SurfaceMesh) -> io::Result<()> {
    let kinds = "vertex kind: 0 smooth, 1 crease, 2 border, 3 corner";
    let faces = ply::Element {
        name: "face",
        count: mesh.triangles.len(),
        properties: vec![("list uchar int", "vertex_indices")],
    };
    ply::header(out, &[kinds], &[ply::vertices(mesh.vertices.len(), &[("uchar", "kind")]), faces])?;
    for (&vertex, &kind) in mesh.vertices.iter().zip(&mesh.kinds) {
        ply::vertex(out, vertex, &[kind as u8])?;
    }
    for triangle in &mesh.triangles {
        out.write_all(&[3])?;
        for &corner in triangle {
            out.write_all(&ply::index(corner as usize)?.to_le_bytes())?;
        }
    }
    Ok(())
}
