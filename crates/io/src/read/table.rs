//! Rows of numbers: XYZ, TXT, CSV and their kin. The layout (separator, decimal sign, names, a count line) is
//! recognised from the first rows; an ambiguous table is refused, and every later row must fit.

mod layout;
mod names;
mod split;
mod value;

use super::{Decoded, ReadOptions};
use crate::columns::narrowed;
use crate::error::Error;
use crate::number::{integer, shown};
use crate::source::Source;
use layout::{Layout, Role};
use lineament::Attribute;
pub(super) use names::{find_axes, known};
use split::Separator;
use value::value;

/// Reads a table input.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    source.detect_terminator()?;
    if source.peek(3)?.starts_with(b"\xef\xbb\xbf") {
        source.consume(3);
    }
    let layout = layout::find(source, options.columns.as_ref())?;
    let mut rows = Rows::new(source, &layout, options);
    for _ in 0..layout.lines_before {
        source.line()?;
    }
    let mut announced = layout.announced;
    let (mut fault, mut wrong) = (None, false);
    while let Some(line) = source.line()? {
        if split::is_comment(line) {
            continue;
        }
        if let Err(what) = rows.take(line, &layout) {
            if let (Some(before), Some(count)) = (announced, count_line(line)) {
                let read = rows.positions.len() as u64;
                // What is whole of a block that is short stays; the blocks behind it are read on.
                wrong |= read != before && options.salvage;
                announced = Some(if wrong {
                    before.saturating_add(count)
                } else {
                    next_block(source, before, count, read)?
                });
                continue;
            }
            fault = Some(what);
            break;
        }
    }
    finish(source, options, layout, rows, announced, fault)
}

/// A line that is one whole number: in PTS files, how many rows follow.
fn count_line(line: &[u8]) -> Option<u64> {
    integer(line.trim_ascii())
}

/// The rows announced in total once another count line came; the block before must be complete.
fn next_block(source: &Source, before: u64, count: u64, read: u64) -> Result<u64, Error> {
    if read != before {
        let found = format!("a new count line after {read} rows where {before} were announced");
        return Err(source.malformed_line(found, "the counts and the rows do not agree; the file is damaged"));
    }
    Ok(before.saturating_add(count))
}

fn finish(
    source: &mut Source,
    options: &ReadOptions,
    layout: Layout,
    mut rows: Rows,
    announced: Option<u64>,
    fault: Option<Fault>,
) -> Result<Decoded, Error> {
    let read = rows.positions.len() as u64;
    let mut out =
        Decoded { ignored: layout.ignored.clone(), warnings: layout.warnings.clone(), ..Decoded::default() };
    if let Some(fault) = fault {
        let last = source.peek(1)?.is_empty();
        if !(options.salvage && last) {
            return Err(fault.report(source, &layout, read == 0, last));
        }
        out.cut(source, options, "rows", announced.unwrap_or(read + 1), read)?;
    } else if let Some(expected) = announced.filter(|&expected| expected > read) {
        out.cut(source, options, "rows", expected, read)?;
    } else if let Some(expected) = announced.filter(|&expected| expected < read && options.salvage) {
        out.warnings
            .push(format!("{read} rows where count lines announce {expected}: all of them are taken"));
    } else if let Some(expected) = announced.filter(|&expected| expected < read) {
        let found = format!("{read} rows where the count line announces {expected}");
        return Err(source.malformed_line(found, "correct or remove the count line"));
    }
    out.warnings.extend(source.open_end().filter(|_| announced.is_some() && out.missing.is_none()));
    rows.level();
    out.cloud.positions = rows.positions;
    out.cloud.attributes = {
        let named = rows.columns.into_iter();
        named.map(|(name, values)| Attribute { name, values: narrowed(values) }).collect()
    };
    Ok(out)
}

/// The reason why a line is not a row.
enum Fault {
    /// It has this number of columns.
    Columns(usize),
    /// Index of the column, and its text.
    Number(usize, String),
}

impl Fault {
    /// The error of a line that is the first row, or the last line of the input.
    fn report(&self, source: &Source, layout: &Layout, first: bool, last: bool) -> Error {
        let remedy = match (first, last) {
            (true, _) => "if there are columns of text, name all in the first line, such as `id,x,y,z`",
            (_, true) => "if this is no row but a last word, --salvage reads the rows before it",
            _ => "if this is no row, remove the line or put `#` before it",
        };
        match self {
            Fault::Columns(count) => source.malformed_line(
                format!("{count} columns where the first rows have {}", layout.roles.len()),
                format!("every row needs the same columns, separated by {}; {remedy}", layout.separator),
            ),
            Fault::Number(index, token) => source.malformed_line(
                format!("column {} is {token}", index + 1),
                format!(
                    "expected a number{}; {remedy}",
                    if layout.decimal_comma { " with a decimal comma" } else { "" }
                ),
            ),
        }
    }
}

/// The columns that rows go into.
struct Rows {
    positions: Vec<[f64; 3]>,
    columns: Vec<(String, Vec<f64>)>,
    keep: bool,
}

impl Rows {
    fn new(source: &Source, layout: &Layout, options: &ReadOptions) -> Self {
        let likely = source.remaining().map_or(0, |bytes| bytes / layout.row_bytes.max(6)) as usize;
        let room =
            layout.announced.map_or(likely, |count| likely.min(usize::try_from(count).unwrap_or(likely)));
        let named = layout.names.iter().filter(|_| options.attributes);
        let columns = named.map(|name| (name.clone(), Vec::with_capacity(room))).collect();
        Self { positions: Vec::with_capacity(room), columns, keep: options.attributes }
    }

    /// Appends a row; blank lines are skipped.
    fn take(&mut self, line: &[u8], layout: &Layout) -> Result<(), Fault> {
        let mut point = [0.0; 3];
        let mut count = 0;
        let mut fields = split::Fields::new(line, layout.separator);
        while let Some(field) = fields.next_field() {
            if let Some(&role) = layout.roles.get(count) {
                let value = || {
                    let value = value(field, layout.decimal_comma);
                    value.ok_or_else(|| Fault::Number(count, shown(field)))
                };
                match role {
                    Role::Axis(axis) => point[axis] = value()?,
                    Role::Column(column) if self.keep => self.columns[column].1.push(value()?),
                    _ => {}
                }
            }
            count += 1;
        }
        if count + 1 == layout.roles.len() && count > 0 && split::ends_open(line, layout.separator) {
            match layout.roles[count] {
                Role::Axis(axis) => point[axis] = f64::NAN,
                Role::Column(column) if self.keep => self.columns[column].1.push(f64::NAN),
                _ => {}
            }
            count += 1;
        }
        if count == layout.roles.len() {
            self.positions.push(point);
            return Ok(());
        }
        self.level();
        if count == 0 { Ok(()) } else { Err(Fault::Columns(count)) }
    }

    /// Drops the values of an unfinished row.
    fn level(&mut self) {
        let length = self.positions.len();
        self.columns.iter_mut().for_each(|(_, values)| values.truncate(length));
    }
}

impl std::fmt::Display for Separator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Separator::Blanks => "blanks",
            Separator::Byte(b'\t') => "tabs",
            Separator::Byte(b';') => "semicolons",
            Separator::Byte(_) => "commas",
        })
    }
}
