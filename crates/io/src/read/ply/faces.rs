//! The faces of PLY inputs: of each row the list of its vertices.

use super::header::{Element, Encoding, Kind};
use crate::columns::{Endian, Scalar};
use crate::error::Error;
use crate::number::{integer, token, tokens};
use crate::read::Decoded;
use crate::read::mesh::MOST_CORNERS;
use crate::source::Source;

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
            Row::Face => out.faces.push(&face),
            Row::Odd => out.odd_faces += 1,
            Row::Blank => continue,
            Row::End => break,
        }
        row += 1;
    }
    Ok(row)
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
                let Some(vertex) = integer(word).and_then(|v| u32::try_from(v).ok()) else {
                    return Ok(Row::Odd);
                };
                face.push(vertex);
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
        if index != list || count as u64 > MOST_CORNERS {
            odd |= index == list;
            if source.skip(wanted)? < wanted {
                return Ok(Row::End);
            }
            continue;
        }
        let here = source.peek(wanted as usize)?;
        let Some(items) = here.get(..wanted as usize) else { return Ok(Row::End) };
        for item in items.chunks_exact(item.size()).map(|bytes| item.value(bytes, endian)) {
            odd |= !(0.0..f64::from(u32::MAX)).contains(&item);
            face.push(item as u32);
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
