//! Nodes and strips of a report.

use crate::write::encode::json::{Index, Number, Point, lines, list};
use crate::write::network::context::{NetworkContext, fold_deg};
use base64::prelude::{BASE64_STANDARD, Engine};
use lineament::curve::Round;
use lineament::curve::pieces::{Piece, Shape, Sigma};
use lineament::inspect::RimSide;
use lineament::patch::Sides;
use lineament::{Network, Node, Strip};
use std::io::{self, Write};

/// Most points of all strips together that are written; of longer networks every second, third ... point is.
const MOST: usize = 150_000;

/// `rims` says of each strip what it is the rim of.
pub(super) fn write(
    out: &mut dyn Write,
    network: &Network,
    context: &NetworkContext,
    rims: &[Option<RimSide>],
) -> io::Result<()> {
    let step = step(network.strips.iter().map(|s| s.points.len()).sum(), MOST);
    write!(out, "\"nodes\": [")?;
    lines(out, &network.nodes, |out, _, node| {
        let Node { position, kind, degree, .. } = node;
        let kind = kind.name();
        write!(out, "{{\"position\": {}, \"kind\": \"{kind}\", \"degree\": {degree}}}", Point(position))
    })?;
    writeln!(out, "],\n\"step\": {step},")?;
    write!(out, "\"strips\": [")?;
    lines(out, &network.strips, |out, id, s| {
        strip(out, s, context.sides(id), thinned(&s.points, step).count())?;
        if let Some(RimSide { rim, .. }) = rims[id] {
            write!(out, ", \"rim\": \"{}\"", rim.name())?;
        }
        write!(out, "}}")
    })?;
    write!(out, "],\n\"coordinates\": \"")?;
    let all = network.strips.iter().flat_map(|s| thinned(&s.points, step));
    let bytes: Vec<u8> = all.flatten().flat_map(|c| c.to_le_bytes()).collect();
    out.write_all(BASE64_STANDARD.encode(bytes).as_bytes())?;
    writeln!(out, "\",")
}

/// The step over `count` points that leaves at most about `most` of them.
pub(super) fn step(count: usize, most: usize) -> usize {
    count.div_ceil(most).max(1)
}

/// Every `step`th point, and the last.
pub(super) fn thinned(points: &[[f64; 3]], step: usize) -> impl Iterator<Item = [f64; 3]> {
    let last = points.len().saturating_sub(1);
    points.iter().enumerate().filter(move |(i, _)| i % step == 0 || *i == last).map(|(_, p)| *p)
}

/// A strip without its closing brace.
fn strip(out: &mut dyn Write, strip: &Strip, sides: Option<&Sides>, count: usize) -> io::Result<()> {
    write!(out, "{{\"kind\": \"{}\", \"closed\": {}, ", strip.kind.name(), strip.closed)?;
    write!(out, "\"start\": {}, \"end\": {}, ", Index(strip.start), Index(strip.end))?;
    write!(out, "\"length\": {}, ", Number(strip.length()))?;
    write!(out, "\"deviation\": {}, ", Number(strip.deviation))?;
    write!(out, "\"confidence\": {}, ", Number(strip.confidence))?;
    write!(out, "\"fold_deg\": {}, ", Number(fold_deg(strip, sides)))?;
    if let Some(Sides { left, right, convex, .. }) = sides {
        write!(out, "\"left\": {}, \"right\": {}, ", Index(*left), Index(*right))?;
        let convex = convex.map_or("null", |c| if c { "true" } else { "false" });
        write!(out, "\"convex\": {convex}, ")?;
    }
    write!(out, "\"count\": {count}, \"curves\": [")?;
    list(out, &strip.curves, |out, _, p| piece(out, p))?;
    write!(out, "]")
}

/// Type, ends, radius with its standard deviation, and the deviation of the points.
fn piece(out: &mut dyn Write, piece: &Piece) -> io::Result<()> {
    write!(out, "{{\"type\": \"{}\", \"from\": {}, ", piece.shape.name(), Point(&piece.from))?;
    write!(out, "\"to\": {}, ", Point(&piece.to))?;
    match &piece.shape {
        Shape::Line | Shape::Ellipse { .. } | Shape::Spline(_) => {}
        Shape::Arc { round, sweep } => {
            circle(out, round)?;
            write!(out, "\"sweep_deg\": {}, ", Number(sweep.to_degrees()))?;
        }
        Shape::Circle(round) => circle(out, round)?,
    }
    if let Some(Sigma::Round { radius, .. }) = piece.sigma {
        write!(out, "\"sigma\": {}, ", Number(radius))?;
    }
    write!(out, "\"deviation\": {}}}", Number(piece.deviation))
}

fn circle(out: &mut dyn Write, round: &Round) -> io::Result<()> {
    let Round { centre, normal, radius } = round;
    write!(out, "\"center\": {}, \"normal\": {}, ", Point(centre), Point(normal))?;
    write!(out, "\"radius\": {}, ", Number(*radius))
}
