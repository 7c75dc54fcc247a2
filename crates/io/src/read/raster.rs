//! The ASCII grid of ESRI: a header of keys, then heights row by row from the north. Each height becomes a point in the middle
//! of its cell; cells without a value are left out.

use super::rows::room;
use super::{Decoded, ReadOptions};
use crate::error::Error;
use crate::number::{integer, parse, shown, tokens};
use crate::source::{Source, Word};

/// The height of cells without one where the header gives none.
const NO_DATA: f64 = -9999.0;

/// What the header says.
#[derive(Default)]
struct Header {
    columns: Option<u64>,
    rows: Option<u64>,
    /// Least x and y, and whether they are those of the middle of a cell.
    corner: [Option<(f64, bool)>; 2],
    cell: [Option<f64>; 2],
    none: Option<f64>,
}

/// Whether text begins as a grid does.
pub(crate) fn begins(word: &[u8]) -> bool {
    word.eq_ignore_ascii_case(b"ncols") || word.eq_ignore_ascii_case(b"nrows")
}

/// Reads a grid.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    if source.peek(3)?.starts_with(b"\xef\xbb\xbf") {
        source.consume(3);
    }
    source.detect_terminator()?;
    let Grid { columns, rows, first, cell, none } = header(source)?.grid(source)?;
    let count = columns.saturating_mul(rows);
    let mut out = Decoded::default();
    out.cloud.positions.reserve_exact(room(source, count, 2));
    let (mut done, mut empty) = (0, 0u64);
    while let Some(word) = source.word()? {
        let Word::Text(word) = word else { continue };
        if done == count {
            let found = format!("more heights than the {columns} times {rows} of the header");
            return Err(
                source.malformed_line(found, "the header and the rows do not agree; the file is damaged")
            );
        }
        let Some(height) = parse(&word) else {
            let found = format!("height {} of {count} is {}", done + 1, shown(&word));
            return Err(source.malformed_line(found, "expected a number"));
        };
        // Rows come from the north.
        let [x, y] = [done % columns, rows - 1 - done / columns].map(|index| index as f64);
        done += 1;
        if none == height || none.is_nan() && height.is_nan() {
            empty += 1;
        } else {
            out.cloud.positions.push([first[0] + x * cell[0], first[1] + y * cell[1], height]);
        }
    }
    if done < count {
        out.cut(source, options, "heights", count, done)?;
    } else {
        out.warnings.extend(source.open_end());
    }
    if empty > 0 {
        out.ignored.push(format!("{empty} cells without a height"));
    }
    Ok(out)
}

/// A grid of heights.
struct Grid {
    columns: u64,
    rows: u64,
    /// The middle of the cell in the southwest, and the sides of a cell.
    first: [f64; 2],
    cell: [f64; 2],
    none: f64,
}

/// The header: lines of a key and its value, up to the first height, which may be `nan`.
fn header(source: &mut Source) -> Result<Header, Error> {
    let mut header = Header::default();
    while begins_with_key(source.peek(1 << 8)?) {
        let Some(line) = source.line()? else { break };
        let line = line.to_vec();
        let words: Vec<&[u8]> = tokens(&line).take(3).collect();
        let known = match words.as_slice() {
            [] => continue,
            [key, value] => header.take(&key.to_ascii_lowercase(), value),
            _ => None,
        };
        if known.is_none() {
            return Err(source.malformed_line(
                format!("header line {}", shown(&line)),
                "expected ncols, nrows, xllcorner, yllcorner, cellsize or NODATA_value, and a number",
            ));
        }
    }
    Ok(header)
}

fn begins_with_key(text: &[u8]) -> bool {
    let word = tokens(text.trim_ascii_start()).next().unwrap_or_default();
    word.first().is_some_and(u8::is_ascii_alphabetic) && parse(word).is_none()
}

impl Header {
    /// The grid, if all is there that it needs.
    fn grid(&self, source: &Source) -> Result<Grid, Error> {
        let lacks = |what: &str| {
            source.malformed_line(
                format!("a grid without `{what}`"),
                "its header must give ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, and cellsize",
            )
        };
        let columns = self.columns.filter(|&count| count > 0).ok_or_else(|| lacks("ncols"))?;
        let rows = self.rows.ok_or_else(|| lacks("nrows"))?;
        let (mut first, mut cell) = ([0.0; 2], [0.0; 2]);
        for (axis, name) in ["xllcorner", "yllcorner"].into_iter().enumerate() {
            let (corner, middle) = self.corner[axis].ok_or_else(|| lacks(name))?;
            cell[axis] = self.cell[axis].filter(|&size| size > 0.0).ok_or_else(|| lacks("cellsize"))?;
            first[axis] = corner + if middle { 0.0 } else { 0.5 * cell[axis] };
        }
        Ok(Grid { columns, rows, first, cell, none: self.none.unwrap_or(NO_DATA) })
    }

    /// Takes a key; `None` if there is no such key, or its value is none.
    fn take(&mut self, key: &[u8], value: &[u8]) -> Option<()> {
        let number = || parse(value).filter(|number| number.is_finite());
        match key {
            b"ncols" => self.columns = Some(integer(value)?),
            b"nrows" => self.rows = Some(integer(value)?),
            b"xllcorner" => self.corner[0] = Some((number()?, false)),
            b"xllcenter" => self.corner[0] = Some((number()?, true)),
            b"yllcorner" => self.corner[1] = Some((number()?, false)),
            b"yllcenter" => self.corner[1] = Some((number()?, true)),
            b"cellsize" => self.cell = [Some(number()?); 2],
            b"dx" => self.cell[0] = Some(number()?),
            b"dy" => self.cell[1] = Some(number()?),
            b"nodata_value" => self.none = Some(parse(value)?),
            _ => return None,
        }
        Some(())
    }
}
