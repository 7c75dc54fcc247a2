//! A network in the schema `lineament-network/1`, which `docs/schema-network-1.md` describes.

use super::context::{self, NetworkContext, Parameter};
use super::patch;
use crate::write::encode::json::{Head, Index, Number, Point, Text, Value, lines, list};
use lineament::curve::BSpline;
use lineament::patch::Sides;
use lineament::{Network, Node, Strip};
use std::io::{self, Write};

/// The name of the schema, as it stands in every file.
const SCHEMA: &str = "lineament-network/1";

/// Writes the network: a line for each node and each strip. Numbers are the shortest decimals that give the same f64
/// back.
pub(in crate::write) fn write(
    out: &mut dyn Write,
    network: &Network,
    context: &NetworkContext,
) -> io::Result<()> {
    Head {
        schema: SCHEMA,
        version: &context.program_version,
        input: &context.input_name,
        sha256: context.input_sha256.as_deref(),
        points: context.input_points,
    }
    .write(out)?;
    writeln!(out, "\"method\": {},", Text(&context.method))?;
    write!(out, "\"parameters\": {{")?;
    list(out, &context.parameters, |out, _, Parameter { key, value }| {
        write!(out, "{}: {}", Text(key), Value(value))
    })?;
    writeln!(out, "}},\n\"spacing\": {},", Number(context.spacing))?;
    writeln!(out, "\"noise\": {},", Number(context.noise.unwrap_or(f64::NAN)))?;
    write!(out, "\"nodes\": [")?;
    lines(out, &network.nodes, node)?;
    write!(out, "],\n\"strips\": [")?;
    lines(out, &network.strips, |out, id, s| strip(out, id, s, context.sides(id)))?;
    write!(out, "],\n\"patches\": [")?;
    lines(out, context.patches.as_ref().map_or(&[][..], |p| &p.patches), patch::patch)?;
    writeln!(out, "]\n}}")
}

fn node(out: &mut dyn Write, id: usize, node: &Node) -> io::Result<()> {
    let Node { position, kind, degree, source } = node;
    write!(
        out,
        "{{\"id\": {id}, \"position\": {}, \"kind\": \"{}\", \"degree\": {degree}, \"source\": {source}}}",
        Point(position),
        kind.name()
    )
}

fn strip(out: &mut dyn Write, id: usize, strip: &Strip, sides: Option<&Sides>) -> io::Result<()> {
    let closed = strip.closed;
    write!(out, "{{\"id\": {id}, \"kind\": \"{}\", \"closed\": {closed}, ", strip.kind.name())?;
    write!(out, "\"start\": {}, \"end\": {}, ", Index(strip.start), Index(strip.end))?;
    write!(out, "\"length\": {}, ", Number(strip.length()))?;
    write!(out, "\"deviation\": {}, ", Number(strip.deviation))?;
    write!(out, "\"confidence\": {}, \"points\": [", Number(strip.confidence))?;
    list(out, &strip.points, |out, _, point| write!(out, "{}", Point(point)))?;
    write!(out, "], \"curve\": ")?;
    curve(out, &strip.curve)?;
    write!(out, ", \"sources\": [")?;
    list(out, &strip.sources, |out, _, source| write!(out, "{source}"))?;
    write!(out, "], \"fold_deg\": {}", Number(context::fold_deg(strip, sides)))?;
    if let Some(Sides { left, right, convex, .. }) = sides {
        write!(out, ", \"left\": {}, \"right\": {}, \"convex\": ", Index(*left), Index(*right))?;
        match convex {
            Some(convex) => write!(out, "{convex}")?,
            None => write!(out, "null")?,
        }
    }
    write!(out, "}}")
}

fn curve(out: &mut dyn Write, curve: &BSpline) -> io::Result<()> {
    let BSpline { degree, knots, controls, periodic } = curve;
    if controls.is_empty() {
        return write!(out, "null");
    }
    write!(out, "{{\"type\": \"b-spline\", \"degree\": {degree}, \"periodic\": {periodic}, \"knots\": [")?;
    list(out, knots, |out, _, &knot| write!(out, "{}", Number(knot)))?;
    write!(out, "], \"controls\": [")?;
    list(out, controls, |out, _, control| write!(out, "{}", Point(control)))?;
    write!(out, "]}}")
}
