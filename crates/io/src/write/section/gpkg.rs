//! Sections as GeoPackage: the layers `areas`, a polygon for each outer contour with the holes directly in it, and `lines`, the
//! open contours.

use super::SectionContext;
use crate::write::encode::gpkg::{self, Layer, Shape};
use crate::write::encode::sqlite::Value;
use lineament::section::{Contour, Section, Sections};
use std::io::{self, Write};

const AREAS: &str = "plane INTEGER, height DOUBLE, area DOUBLE, length DOUBLE";
const LINES: &str = "plane INTEGER, height DOUBLE, length DOUBLE";

/// Writes a database of two layers.
pub(super) fn write(out: &mut dyn Write, sections: &Sections, context: &SectionContext) -> io::Result<()> {
    let of = |section: &Section| vec![Value::Integer(section.plane as i64), Value::Real(section.height)];
    let (mut areas, mut lines) = (Vec::new(), Vec::new());
    for section in &sections.sections {
        for (i, contour) in section.contours.iter().enumerate() {
            let (mut values, length) = (of(section), Value::Real(contour.length));
            if !contour.closed {
                values.push(length);
                lines.push((Shape::Line(contour.points.clone()), values));
            } else if contour.depth.is_multiple_of(2) {
                values.extend([Value::Real(contour.area), length]);
                areas.push((polygon(section, i, contour), values));
            }
        }
    }
    let areas = Layer { name: "areas", geometry: "POLYGON", columns: AREAS, features: areas };
    let lines = Layer { name: "lines", geometry: "LINESTRING", columns: LINES, features: lines };
    gpkg::write(out, vec![areas, lines], context.crs.as_deref(), context.crs_wkt.as_deref())
}

/// A contour and the holes directly in it.
fn polygon(section: &Section, index: usize, outer: &Contour) -> Shape {
    let ring = |c: &Contour| c.points.iter().chain(c.points.first()).copied().collect();
    let holes = section.contours.iter().filter(|c| c.closed && c.parent == Some(index));
    Shape::Polygon([outer].into_iter().chain(holes).map(ring).collect())
}
