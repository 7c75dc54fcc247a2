//! Sections as GeoJSON (RFC 7946): a polygon for each outer contour with the holes directly in it, a line for each
//! open one. Coordinates are those of the input; the member `crs` of the 2008 specification names their system, or is
//! `null` where it is not known.

use crate::crs;
use lineament::section::{Contour, Section, Sections};
use std::io::{self, Write};

pub(super) fn write(out: &mut dyn Write, sections: &Sections, crs: Option<&str>) -> io::Result<()> {
    write!(out, "{{\"type\": \"FeatureCollection\", {}, \"features\": [", crs::member(crs))?;
    let mut first = true;
    for section in &sections.sections {
        for (i, contour) in section.contours.iter().enumerate() {
            if contour.closed && contour.depth % 2 == 1 {
                continue;
            }
            writeln!(out, "{}", if first { "" } else { "," })?;
            first = false;
            feature(out, section, i, contour)?;
        }
    }
    writeln!(out, "\n]}}")
}

fn feature(out: &mut dyn Write, section: &Section, i: usize, contour: &Contour) -> io::Result<()> {
    let kind = if contour.closed { "Polygon" } else { "LineString" };
    write!(out, "{{\"type\": \"Feature\", \"properties\": {{\"plane\": {}, ", section.plane)?;
    write!(out, "\"height\": {:?}, \"area\": {:?}, ", section.height, contour.area)?;
    write!(out, "\"length\": {:?}}}, ", contour.length)?;
    write!(out, "\"geometry\": {{\"type\": \"{kind}\", \"coordinates\": ")?;
    if contour.closed {
        write!(out, "[")?;
        coordinates(out, contour)?;
        let holes = section.contours.iter().filter(|c| c.closed && c.parent == Some(i));
        for hole in holes {
            write!(out, ", ")?;
            coordinates(out, hole)?;
        }
        write!(out, "]")?;
    } else {
        coordinates(out, contour)?;
    }
    write!(out, "}}}}")
}

fn coordinates(out: &mut dyn Write, contour: &Contour) -> io::Result<()> {
    let closing = contour.points.first().filter(|_| contour.closed);
    write!(out, "[")?;
    for (k, [x, y, z]) in contour.points.iter().chain(closing).enumerate() {
        write!(out, "{}[{x:?}, {y:?}, {z:?}]", if k > 0 { ", " } else { "" })?;
    }
    write!(out, "]")
}
