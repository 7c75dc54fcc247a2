//! The faces of PLY inputs: of each row the list of its vertices. Rows of the element `tristrips` hold strips of triangles, in which -1
//! stands between two of them.

use super::header::{Element, Encoding, Kind};
use crate::columns::{Endian, Scalar};
use crate::error::Error;
use crate::number::{integer, token, tokens};
use crate::read::Decoded;
use crate::read::mesh::{MOST_CORNERS, NO_VERTEX};
use crate::source::Source;

/// Items up to which a row of strips is read.
const MOST_ITEMS: u64 = 1 << 26;

/// Reads rows, in which property `list` holds the vertices of a face; gives how many were there whole.
pub(super) fn read(
    source: &mut Source,
    encoding: Encoding,
    element: &Element,
    list: usize,
    out: &mut Decoded,
) -> Result<u64, Error> {
    let (mut row, mut face) = (0, Vec::new());
    while row < element.count {
        let there = match encoding {
            Encoding::Ascii => text(source, element, list, &mut face)?,
            Encoding::Binary(endian) => binary(source, element, endian, list, &mut face)?,
        };
        match there {
            Row::Face if element.is_strips() => strips(&face, out),
            Row::Face => out.faces.push(&face),
            Row::Odd => out.odd_faces += 1,
            Row::Blank => continue,
            Row::End => break,
        }
        row += 1;
    }
    Ok(row)
}

/// The triangles of strips, each of which begins with two corners of the one before it.
fn strips(items: &[u32], out: &mut Decoded) {
    for strip in items.split(|&v| v == NO_VERTEX) {
        for (k, corners) in strip.windows(3).enumerate() {
            let &[a, b, c] = corners else { continue };
            // A corner that is there twice turns the strip without a triangle.
            if a != b && b != c && c != a {
                out.faces.push(&if k % 2 == 0 { [a, b, c] } else { [b, a, c] });
            }
        }
    }
}

/// The number of a vertex; in strips -1 stands for none.
fn vertex(item: f64, strips: bool) -> Option<u32> {
    match item {
        -1.0 if strips => Some(NO_VERTEX),
        _ => (0.0..f64::from(u32::MAX)).contains(&item).then_some(item as u32),
    }
}

/// What came of a row.
enum Row {
    Face,
    /// A list that is too long, or holds something that is no number of a vertex.
    Odd,
    Blank,
    End,
}

fn text(source: &mut Source, element: &Element, list: usize, face: &mut Vec<u32>) -> Result<Row, Error> {
    let Some(line) = source.line()? else { return Ok(Row::End) };
    if token(line).is_none() {
        return Ok(Row::Blank);
    }
    face.clear();
    let mut words = tokens(line);
    for (index, property) in element.properties.iter().enumerate() {
        let word = words.next();
        let Kind::List { .. } = property.kind else { continue };
        let Some(count) = word.and_then(integer) else { return Ok(Row::Odd) };
        for _ in 0..count {
            let Some(word) = words.next() else { return Ok(Row::Odd) };
            if index == list {
                let between = element.is_strips() && word == b"-1";
                let number = if between {
                    Some(NO_VERTEX)
                } else {
                    integer(word).and_then(|v| vertex(v as f64, false))
                };
                let Some(number) = number else { return Ok(Row::Odd) };
                face.push(number);
            }
        }
    }
    Ok(Row::Face)
}

fn binary(
    source: &mut Source,
    element: &Element,
    endian: Endian,
    list: usize,
    face: &mut Vec<u32>,
) -> Result<Row, Error> {
    face.clear();
    let mut odd = false;
    for (index, property) in element.properties.iter().enumerate() {
        let (count, item) = match property.kind {
            Kind::Scalar(kind) => (1.0, kind),
            Kind::List { count, item } => match number(source, count, endian)? {
                Some(value) => (value, item),
                None => return Ok(Row::End),
            },
        };
        if count < 0.0 {
            let found = format!("list `{}` has {count} items", property.name);
            return Err(source.malformed(found, "a length cannot be negative; the file is damaged"));
        }
        let wanted = (count as u64).saturating_mul(item.size() as u64);
        let most = if element.is_strips() { MOST_ITEMS } else { MOST_CORNERS };
        if index != list || count as u64 > most {
            odd |= index == list;
            if source.skip(wanted)? < wanted {
                return Ok(Row::End);
            }
            continue;
        }
        let here = source.peek(wanted as usize)?;
        let Some(items) = here.get(..wanted as usize) else { return Ok(Row::End) };
        for item in items.chunks_exact(item.size()).map(|bytes| item.value(bytes, endian)) {
            let number = vertex(item, element.is_strips());
            odd |= number.is_none();
            face.push(number.unwrap_or(NO_VERTEX));
        }
        source.consume(wanted as usize);
    }
    Ok(if odd { Row::Odd } else { Row::Face })
}

/// The next number; `None` where the input ends before.
fn number(source: &mut Source, kind: Scalar, endian: Endian) -> Result<Option<f64>, Error> {
    let here = source.peek(kind.size())?;
    let value = here.get(..kind.size()).map(|bytes| kind.value(bytes, endian));
    source.consume(kind.size());
    Ok(value)
}
