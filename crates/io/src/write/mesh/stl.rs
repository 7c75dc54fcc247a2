//! A mesh as STL, binary. It has single precision: coordinates of a map lose their millimetres.

use lineament::apply::SurfaceMesh;
use std::io::{self, Write};

/// Bytes of the head, which may be anything but the word `solid`.
const HEAD: usize = 80;

/// Writes the triangles with their normals.
pub(super) fn write(out: &mut dyn Write, mesh: &SurfaceMesh) -> io::Result<()> {
    let mut head = b"lineament".to_vec();
    head.resize(HEAD, 0);
    out.write_all(&head)?;
    let many = |_| io::Error::other("an STL file holds at most 2^32 triangles");
    out.write_all(&u32::try_from(mesh.triangles.len()).map_err(many)?.to_le_bytes())?;
    for triangle in &mesh.triangles {
        let corners = triangle.map(|corner| mesh.vertices[corner as usize]);
        let numbers = [normal(corners), corners[0], corners[1], corners[2]];
        for number in numbers.iter().flatten() {
            out.write_all(&(*number as f32).to_le_bytes())?;
        }
        out.write_all(&[0, 0])?;
    }
    Ok(())
}

/// The unit normal of a triangle; zero if it has none.
fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 { n.map(|x| x / length) } else { [0.0; 3] }
}
