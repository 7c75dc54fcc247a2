//! A number for each point: marks and labels, as an array (NPY), as bytes, as the last column of a text, or as the column `class` of
//! points.

use super::{ReadOptions, npy};
use crate::columns::get;
use crate::error::Error;
use crate::number::{parse, shown, tokens};
use crate::source::Source;
use std::path::Path;

/// The column that `classify` writes.
const CLASS: &str = "class";
/// Bytes in which the first line of a text ends.
const LOOK: usize = 1 << 12;
/// Extension of files with a byte for each point.
const BYTES: [&str; 2] = ["u8", "bin"];

/// Reads `(N)` numbers: an NPY array of one column, a file `.u8` or `.bin` of bytes, or text with a row for each point, of which the
/// last number counts; or the column `class` of points in any other format, as `classify` writes them.
///
/// # Errors
/// An input that cannot be opened, is empty, or breaks its format's rules.
pub fn read_marks(path: &Path) -> Result<Vec<f64>, Error> {
    let name = path.display().to_string();
    let (mut source, _) = super::open(path, false)?;
    let start = source.peek(npy::MAGIC.len())?;
    if start.is_empty() {
        return Err(Error::Empty { name });
    }
    if start.starts_with(npy::MAGIC) {
        return array(&mut source);
    }
    if path.extension().is_some_and(|e| BYTES.iter().any(|known| e.eq_ignore_ascii_case(known))) {
        return Ok(super::lines::all(&mut source)?.into_iter().map(f64::from).collect());
    }
    if is_plain(source.peek(LOOK)?) {
        return text(&mut source);
    }
    of_points(path)
}

/// Whether the first line that is no comment ends in a number.
fn is_plain(start: &[u8]) -> bool {
    let lines = start.split(|&b| b == b'\n' || b == b'\r');
    let mut rows =
        lines.filter(|line| !line.trim_ascii().is_empty() && !line.trim_ascii_start().starts_with(b"#"));
    let last = |line| tokens(line).last().is_some_and(|word| parse(word).is_some());
    !start.contains(&0) && rows.next().is_none_or(last)
}

/// The column of the classes of points.
fn of_points(path: &Path) -> Result<Vec<f64>, Error> {
    let mut columns = super::read(path, &ReadOptions::default())?.cloud.attributes;
    if let Some(found) = columns.iter().position(|column| column.name == CLASS) {
        let values = columns.swap_remove(found).values;
        return Ok((0..values.len()).map(|i| get(&values, i)).collect());
    }
    let names: Vec<String> = columns.into_iter().map(|column| format!("`{}`", column.name)).collect();
    let names = if names.is_empty() { "none".into() } else { names.join(", ") };
    Err(Error::Unsupported {
        name: path.display().to_string(),
        what: format!("points without a column `{CLASS}`: the columns are {names}"),
        advice: "marks and labels are taken from that column, from an array of shape (N,) (.npy), from bytes (.u8) or from the last column of a text".into(),
    })
}

fn array(source: &mut Source) -> Result<Vec<f64>, Error> {
    let header = npy::parse(&npy::text(source)?)
        .and_then(|header| match header.fields.len() {
            1 => Ok(header),
            columns => Err(format!("an array of {columns} columns")),
        })
        .map_err(|found| source.malformed(found, "expected an array of shape (N,)"))?;
    let needed = header.rows.saturating_mul(header.stride as u64);
    let there = source.remaining().unwrap_or(u64::MAX);
    let short =
        |source: &Source, there: u64| source.ends_early("rows", header.rows, there / header.stride as u64);
    if there < needed {
        return Err(short(source, there));
    }
    let columns = npy::arrays(source, &header)?.ok_or_else(|| short(source, 0))?;
    let values = |column: &lineament::Column| (0..column.len()).map(|i| get(column, i)).collect();
    Ok(columns.first().map_or_else(Vec::new, values))
}

fn text(source: &mut Source) -> Result<Vec<f64>, Error> {
    source.detect_terminator()?;
    let mut values = Vec::new();
    while let Some(line) = source.line()? {
        let line = line.to_vec();
        let Some(word) = tokens(&line).last().filter(|_| !line.trim_ascii_start().starts_with(b"#")) else {
            continue;
        };
        match parse(word) {
            Some(value) => values.push(value),
            None => return Err(source.malformed_line(shown(word), "expected a number")),
        }
    }
    Ok(values)
}
