//! A network as GeoJSON with 3D coordinates in the frame of the input. RFC 7946 knows longitude and latitude only; the
//! URN of another reference system stands in the member `crs` of the 2008 specification, which GDAL and QGIS read; where it
//! is not known `null` stands there, so that no reader takes the coordinates for degrees.

use super::context::{self, NetworkContext};
use crate::crs;
use crate::write::encode::json::{Index, Number, Point};
use lineament::Network;
use std::io::{self, Write};

/// Writes a `LineString` feature a strip, closed ones ending where they begin, and a `Point` feature a node.
pub(super) fn write(out: &mut dyn Write, network: &Network, context: &NetworkContext) -> io::Result<()> {
    write!(out, "{{\"type\": \"FeatureCollection\",")?;
    write!(out, "\n{},", crs::member(context.crs.as_deref()))?;
    write!(out, "\n\"features\": [")?;
    let mut separator = "\n";
    for (id, strip) in network.strips.iter().enumerate().filter(|(_, strip)| strip.points.len() > 1) {
        write!(out, "{separator}{{\"type\": \"Feature\", \"properties\": {{\"strip\": {id}, ")?;
        write!(out, "\"kind\": \"{}\", \"closed\": {}, ", strip.kind.name(), strip.closed)?;
        write!(out, "\"start\": {}, \"end\": {}, ", Index(strip.start), Index(strip.end))?;
        write!(out, "\"length\": {}, \"deviation\": {}, ", Number(strip.length()), Number(strip.deviation))?;
        let fold_deg = context::fold_deg(strip, context.sides(id));
        write!(out, "\"fold_deg\": {}, \"confidence\": {}}}, ", Number(fold_deg), Number(strip.confidence))?;
        write!(out, "\"geometry\": {{\"type\": \"LineString\", \"coordinates\": [")?;
        let first = strip.points.first().filter(|_| strip.closed);
        for (i, point) in strip.points.iter().chain(first).enumerate() {
            write!(out, "{}{}", if i > 0 { ", " } else { "" }, Point(point))?;
        }
        write!(out, "]}}}}")?;
        separator = ",\n";
    }
    for (id, node) in network.nodes.iter().enumerate() {
        let (kind, degree) = (node.kind.name(), node.degree);
        write!(out, "{separator}{{\"type\": \"Feature\", \"properties\": {{\"node\": {id}, ")?;
        write!(out, "\"kind\": \"{kind}\", \"degree\": {degree}}}, ")?;
        write!(out, "\"geometry\": {{\"type\": \"Point\", \"coordinates\": {}}}}}", Point(&node.position))?;
        separator = ",\n";
    }
    writeln!(out, "\n]}}")
}
