//! OFF, the object file format of Geomview, in ascii: its vertices. Colours, normals and texture coordinates beside them
//! are left out; the faces are counted, so that a file that ends early is noticed, and read where they are asked for.

use super::rows::room;
use super::{Decoded, ReadOptions};
use crate::error::Error;
use crate::number::{integer, parse, shown, tokens};
use crate::read::mesh::{MOST_CORNERS, NO_VERTEX};
use crate::source::{Source, Word};

/// Whether a first word is one of this format.
pub(crate) fn is_keyword(word: &[u8]) -> bool {
    word.strip_suffix(b"OFF").is_some_and(|prefix| prefix.iter().all(|b| b"STCN4n".contains(b)))
}

/// Numbers that may stand on the line of a vertex: coordinates, normal, colour and two more for texture.
const WIDEST: usize = 12;

/// Bytes in which the first vertex is looked for.
const SAMPLE: usize = 1 << 12;

/// Reads an OFF input.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    source.detect_terminator()?;
    let [vertices, faces] = header(source)?;
    let mut out = Decoded::default();
    out.cloud.positions.reserve_exact(room(source, vertices, 6));
    let by_line = vertices > 0 && (3..=WIDEST).contains(&first_width(source)?);
    if by_line {
        lines(source, options, vertices, &mut out)?;
    } else {
        running(source, options, vertices, &mut out)?;
    }
    if out.missing.is_some() {
        return Ok(out);
    }
    let there = if by_line {
        face_lines(source, &mut out, options)?
    } else {
        running_faces(source, faces, &mut out, options)?
    };
    if there < faces {
        out.cut(source, options, "faces", faces, there)?;
    } else if there > faces && !by_line {
        // A colour behind a face may look like another one.
        let what = format!("behind the {vertices} vertices stand more than the {faces} faces of the header");
        out.warnings.push(what);
    } else if there > faces {
        let found = format!("more rows than the {vertices} vertices and {faces} faces of the header");
        let advice = "the header and the rows do not agree; the file is damaged";
        return Err(source.malformed_line(found, advice));
    }
    out.warnings.extend(source.open_end());
    if faces > 0 && options.mesh.is_none() {
        out.ignored.push(format!("{faces} faces"));
    }
    Ok(out)
}

/// Numbers on the line that comes next; more than any vertex has if the line is very long.
fn first_width(source: &mut Source) -> Result<usize, Error> {
    let start = source.peek(SAMPLE)?;
    let mut lines = start.split_inclusive(|&b| b == b'\n' || b == b'\r');
    let words = |line: &[u8]| tokens(line.split(|&b| b == b'#').next().unwrap_or(&[])).count();
    Ok(lines.find_map(|line| Some(words(line.trim_ascii())).filter(|&count| count > 0)).unwrap_or(WIDEST + 1))
}

/// Reads a face from each line that is left, and counts them.
fn face_lines(source: &mut Source, out: &mut Decoded, options: &ReadOptions) -> Result<u64, Error> {
    let mut count = 0;
    while let Some(line) = next(source)? {
        count += 1;
        if options.mesh.is_some() {
            let mut words = tokens(&line);
            let corners = words.next().and_then(integer).unwrap_or(0);
            let face: Vec<u32> = words.take(corners.min(MOST_CORNERS) as usize).map(index).collect();
            match face.len() as u64 == corners {
                true => out.faces.push(&face),
                false => out.odd_faces += 1,
            }
        }
    }
    Ok(count)
}

/// The number of a vertex.
fn index(word: &[u8]) -> u32 {
    integer(word).and_then(|index| u32::try_from(index).ok()).unwrap_or(NO_VERTEX)
}

/// Reads the faces that are left, and counts them; several may stand on a line: each a count and as many indices, the last of a line perhaps
/// with a colour or with its end on the next line. Stops behind one more than `most`.
fn running_faces(
    source: &mut Source,
    most: u64,
    out: &mut Decoded,
    options: &ReadOptions,
) -> Result<u64, Error> {
    let mut face = Vec::new();
    // Faces on this line, and corners that the last of them has yet to come.
    let (mut there, mut here, mut left, mut colours) = (0u64, 0u64, 0u64, false);
    while there + here <= most {
        match source.word()? {
            Some(Word::Text(word)) if left > 0 => {
                left -= 1;
                here += u64::from(left == 0);
                if options.mesh.is_some() {
                    face.push(index(&word));
                }
                if left == 0 {
                    out.faces.push(&face);
                    face.clear();
                }
            }
            Some(Word::Text(_)) if colours => {}
            Some(Word::Text(word)) => match integer(&word) {
                Some(corners) => {
                    left = corners;
                    here += u64::from(corners == 0);
                }
                None => colours = true,
            },
            end => {
                // A face that is alone on its line counts though its end may stand on the next.
                there += if here == 0 && left > 0 { 1 } else { here };
                (here, left, colours) = (0, 0, false);
                if end.is_none() {
                    return Ok(there);
                }
            }
        }
    }
    Ok(there + here)
}

/// Reads vertices that have a line each, with what stands beside them.
fn lines(source: &mut Source, options: &ReadOptions, vertices: u64, out: &mut Decoded) -> Result<(), Error> {
    let (mut longest, mut width) = (0, 0);
    for row in 0..vertices {
        let line = next(source)?;
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
                return out.cut(source, options, &unit(width), vertices, row);
            }
        }
    }
    if longest > 0 {
        out.ignored.push(format!("{longest} numbers beside the coordinates of vertices"));
    }
    Ok(())
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

/// Reads vertices whose numbers follow each other with no regard to lines.
fn running(
    source: &mut Source,
    options: &ReadOptions,
    vertices: u64,
    out: &mut Decoded,
) -> Result<(), Error> {
    let (mut point, mut axis, mut row) = ([0.0; 3], 0, 0);
    while row < vertices {
        match source.word()? {
            Some(Word::Text(word)) => {
                let Some(value) = parse(&word) else {
                    let found = format!("vertex {row}: coordinate {}", shown(&word));
                    return Err(source.malformed_line(found, "expected three numbers for each vertex"));
                };
                point[axis] = value;
                axis = (axis + 1) % 3;
                if axis == 0 {
                    out.cloud.positions.push(point);
                    row += 1;
                }
            }
            Some(Word::LineEnd) => {}
            None => return out.cut(source, options, "vertices", vertices, row),
        }
    }
    Ok(())
}

/// The numbers of vertices and faces.
fn header(source: &mut Source) -> Result<[u64; 2], Error> {
    let first = next(source)?.unwrap_or_default();
    // A keyword, three counts, and one too many.
    let mut words: Vec<Vec<u8>> = tokens(&first).take(5).map(<[u8]>::to_vec).collect();
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
        words = tokens(&next(source)?.unwrap_or_default()).take(4).map(<[u8]>::to_vec).collect();
    }
    let counts: Vec<u64> = words.iter().map_while(|word| integer(word)).collect();
    match counts.as_slice() {
        [vertices, faces] | [vertices, faces, _] if counts.len() == words.len() => Ok([*vertices, *faces]),
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
