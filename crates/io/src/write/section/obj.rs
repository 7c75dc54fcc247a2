//! Sections as Wavefront lines, a group for each slice.

use super::ring::ring;
use lineament::section::Sections;
use std::io::{self, Write};

/// Writes `v` and `l` records; indices count from 1.
pub(super) fn write(out: &mut dyn Write, sections: &Sections) -> io::Result<()> {
    writeln!(out, "# sections of a point cloud, a group a slice")?;
    let mut first = 1;
    for section in &sections.sections {
        writeln!(out, "g slice_{:04}", section.plane)?;
        for contour in &section.contours {
            for [x, y, z] in &contour.points {
                writeln!(out, "v {x:?} {y:?} {z:?}")?;
            }
            write!(out, "l")?;
            for index in ring(contour, first) {
                write!(out, " {index}")?;
            }
            writeln!(out)?;
            first += contour.points.len();
        }
    }
    Ok(())
}
