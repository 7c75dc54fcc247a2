//! A network in the schema `lineament-network/1`, which `docs/schema-network-1.md` describes.

mod patch;

use super::{NetworkContext, Parameter};
use lineament::curve::BSpline;
use lineament::patch::Sides;
use lineament::{Network, Node, Strip};
use std::fmt;
use std::io::{self, Write};

/// The name of the schema, as it stands in every file.
const SCHEMA: &str = "lineament-network/1";

/// Writes the network: a line a node and a line a strip. Numbers are the shortest decimals that give the same f64
/// back.
pub(super) fn write(out: &mut dyn Write, network: &Network, context: &NetworkContext) -> io::Result<()> {
    let NetworkContext { program_version, input_name, input_sha256, input_points, method, .. } = context;
    writeln!(out, "{{\n\"schema\": {},", Text(SCHEMA))?;
    writeln!(out, "\"program\": {{\"name\": \"lineament\", \"version\": {}}},", Text(program_version))?;
    write!(out, "\"input\": {{\"name\": {}, \"sha256\": ", Text(input_name))?;
    match input_sha256 {
        Some(hash) => write!(out, "{}", Text(hash))?,
        None => write!(out, "null")?,
    }
    writeln!(out, ", \"points\": {input_points}}},")?;
    writeln!(out, "\"frame\": \"input\",\n\"unit\": \"input\",\n\"method\": {},", Text(method))?;
    write!(out, "\"parameters\": {{")?;
    list(out, &context.parameters, |out, _, Parameter { key, value }| {
        write!(out, "{}: {}", Text(key), Value(value))
    })?;
    writeln!(out, "}},\n\"spacing\": {},", Number(context.spacing))?;
    writeln!(out, "\"noise\": {},", Number(context.noise.unwrap_or(f64::NAN)))?;
    write!(out, "\"nodes\": [")?;
    lines(out, &network.nodes, node)?;
    write!(out, "],\n\"strips\": [")?;
    let sides = |id: usize| context.patches.as_ref().and_then(|p| p.sides.get(id));
    lines(out, &network.strips, |out, id, s| strip(out, id, s, sides(id)))?;
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
    write!(out, "]")?;
    if let Some(Sides { left, right, fold_deg, convex }) = sides {
        write!(out, ", \"left\": {}, \"right\": {}", Index(*left), Index(*right))?;
        write!(out, ", \"fold_deg\": {}, \"convex\": ", Number(fold_deg.unwrap_or(f64::NAN)))?;
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

/// Items with commas between them.
pub(super) fn list<T>(
    out: &mut dyn Write,
    items: &[T],
    mut item: impl FnMut(&mut dyn Write, usize, &T) -> io::Result<()>,
) -> io::Result<()> {
    for (i, value) in items.iter().enumerate() {
        if i > 0 {
            write!(out, ", ")?;
        }
        item(out, i, value)?;
    }
    Ok(())
}

/// Items on a line each.
pub(super) fn lines<T>(
    out: &mut dyn Write,
    items: &[T],
    mut item: impl FnMut(&mut dyn Write, usize, &T) -> io::Result<()>,
) -> io::Result<()> {
    for (i, value) in items.iter().enumerate() {
        write!(out, "{}", if i > 0 { ",\n" } else { "\n" })?;
        item(out, i, value)?;
    }
    if items.is_empty() { Ok(()) } else { writeln!(out) }
}

/// A number; `null` if it is none.
pub(super) struct Number(pub(super) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(digits(&mut zmij::Buffer::new(), self.0))
    }
}

/// The shortest decimals that give the same number back.
fn digits(buffer: &mut zmij::Buffer, number: f64) -> &str {
    if number.is_finite() { buffer.format_finite(number) } else { "null" }
}

pub(super) struct Point<'a>(pub(super) &'a [f64; 3]);

impl fmt::Display for Point<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [mut x, mut y, mut z] = [(); 3].map(|()| zmij::Buffer::new());
        let texts = [digits(&mut x, self.0[0]), digits(&mut y, self.0[1]), digits(&mut z, self.0[2])];
        ["[", texts[0], ", ", texts[1], ", ", texts[2], "]"].into_iter().try_for_each(|t| f.write_str(t))
    }
}

pub(super) struct Index(pub(super) Option<u32>);

impl fmt::Display for Index {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(index) => write!(f, "{index}"),
            None => f.write_str("null"),
        }
    }
}

/// A text in quotes.
pub(super) struct Text<'a>(pub(super) &'a str);

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("\"")?;
        for c in self.0.chars() {
            match c {
                '"' | '\\' => write!(f, "\\{c}")?,
                c if u32::from(c) < 0x20 || c == '\u{7f}' => write!(f, "\\u{:04x}", u32::from(c))?,
                c => write!(f, "{c}")?,
            }
        }
        f.write_str("\"")
    }
}

/// The value of a parameter: a number or a truth value as such, all else as text.
struct Value<'a>(&'a str);

impl fmt::Display for Value<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = self.0.trim();
        if matches!(text, "true" | "false") {
            return f.write_str(text);
        }
        if let Ok(integer) = text.parse::<i64>() {
            return write!(f, "{integer}");
        }
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => write!(f, "{}", Number(number)),
            _ => write!(f, "{}", Text(text)),
        }
    }
}
