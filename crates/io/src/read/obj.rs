//! Wavefront OBJ: the `v` lines, `v x y z [w] [r g b]`, and where they are asked for the `f` lines; every other statement is counted
//! and left.

use super::mesh::NO_VERTEX;
use super::{Decoded, ReadOptions};
use crate::error::Error;
use crate::number::{integer, parse, shown, token, tokens};
use crate::source::Source;
use lineament::{Attribute, Column};

/// Reads the vertices of an OBJ input.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    source.detect_terminator()?;
    let mut out = Decoded::default();
    let (mut colours, mut others) = (Colours::new(options.attributes), 0u64);
    while let Some(line) = next(source)? {
        match token(&line) {
            Some((b"v", rest)) => {
                let vertex = match vertex(rest) {
                    Ok(vertex) => vertex,
                    Err((_, short)) if short && options.salvage && source.peek(1)?.is_empty() => {
                        let read = out.cloud.len() as u64;
                        out.cut(source, options, "points", read + 1, read)?;
                        break;
                    }
                    Err((found, _)) => return Err(source.malformed_line(found, "expected `v X Y Z`")),
                };
                out.cloud.positions.push(vertex.position);
                colours.push(vertex.colour, out.cloud.len());
            }
            Some((b"f", rest)) if options.mesh.is_some() => out.faces.push(&face(rest, out.cloud.len())),
            Some((word, _)) if !word.starts_with(b"#") => others += 1,
            _ => {}
        }
    }
    if out.cloud.is_empty() && out.missing.is_none() {
        return Err(source.malformed_line("the input ends without a vertex", "expected statements `v X Y Z`"));
    }
    out.cloud.attributes = colours.finish(out.cloud.len(), &mut out.ignored);
    if others > 0 {
        out.ignored.push(format!("{others} statements other than `v`"));
    }
    Ok(out)
}

/// The next statement: a line, joined with the following ones while it ends in a backslash.
fn next(source: &mut Source) -> Result<Option<Vec<u8>>, Error> {
    let Some(line) = source.line()? else { return Ok(None) };
    let mut statement = line.to_vec();
    while statement.last() == Some(&b'\\') {
        statement.pop();
        match source.line()? {
            Some(line) => statement.extend_from_slice(line),
            None => break,
        }
    }
    Ok(Some(statement))
}

/// The vertices of an `f` line, `f 1 2/3 4/5/6 -1`, counted from 0. Negative numbers count back
/// from the last of the vertices so far.
fn face(rest: &[u8], vertices: usize) -> Vec<u32> {
    let index = |word: &[u8]| {
        let number = word.split(|&b| b == b'/').next()?;
        let index = match number.strip_prefix(b"-") {
            Some(back) => (vertices as u64).checked_sub(integer(back)?)?,
            None => integer(number)?.checked_sub(1)?,
        };
        u32::try_from(index).ok()
    };
    let words = tokens(rest).take_while(|word| !word.starts_with(b"#"));
    words.map(|word| index(word).unwrap_or(NO_VERTEX)).collect()
}

struct Vertex {
    position: [f64; 3],
    colour: Option<[f64; 3]>,
}

/// A vertex from the rest of a `v` line; on failure the fault, and whether the line is too short.
fn vertex(rest: &[u8]) -> Result<Vertex, (String, bool)> {
    let mut values = [0.0; 7];
    let mut count = 0;
    for word in tokens(rest).take_while(|word| !word.starts_with(b"#")) {
        if count == values.len() {
            return Err((
                format!("a vertex of more than 7 numbers, the eighth being {}", shown(word)),
                false,
            ));
        }
        values[count] = parse(word).ok_or_else(|| (format!("vertex coordinate {}", shown(word)), false))?;
        count += 1;
    }
    let [x, y, z, a, b, c, d] = values;
    let colour = match count {
        0..3 => return Err((format!("a vertex of {count} numbers"), true)),
        6 => Some([a, b, c]),
        7 => Some([b, c, d]),
        _ => None,
    };
    Ok(Vertex { position: [x, y, z], colour })
}

/// Vertex colours, kept only if every vertex has one.
struct Colours {
    wanted: bool,
    partial: bool,
    values: [Vec<f64>; 3],
}

impl Colours {
    fn new(wanted: bool) -> Self {
        Self { wanted, partial: false, values: [Vec::new(), Vec::new(), Vec::new()] }
    }

    /// Takes the colour of the vertex that made `vertices` of them.
    fn push(&mut self, colour: Option<[f64; 3]>, vertices: usize) {
        let Some(colour) = colour.filter(|_| self.wanted) else { return };
        if self.values[0].len() + 1 != vertices {
            self.partial = true;
            return;
        }
        for (values, value) in self.values.iter_mut().zip(colour) {
            values.push(value);
        }
    }

    fn finish(self, vertices: usize, ignored: &mut Vec<String>) -> Vec<Attribute> {
        let [red, green, blue] = self.values;
        if red.is_empty() && !self.partial {
            return Vec::new();
        }
        if self.partial || red.len() != vertices {
            ignored.push("vertex colours: not every vertex has one".into());
            return Vec::new();
        }
        let named = [("red", red), ("green", green), ("blue", blue)];
        named.map(|(name, values)| Attribute { name: name.into(), values: Column::F64(values) }).into()
    }
}
