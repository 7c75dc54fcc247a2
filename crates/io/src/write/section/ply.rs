//! Sections as PLY with edges, binary little endian.

use super::ring;
use lineament::section::{Contour, Sections};
use std::io::{self, Write};

/// Writes vertices with the index of their plane, and edges.
pub(super) fn write(out: &mut dyn Write, sections: &Sections) -> io::Result<()> {
    let vertices: usize = sections.contours().map(|(_, c)| c.points.len()).sum();
    let edges: usize = sections.contours().map(|(_, c)| edges(c)).sum();
    write!(out, "ply\nformat binary_little_endian 1.0\ncomment sections of a point cloud\n")?;
    write!(out, "element vertex {vertices}\nproperty double x\nproperty double y\nproperty double z\n")?;
    write!(out, "property int plane\nelement edge {edges}\n")?;
    write!(out, "property int vertex1\nproperty int vertex2\nend_header\n")?;
    for (plane, contour) in sections.contours() {
        for point in &contour.points {
            for x in point {
                out.write_all(&x.to_le_bytes())?;
            }
            out.write_all(&(plane as i32).to_le_bytes())?;
        }
    }
    let mut first = 0;
    for (_, contour) in sections.contours() {
        let order: Vec<usize> = ring(contour, first).collect();
        for pair in order.windows(2) {
            out.write_all(&(pair[0] as i32).to_le_bytes())?;
            out.write_all(&(pair[1] as i32).to_le_bytes())?;
        }
        first += contour.points.len();
    }
    Ok(())
}

fn edges(contour: &Contour) -> usize {
    contour.points.len().saturating_sub(usize::from(!contour.closed))
}
