//! A network in the schema `lineament-network/2`, which `docs/schema-network-2.md` describes, or on request in
//! `lineament-network/1`, which lacks the typed curves.

use super::context::{self, NetworkContext, Parameter};
use super::{patch, piece, relation};
use crate::write::encode::json::{Head, Index, Number, Point, Text, Value, lines, list};
use lineament::curve::BSpline;
use lineament::patch::Sides;
use lineament::{Blend, Network, Node, Strip};
use std::io::{self, Write};

/// The names of the schemas, as they stand in every file: today's, and the first.
const SCHEMAS: [&str; 2] = ["lineament-network/2", "lineament-network/1"];

/// Writes the network: a line for each node and each strip. Numbers are the shortest decimals that give the same f64
/// back.
pub(in crate::write) fn write(
    out: &mut dyn Write,
    network: &Network,
    context: &NetworkContext,
) -> io::Result<()> {
    Head {
        schema: SCHEMAS[usize::from(context.first_schema)],
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
    let typed = !context.first_schema;
    let moved = context.related.regularised.as_ref().filter(|_| typed);
    let of_node = |id: usize| moved.and_then(|m| m.nodes.get(id).copied());
    lines(out, &network.nodes, |out, id, n| node(out, id, n, (typed, of_node(id))))?;
    write!(out, "],\n\"strips\": [")?;
    let of_strip = |id: usize| moved.and_then(|m| m.curves.get(id)).map_or(&[][..], Vec::as_slice);
    lines(out, &network.strips, |out, id, s| strip(out, id, s, (typed, of_strip(id)), context.sides(id)))?;
    write!(out, "],\n\"patches\": [")?;
    lines(out, context.patches.as_ref().map_or(&[][..], |p| &p.patches), patch::patch)?;
    write!(out, "]")?;
    if typed {
        related(out, context)?;
    }
    writeln!(out, "\n}}")
}

/// The relations, and what their imposition moved.
fn related(out: &mut dyn Write, context: &NetworkContext) -> io::Result<()> {
    write!(out, ",\n\"relations\": [")?;
    lines(out, &context.related.relations, relation::relation)?;
    write!(out, "]")?;
    if let Some(moved) = &context.related.regularised {
        write!(out, ",\n\"regularised\": ")?;
        relation::regularised(out, moved)?;
    }
    Ok(())
}

/// `known` says whether the schema has standard deviations; `moved` is how far relations moved the node.
fn node(out: &mut dyn Write, id: usize, node: &Node, (known, moved): (bool, Option<f64>)) -> io::Result<()> {
    let Node { position, kind, degree, source, sigma } = node;
    write!(
        out,
        "{{\"id\": {id}, \"position\": {}, \"kind\": \"{}\", \"degree\": {degree}, \"source\": {source}",
        Point(position),
        kind.name()
    )?;
    if let Some(sigma) = sigma.filter(|_| known) {
        write!(out, ", \"sigma\": {}", Point(&sigma))?;
    }
    if let Some(moved) = moved {
        write!(out, ", \"moved\": {}", Number(moved))?;
    }
    write!(out, "}}")
}

fn strip(
    out: &mut dyn Write,
    id: usize,
    strip: &Strip,
    (typed, moved): (bool, &[f64]),
    sides: Option<&Sides>,
) -> io::Result<()> {
    let closed = strip.closed;
    write!(out, "{{\"id\": {id}, \"kind\": \"{}\", \"closed\": {closed}, ", strip.kind.name())?;
    write!(out, "\"start\": {}, \"end\": {}, ", Index(strip.start), Index(strip.end))?;
    write!(out, "\"length\": {}, ", Number(strip.length()))?;
    write!(out, "\"deviation\": {}, ", Number(strip.deviation))?;
    write!(out, "\"confidence\": {}, \"points\": [", Number(strip.confidence))?;
    list(out, &strip.points, |out, _, point| write!(out, "{}", Point(point)))?;
    write!(out, "], \"curve\": ")?;
    curve(out, &strip.curve)?;
    if typed {
        write!(out, ", \"curves\": [")?;
        list(out, &strip.curves, |out, k, p| piece::piece(out, p, moved.get(k).copied()))?;
        write!(out, "]")?;
    }
    if typed && !strip.sigma.is_empty() {
        write!(out, ", \"sigma\": [")?;
        list(out, &strip.sigma, |out, _, sigma| write!(out, "{}", Point(sigma)))?;
        write!(out, "]")?;
    }
    write!(out, ", \"sources\": [")?;
    list(out, &strip.sources, |out, _, source| write!(out, "{source}"))?;
    write!(out, "], \"fold_deg\": {}", Number(context::fold_deg(strip, sides)))?;
    if let Some(Blend { radius, sigma }) = strip.blend {
        write!(out, ", \"radius\": {}, \"radius_sigma\": {}", Number(radius), Number(sigma))?;
    }
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
    if curve.controls.is_empty() {
        return write!(out, "null");
    }
    write!(out, "{{\"type\": \"b-spline\"")?;
    piece::spline(out, curve)?;
    write!(out, "}}")
}
