//! Lines of Wavefront OBJ: `l` statements over `v` lines. A line that ends in its first vertex is closed; lines of a group or an object whose
//! name holds `border` are borders.

use super::{LineFile, closed_by_its_end, kind_of};
use crate::error::Error;
use crate::number::{integer, parse, shown, token, tokens};
use crate::source::Source;
use lineament::evaluate::LineKind;

/// Reads vertices and lines; `None` where there is no line.
pub(super) fn read(source: &mut Source) -> Result<Option<LineFile>, Error> {
    source.detect_terminator()?;
    let (mut vertices, mut kind, mut out) = (Vec::new(), LineKind::Crease, LineFile::new("OBJ"));
    while let Some(line) = source.line()? {
        let line = line.to_vec();
        match token(&line) {
            Some((b"v", rest)) => {
                let numbers: Option<Vec<f64>> = tokens(rest).take(3).map(parse).collect();
                let Some(Ok(vertex)) = numbers.map(<[f64; 3]>::try_from) else {
                    return Err(source.malformed_line(format!("`v {}`", shown(rest)), "expected `v X Y Z`"));
                };
                vertices.push(vertex);
            }
            Some((b"l", rest)) => {
                let points: Option<Vec<[f64; 3]>> = tokens(rest).map(|w| vertex(w, &vertices)).collect();
                let Some(points) = points.filter(|points| points.len() > 1) else {
                    let advice = "expected the numbers of two vertices or more that stand before it";
                    return Err(source.malformed_line(format!("`l {}`", shown(rest)), advice));
                };
                out.lines.lines.push(closed_by_its_end(kind, points));
            }
            Some((b"g" | b"o", rest)) => kind = kind_of(rest),
            _ => {}
        }
    }
    Ok((!out.lines.lines.is_empty()).then_some(out))
}

/// The vertex that a word such as `3`, `3/1` or `-1` names.
fn vertex(word: &[u8], vertices: &[[f64; 3]]) -> Option<[f64; 3]> {
    let number = word.split(|&b| b == b'/').next()?;
    let index = match number.strip_prefix(b"-") {
        Some(back) => (vertices.len() as u64).checked_sub(integer(back)?)?,
        None => integer(number)?.checked_sub(1)?,
    };
    vertices.get(index as usize).copied()
}
