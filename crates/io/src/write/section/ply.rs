//! Sections as PLY with elements `vertex` and `edge`.

use super::ring::ring;
use crate::write::encode::ply;
use lineament::section::{Contour, Sections};
use std::io::{self, Write};

/// Writes vertices with the index of their plane, and edges.
pub(super) fn write(out: &mut dyn Write, sections: &Sections) -> io::Result<()> {
    let vertices = sections.contours().map(|(_, c)| c.points.len()).sum();
    let edges = sections.contours().map(|(_, c)| edges(c)).sum();
    let elements = [ply::vertices(vertices, &[("int", "plane")]), ply::edges(edges, &[])];
    ply::header(out, &["sections of a point cloud"], &elements)?;
    for (plane, contour) in sections.contours() {
        for &point in &contour.points {
            ply::vertex(out, point, &ply::index(plane)?.to_le_bytes())?;
        }
    }
    let mut first = 0;
    for (_, contour) in sections.contours() {
        let order: Vec<usize> = ring(contour, first).collect();
        for pair in order.windows(2) {
            ply::edge(out, [pair[0], pair[1]], &[])?;
        }
        first += contour.points.len();
    }
    Ok(())
}

fn edges(contour: &Contour) -> usize {
    contour.points.len().saturating_sub(usize::from(!contour.closed))
}
