//! OFF, the object file format of Geomview, in ascii: its vertices. Colours, normals and texture coordinates beside them
//! are left out; the faces are counted, so that a file that ends early is noticed.

use super::rows::room;
use super::{Decoded, ReadOptions};
use crate::error::Error;
use crate::number::{integer, parse, shown, tokens};
use crate::source::Source;

/// Whether a first word is one of this format.
pub(crate) fn is_keyword(word: &[u8]) -> bool {
    word.strip_suffix(b"OFF").is_some_and(|prefix| prefix.iter().all(|b| b"STCN4n".contains(b)))
}

/// Numbers that may stand on the line of a vertex: coordinates, normal, colour and two more for texture.
const WIDEST: usize = 12;

/// Reads an OFF input.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    source.detect_terminator()?;
    let [vertices, faces] = header(source)?;
    let mut out = Decoded::default();
    out.cloud.positions.reserve_exact(room(source, vertices, 6));
    let first = if vertices > 0 { next(source)? } else { None };
    let width = first.as_ref().map_or(3, |line| tokens(line).count());
    let by_line = (3..=WIDEST).contains(&width);
    let rest = if by_line {
        lines(source, options, vertices, first, &mut out)?
    } else {
        running(source, options, vertices, first, &mut out)?
    };
    if out.missing.is_some() {
        return Ok(out);
    }
    let mut there = rest.map_or(0, |line| faces_on(&line));
    while there < faces {
        let Some(line) = next(source)? else {
            out.cut(source, options, "faces", faces, there)?;
            break;
        };
        there += if by_line { 1 } else { faces_on(&line) };
    }
    if faces > 0 {
        out.ignored.push(format!("{faces} faces"));
    }
    Ok(out)
}

/// Reads vertices on lines of their own, with further numbers beside them.
fn lines(
    source: &mut Source,
    options: &ReadOptions,
    vertices: u64,
    first: Option<Vec<u8>>,
    out: &mut Decoded,
) -> Result<Option<Vec<u8>>, Error> {
    let (mut ahead, mut longest, mut width) = (first, 0, 0);
    for row in 0..vertices {
        let line = match ahead.take() {
            Some(line) => Some(line),
            None => next(source)?,
        };
        let read = line.as_ref().map(|line| vertex(line));
        let last = options.salvage && source.peek(1)?.is_empty();
        match read {
            Some(Ok((point, more))) => {
                out.cloud.positions.push(point);
                (longest, width) = (longest.max(more), if row == 0 { 3 + more } else { width });
            }
            Some(Err(found)) if !last => {
                return Err(source.malformed_line(format!("vertex {row}: {found}"), advice(width)));
            }
            _ => {
                out.cut(source, options, &unit(width), vertices, row)?;
                return Ok(None);
            }
        }
    }
    if longest > 0 {
        out.ignored.push(format!("{longest} numbers beside the coordinates of vertices"));
    }
    Ok(None)
}

/// The unit of missing vertices where the first line has so many numbers: several vertices on a line cannot be told from
/// one with a normal or a colour.
fn unit(width: usize) -> String {
    if width > 3 { format!("vertices (lines of {width} numbers)") } else { "vertices".into() }
}

fn advice(width: usize) -> String {
    if width > 3 {
        format!(
            "expected X Y Z on a line of its own; the first has {width} numbers, which counts as one vertex"
        )
    } else {
        "expected X Y Z".into()
    }
}

/// Reads vertices whose numbers run over lines. Returns the rest of the line after the last one.
fn running(
    source: &mut Source,
    options: &ReadOptions,
    vertices: u64,
    first: Option<Vec<u8>>,
    out: &mut Decoded,
) -> Result<Option<Vec<u8>>, Error> {
    let (mut ahead, mut point, mut axis, mut row) = (first, [0.0; 3], 0, 0);
    loop {
        let Some(line) = (if ahead.is_some() { ahead.take() } else { next(source)? }) else {
            out.cut(source, options, "vertices", vertices, row)?;
            return Ok(None);
        };
        let mut words = tokens(&line);
        while row < vertices
            && let Some(word) = words.next()
        {
            let Some(value) = parse(word) else {
                let found = format!("vertex {row}: coordinate {}", shown(word));
                return Err(source.malformed_line(found, "expected three numbers for each vertex"));
            };
            point[axis] = value;
            axis = (axis + 1) % 3;
            if axis == 0 {
                out.cloud.positions.push(point);
                row += 1;
            }
        }
        if row == vertices {
            return Ok(Some(words.collect::<Vec<_>>().join(&b' ')));
        }
    }
}

/// Faces on a line: each a count and as many indices, the last perhaps with a colour or with its end on the next line.
fn faces_on(line: &[u8]) -> u64 {
    let words: Vec<&[u8]> = tokens(line).collect();
    let (mut at, mut count) = (0, 0);
    while let Some(corners) = words.get(at).and_then(|word| integer(word)) {
        at = at.saturating_add(1).saturating_add(usize::try_from(corners).unwrap_or(usize::MAX));
        count += u64::from(count == 0 || at <= words.len());
    }
    count
}

/// The numbers of vertices and faces.
fn header(source: &mut Source) -> Result<[u64; 2], Error> {
    let first = next(source)?.unwrap_or_default();
    let mut words: Vec<Vec<u8>> = tokens(&first).map(<[u8]>::to_vec).collect();
    let keyword =
        if words.first().is_some_and(|word| is_keyword(word)) { words.remove(0) } else { Vec::new() };
    let binary = words.first().is_some_and(|word| word == b"BINARY");
    if binary || keyword.iter().any(|b| b"4n".contains(b)) {
        let found = format!("a header {}", shown(&first));
        return Err(
            source.malformed_line(found, "only ascii OFF in three dimensions is read: convert it to PLY")
        );
    }
    if words.is_empty() {
        words = tokens(&next(source)?.unwrap_or_default()).map(<[u8]>::to_vec).collect();
    }
    let counts: Vec<u64> = words.iter().map_while(|word| integer(word)).collect();
    match counts.as_slice() {
        [vertices, faces, ..] if counts.len() == words.len() => Ok([*vertices, *faces]),
        _ => {
            let found = format!("counts {}", shown(&words.join(&b' ')));
            Err(source.malformed_line(found, "expected the numbers of vertices, faces and edges"))
        }
    }
}

/// The next line with something on it that is no comment.
fn next(source: &mut Source) -> Result<Option<Vec<u8>>, Error> {
    while let Some(line) = source.line()? {
        let text = line.split(|&b| b == b'#').next().unwrap_or(&[]);
        if !text.trim_ascii().is_empty() {
            return Ok(Some(text.to_vec()));
        }
    }
    Ok(None)
}

/// A vertex and how many numbers stand beside it.
fn vertex(line: &[u8]) -> Result<([f64; 3], usize), String> {
    let mut point = [0.0; 3];
    let mut words = tokens(line);
    for value in &mut point {
        let word = words.next().ok_or("fewer than three numbers")?;
        *value = parse(word).ok_or_else(|| format!("coordinate {}", shown(word)))?;
    }
    Ok((point, words.count()))
}
