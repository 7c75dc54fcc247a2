//! STL, binary or ascii: the corners of all triangles in order, shared corners as often as they are used, and the triangles where they are asked for. A
//! binary file is recognised by its length, since many binary files begin with `solid` too.

use super::rows::{Field, Table};
use super::{Decoded, ReadOptions};
use crate::columns::{Endian, Scalar};
use crate::error::Error;
use crate::number::{parse, shown, tokens};
use crate::source::Source;

/// Bytes before the triangles, and of one of them.
const HEADER: usize = 84;
const TRIANGLE: usize = 50;

/// Whether an input that begins with `start` and has `length` bytes, if that is known, is binary STL by its length.
pub(crate) fn is_binary(start: &[u8], length: Option<u64>) -> bool {
    let Some(count) = start.get(80..84).and_then(|b| b.first_chunk()).map(|b| u32::from_le_bytes(*b)) else {
        return false;
    };
    length == Some(HEADER as u64 + TRIANGLE as u64 * u64::from(count))
}

/// Whether an input that begins with `start` is ascii STL.
pub(crate) fn is_ascii(start: &[u8]) -> bool {
    let text = start.trim_ascii_start();
    let word = |word: &[u8]| text.windows(word.len()).any(|w| w.eq_ignore_ascii_case(word));
    text.get(..5).is_some_and(|w| w.eq_ignore_ascii_case(b"solid"))
        && !start.contains(&0)
        && (word(b"facet") || word(b"endsolid"))
}

/// Reads an STL input.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    let length = source.remaining();
    let start = source.peek(1 << 16)?;
    let mut out = if is_ascii(start) && !is_binary(start, length) {
        ascii(source, options)?
    } else {
        binary(source, options)?
    };
    if options.mesh.is_some() {
        let corners = u32::try_from(out.cloud.len()).unwrap_or(u32::MAX);
        (0..corners / 3).for_each(|t| out.faces.push(&[3 * t, 3 * t + 1, 3 * t + 2]));
    }
    Ok(out)
}

fn binary(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    let header = source.peek(HEADER)?;
    let Some(count) =
        header.get(80..84).and_then(|b| b.first_chunk()).map(|b| u64::from(u32::from_le_bytes(*b)))
    else {
        let there = header.len() as u64;
        return Err(source.ends_early("bytes of the header", HEADER as u64, there));
    };
    source.consume(HEADER);
    let room = super::rows::room(source, count, TRIANGLE as u64);
    let mut out = Decoded::default();
    out.cloud.positions.reserve_exact(3 * room);
    let mut corners = Table::new([0, 1, 2], Vec::new(), 3);
    let axes = [0, 4, 8].map(|offset| Field { offset, kind: Scalar::F32 });
    let mut done = 0;
    while done < count {
        let here = source.peek(TRIANGLE)?;
        let Some(triangle) = here.get(12..48) else { break };
        corners.positions.clear();
        corners.append(triangle, 12, &axes, Endian::Little);
        out.cloud.positions.extend_from_slice(&corners.positions);
        if here.len() < TRIANGLE {
            break;
        }
        source.consume(TRIANGLE);
        done += 1;
    }
    if done < count {
        out.cloud.positions.truncate(3 * done as usize);
        out.cut(source, options, "triangles", count, done)?;
    } else {
        let extra = source.drain()?;
        super::rows::note_extra(extra, TRIANGLE as u64, "triangle", &mut out);
    }
    out.ignored.push("normals and attributes of the triangles".into());
    Ok(out)
}

fn ascii(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    source.detect_terminator()?;
    let mut out = Decoded::default();
    let mut open = false;
    while let Some(line) = source.line()? {
        match statement(line) {
            Ok(Statement::Vertex(point)) => out.cloud.positions.push(point),
            Ok(Statement::Solid) => open = true,
            Ok(Statement::End) => open = false,
            Ok(Statement::Other) => {}
            Err(_) if options.salvage && source.peek(1)?.is_empty() => break,
            Err(found) => {
                let advice =
                    "expected solid, facet, outer loop, `vertex X Y Z`, endloop, endfacet or endsolid";
                return Err(source.malformed_line(found, advice));
            }
        }
    }
    let corners = out.cloud.len() as u64;
    if open || !corners.is_multiple_of(3) {
        out.cloud.positions.truncate((corners - corners % 3) as usize);
        out.cut(source, options, "triangles (`endsolid` is missing)", corners / 3 + 1, corners / 3)?;
    }
    Ok(out)
}

/// The meaning of a line of ascii STL.
enum Statement {
    Solid,
    End,
    Vertex([f64; 3]),
    Other,
}

fn statement(line: &[u8]) -> Result<Statement, String> {
    let mut words = tokens(line);
    let Some(keyword) = words.next() else { return Ok(Statement::Other) };
    match keyword.to_ascii_lowercase().as_slice() {
        b"vertex" => vertex(words).map(Statement::Vertex),
        b"solid" => Ok(Statement::Solid),
        b"endsolid" => Ok(Statement::End),
        b"facet" | b"outer" | b"endloop" | b"endfacet" | b"color" => Ok(Statement::Other),
        _ => Err(shown(keyword)),
    }
}

fn vertex<'a>(mut words: impl Iterator<Item = &'a [u8]>) -> Result<[f64; 3], String> {
    let mut point = [0.0; 3];
    for value in &mut point {
        let word = words.next().ok_or("a vertex of less than three numbers")?;
        *value = parse(word).ok_or_else(|| format!("vertex coordinate {}", shown(word)))?;
    }
    match words.next() {
        Some(word) => Err(format!("a fourth number {}", shown(word))),
        None => Ok(point),
    }
}
