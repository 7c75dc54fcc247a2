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

/// Reads an OFF input.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    source.detect_terminator()?;
    let [vertices, faces] = header(source)?;
    let mut out = Decoded::default();
    out.cloud.positions.reserve_exact(room(source, vertices, 6));
    let mut longest = 0;
    for row in 0..vertices {
        let Some(line) = next(source)? else {
            out.cut(source, options, "vertices", vertices, row)?;
            return Ok(out);
        };
        match vertex(&line) {
            Ok((point, more)) => {
                out.cloud.positions.push(point);
                longest = longest.max(more);
            }
            Err(_) if options.salvage && source.peek(1)?.is_empty() => {
                out.cut(source, options, "vertices", vertices, row)?;
                return Ok(out);
            }
            Err(found) => {
                return Err(source.malformed_line(format!("vertex {row}: {found}"), "expected X Y Z"));
            }
        }
    }
    for face in 0..faces {
        if next(source)?.is_none() {
            out.cut(source, options, "faces", faces, face)?;
            break;
        }
    }
    if faces > 0 {
        out.ignored.push(format!("{faces} faces"));
    }
    if longest > 0 {
        out.ignored.push(format!("{longest} numbers beside the coordinates of vertices"));
    }
    Ok(out)
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
        let word = words.next().ok_or("less than three numbers")?;
        *value = parse(word).ok_or_else(|| format!("coordinate {}", shown(word)))?;
    }
    Ok((point, words.count()))
}
