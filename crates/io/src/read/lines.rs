//! Lines from files: results and truths of evaluations, by the content of the file.

mod dxf;
mod json;
mod mesh;
mod obj;
mod sample;
mod step;

use super::detect;
use crate::error::{Error, printable};
use crate::format::Format;
use crate::source::Source;
use lineament::evaluate::{CurveKind, Line, LineKind, Lines, TypedCurve};
use lineament::math::vec3::distance;
use std::path::Path;

/// Lines as a file holds them.
#[derive(Clone, Debug, PartialEq)]
pub struct LineFile {
    /// The lines, in the frame and the unit of the file.
    pub lines: Lines,
    /// The name of the format.
    pub format: String,
    /// Mean spacing of the points that the lines belong to, where the file states it.
    pub spacing: Option<f64>,
    /// The parameters that the lines were made with, where the file states them: key and value.
    pub parameters: Vec<(String, String)>,
    /// What was passed over, one sentence each.
    pub ignored: Vec<String>,
}

impl LineFile {
    fn new(format: impl Into<String>) -> Self {
        Self {
            lines: Lines::default(),
            format: format.into(),
            spacing: None,
            parameters: Vec::new(),
            ignored: Vec::new(),
        }
    }

    /// Adds a curve as a line, and as a typed one where its type is known.
    fn curve(&mut self, kind: LineKind, points: Vec<[f64; 3]>, typed: Option<(CurveKind, Option<f64>)>) {
        if points.len() < 2 {
            return;
        }
        if let Some((kind, radius)) = typed {
            self.lines.curves.push(TypedCurve { kind, radius, points: points.clone() });
        }
        self.lines.lines.push(closed_by_its_end(kind, points));
    }
}

/// Shares of its length up to which the ends of a line are one place, that differ by rounding alone.
const SAME: f64 = 1e-9;

/// Whether a row of points ends where it begins.
fn ends_in_its_first(points: &[[f64; 3]]) -> bool {
    let length: f64 = points.windows(2).map(|w| distance(w[0], w[1])).sum();
    let ends = points.first().zip(points.last()).filter(|_| points.len() > 1);
    ends.is_some_and(|(&a, &b)| distance(a, b) <= SAME * length)
}

/// A line that is closed where it ends in its first point.
fn closed_by_its_end(kind: LineKind, mut points: Vec<[f64; 3]>) -> Line {
    let closed = points.len() > 3 && ends_in_its_first(&points);
    if closed {
        points.pop();
    }
    Line { kind, closed, points }
}

/// The kind of the lines of a layer, group or name.
fn kind_of(name: &[u8]) -> LineKind {
    let has = |word: &[u8]| name.windows(word.len()).any(|part| part.eq_ignore_ascii_case(word));
    match () {
        () if has(b"border") => LineKind::Border,
        // Without their radii they are no lines to score.
        () if has(b"rounded") => LineKind::Weak,
        () => LineKind::Crease,
    }
}

/// Reads the lines in the file at `path`: a network or a truth in JSON, DXF, a wireframe in STEP, OBJ with lines, or a mesh, whose lines
/// are its borders and the edges at which its faces meet at more than `angle_deg` degrees.
///
/// # Errors
/// An input that cannot be opened, is empty, breaks its format's rules, has a coordinate that is not finite, or holds no lines by
/// its format, such as points.
pub fn read_lines(path: &Path, angle_deg: f64) -> Result<LineFile, Error> {
    let name = path.display().to_string();
    let (mut source, length) = super::open(path, false)?;
    let start = source.peek(1 << 16)?.to_vec();
    let text = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&start).trim_ascii_start();
    let format = detect::detect(&start, length, &name);
    let found = match (text.first(), format) {
        (None, _) => return Err(Error::Empty { name }),
        (Some(b'{' | b'['), Err(_) | Ok(Format::Table)) => json::read(&mut source)?,
        _ if text.starts_with(b"ISO-10303-21") => step::read(&mut source)?,
        _ if dxf::begins(text) => dxf::read(&mut source)?,
        (_, Ok(Format::Obj)) => match obj::read(&mut source)? {
            Some(lines) => lines,
            None => mesh::read(path, Format::Obj, angle_deg)?,
        },
        (_, Ok(format)) => mesh::read(path, format, angle_deg)?,
        (_, Err(error)) => return Err(error),
    };
    finite(&found, &name)?;
    Ok(LineFile { ignored: found.ignored.iter().map(|what| printable(what)).collect(), ..found })
}

/// Refuses a coordinate that is not finite.
fn finite(found: &LineFile, name: &str) -> Result<(), Error> {
    let lines = found.lines.lines.iter().map(|l| &l.points);
    let all = lines.chain(found.lines.curves.iter().map(|c| &c.points));
    let all = all.chain(&found.lines.junctions).chain(found.lines.rounded.iter().map(|e| &e.points));
    for (number, points) in all.enumerate() {
        if let Some(p) = points.iter().find(|p| !p.iter().all(|x| x.is_finite())) {
            let what = format!("line {number} has the point {p:?}");
            return Err(Error::Unsupported {
                name: name.into(),
                what,
                advice: "give finite coordinates".into(),
            });
        }
    }
    Ok(())
}

/// All bytes of an input.
pub(super) fn all(source: &mut Source) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    loop {
        let here = source.peek(1)?;
        if here.is_empty() {
            return Ok(bytes);
        }
        bytes.extend_from_slice(here);
        let count = here.len();
        source.consume(count);
    }
}
