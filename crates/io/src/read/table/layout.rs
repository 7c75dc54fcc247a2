//! The layout of a table, recognised from its first rows.

use super::names::{self, Refusal};
use super::split::{Separator, ends_open, fields, is_comment, uncommented};
use super::value::value;
use crate::error::{Error, Place};
use crate::number::{integer, is_blank, parse, shown, tokens};
use crate::source::Source;

/// Bytes and rows that the layout is recognised from.
const SAMPLE_BYTES: usize = 1 << 16;
const SAMPLE_ROWS: usize = 200;
/// Rows from which on a first column that counts is taken for one of point numbers.
const COUNTED_ROWS: usize = 5;
const COUNTED: &str = "the first column counts the rows, as point numbers do, and is taken for x: if x, y and z are columns 2, 3 \
    and 4, read it with --columns 2,3,4";

/// The role of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// x, y or z, as 0, 1 or 2.
    Axis(usize),
    /// An attribute, by its index into `Layout::names`.
    Column(usize),
    /// Text, which is left out.
    Text,
}

/// How rows are written.
#[derive(Debug)]
pub(super) struct Layout {
    pub separator: Separator,
    pub decimal_comma: bool,
    pub roles: Vec<Role>,
    /// Names of the attributes.
    pub names: Vec<String>,
    /// Lines before the first row.
    pub lines_before: u64,
    /// The number of rows that a count line announces.
    pub announced: Option<u64>,
    /// Bytes of a row, roughly: the mean of the sample.
    pub row_bytes: u64,
    /// Parts that are left out, one sentence each.
    pub ignored: Vec<String>,
    /// What makes the roles of the columns doubtful, one sentence each.
    pub warnings: Vec<String>,
}

/// The lines that the layout is recognised from.
#[derive(Default)]
struct Sample {
    /// Rows: lines with at least three numbers.
    rows: Vec<Vec<u8>>,
    /// The last line before the rows that is no comment, or else the last comment.
    header: Option<Vec<u8>>,
    header_is_comment: bool,
    titles: u64,
    lines_before: u64,
    announced: Option<u64>,
    bytes: usize,
}

/// Recognises the layout; the source stays where it is. `asked` are the columns of x, y and z, by name or by number from 1 on.
pub(super) fn find(source: &mut Source, asked: Option<&[String; 3]>) -> Result<Layout, Error> {
    let sample = sample(source)?;
    if sample.rows.is_empty() {
        let place = Place::Line(1);
        let found = "no row of three numbers at the beginning".to_string();
        return Err(source.fault(
            place,
            found,
            "expected rows of x y z, separated by blanks, commas or semicolons",
        ));
    }
    let place = Place::Line(sample.lines_before + 1);
    let (separator, decimal_comma) =
        separator(&sample.rows).map_err(|(found, advice)| source.fault(place, found, advice))?;
    let columns = columns(&sample, separator);
    let lines = names::Lines { header: sample.header.as_deref(), is_comment: sample.header_is_comment };
    let named = names::of(&lines, separator, columns, asked);
    let header = named.clone().or_else(|| names::usual(source.name(), columns));
    if header.is_none() && asked.is_none() {
        names::misfit(&lines, separator, columns)
            .map_err(|(found, advice)| source.fault(place, found, advice))?;
    }
    let titles = sample.titles - u64::from(named.is_some() && !sample.header_is_comment);
    let bare = header.is_none() && asked.is_none();
    if bare {
        told_apart(&sample.rows, separator, columns)
            .map_err(|(found, advice)| source.fault(place, found, advice))?;
    }
    let mut layout = Layout {
        separator,
        decimal_comma,
        roles: Vec::new(),
        names: Vec::new(),
        lines_before: sample.lines_before,
        announced: sample.announced,
        row_bytes: (sample.bytes / sample.rows.len()) as u64,
        ignored: Vec::new(),
        warnings: Vec::new(),
    };
    if bare && columns > 3 && counts(&sample.rows, &layout) {
        layout.warnings.push(COUNTED.into());
    }
    names::axes(header.as_deref(), asked, columns)
        .and_then(|axes| assign(&mut layout, axes, header, &sample.rows, columns))
        .map_err(|(found, advice)| source.fault(place, found, advice))?;
    if titles > 0 {
        layout.ignored.push(format!("{titles} title lines before the rows"));
    }
    Ok(layout)
}

/// Gathers the sample from the bytes ahead, without moving the source.
fn sample(source: &mut Source) -> Result<Sample, Error> {
    let start = source.peek(SAMPLE_BYTES)?;
    let cut = start.len() >= SAMPLE_BYTES;
    let bare = !start.contains(&b'\n');
    let mut lines: Vec<&[u8]> = start.split(|&b| b == if bare { b'\r' } else { b'\n' }).collect();
    if cut {
        lines.pop();
    }
    let mut sample = Sample::default();
    for line in lines {
        sample.take(line);
        if sample.rows.len() == SAMPLE_ROWS {
            break;
        }
    }
    Ok(sample)
}

impl Sample {
    fn take(&mut self, line: &[u8]) {
        let blank = line.trim_ascii().is_empty();
        let count = integer(line.trim_ascii());
        if !blank && !is_comment(line) && (count.is_none() || !self.rows.is_empty()) && is_row(line) {
            self.bytes += line.len() + 1;
            self.rows.push(line.to_vec());
            return;
        }
        if !self.rows.is_empty() {
            return;
        }
        self.lines_before += 1;
        if blank {
            return;
        }
        if is_comment(line) {
            if self.header.is_none() || self.header_is_comment {
                self.header = Some(uncommented(line).to_vec());
                self.header_is_comment = true;
            }
        } else if count.is_some() {
            self.announced = count;
        } else {
            self.titles += 1;
            self.header = Some(line.to_vec());
            self.header_is_comment = false;
        }
    }
}

/// Whether a line is a row, whatever the separator is: three numbers or more, or nothing but numbers. A short row
/// is a row too, so that it is refused and not taken for a title.
fn is_row(line: &[u8]) -> bool {
    let (mut numbers, mut digits, mut words) = (0, false, false);
    for part in line.split(|&b| is_blank(b) || matches!(b, b',' | b';' | b'"')) {
        if parse(part).is_some() {
            numbers += 1;
            digits |= part.iter().any(u8::is_ascii_digit);
        } else {
            words |= part.iter().any(u8::is_ascii_alphabetic);
        }
    }
    digits && (numbers >= 3 || !words)
}

/// The separator and whether the decimal sign is a comma.
fn separator(rows: &[Vec<u8>]) -> Result<(Separator, bool), Refusal> {
    let everywhere = |byte: u8| rows.iter().all(|row| row.contains(&byte));
    let separator = if everywhere(b';') {
        Separator::Byte(b';')
    } else if everywhere(b'\t') && same_count(rows, b'\t') {
        Separator::Byte(b'\t')
    } else if everywhere(b',') && !decimal_commas(rows, Separator::Blanks) {
        return Ok((Separator::Byte(b','), false));
    } else {
        Separator::Blanks
    };
    if !rows.iter().any(|row| row.contains(&b',')) {
        return Ok((separator, false));
    }
    if decimal_commas(rows, separator) {
        return Ok((separator, true));
    }
    let row = rows.iter().find(|row| row.contains(&b',')).map_or(&[] as &[u8], |row| row);
    Err((
        format!("commas that are neither separators nor decimal signs in {}", shown(row)),
        "write decimal points, and separate by blanks, commas or semicolons".into(),
    ))
}

fn same_count(rows: &[Vec<u8>], byte: u8) -> bool {
    let count = |row: &Vec<u8>| fields(row, Separator::Byte(byte)).len();
    let whole = |row: &Vec<u8>| fields(row, Separator::Byte(byte)).iter().all(|f| tokens(f).count() <= 1);
    let first = rows.first().map_or(0, count);
    first >= 3 && rows.iter().all(|row| count(row) == first && whole(row))
}

/// Whether, with this separator, rows have at least three fields, some hold one comma between digits, none more
/// than one, and no number has a decimal point.
fn decimal_commas(rows: &[Vec<u8>], separator: Separator) -> bool {
    let mut seen = false;
    for row in rows {
        let fields = fields(row, separator);
        if fields.len() < 3 {
            return false;
        }
        for field in fields {
            let commas = field.iter().filter(|&&b| b == b',').count();
            if commas == 0 && parse(field).is_some() && field.contains(&b'.') {
                return false;
            }
            if commas == 0 {
                continue;
            }
            let at = field.iter().position(|&b| b == b',').unwrap_or(0);
            let digit = |i: usize| field.get(i).is_some_and(u8::is_ascii_digit);
            if commas > 1 || field.contains(&b'.') || at == 0 || !digit(at - 1) || !digit(at + 1) {
                return false;
            }
            seen = true;
        }
    }
    seen
}

/// Refuses rows of which each comma could be a decimal sign.
fn told_apart(rows: &[Vec<u8>], separator: Separator, columns: usize) -> Result<(), Refusal> {
    if separator != Separator::Byte(b',') || columns <= 3 || !all_digits(rows) {
        return Ok(());
    }
    let found = format!("{columns} columns of whole numbers separated by commas, without names");
    let advice =
        "the commas may be decimal signs: put a line of names (x,y,z,...) first, or separate by semicolons";
    Err((found, advice.into()))
}

/// Whether the first column counts the rows in even steps. Rows of a grid count as well, but along them the second column stays.
fn counts(rows: &[Vec<u8>], layout: &Layout) -> bool {
    let column = |at: usize| -> Option<Vec<f64>> {
        rows.iter().map(|row| value(fields(row, layout.separator).get(at)?, layout.decimal_comma)).collect()
    };
    let (Some(first), Some(second)) = (column(0), column(1)) else { return false };
    let [from, next, ..] = first[..] else { return false };
    let step = next - from;
    let even = first.windows(2).all(|pair| pair[1] - pair[0] == step);
    let along = second.windows(2).all(|pair| pair[0] == pair[1]);
    rows.len() >= COUNTED_ROWS && even && step >= 1.0 && from.fract() == 0.0 && step.fract() == 0.0 && !along
}

/// Whether no row has a decimal point or an exponent.
fn all_digits(rows: &[Vec<u8>]) -> bool {
    rows.iter().all(|row| !row.iter().any(|b| matches!(b, b'.' | b'e' | b'E')))
}

/// The number of columns: those of the first row, and one more where it ends in a separator and the names or other rows
/// have one more.
fn columns(sample: &Sample, separator: Separator) -> usize {
    let count = |line: &[u8]| fields(line, separator).len();
    let first = sample.rows.first().map_or(&[] as &[u8], Vec::as_slice);
    let more = |line: &[u8]| count(line) == count(first) + 1;
    let header = sample.header.as_deref().is_some_and(|header| !sample.header_is_comment && more(header));
    let open = ends_open(first, separator) && (header || sample.rows.iter().any(|row| more(row)));
    count(first) + usize::from(open)
}

/// Gives every column its role.
fn assign(
    layout: &mut Layout,
    axes: [usize; 3],
    header: Option<Vec<String>>,
    rows: &[Vec<u8>],
    columns: usize,
) -> Result<(), Refusal> {
    if columns < 3 {
        return Err((format!("rows of {columns} columns"), "points need three coordinates".into()));
    }
    let cells: Vec<Vec<&[u8]>> = rows.iter().map(|row| fields(row, layout.separator)).collect();
    let sample = |column: usize| {
        let filled = cells.iter().filter_map(|row| row.get(column)).find(|cell| !cell.is_empty());
        filled.copied().unwrap_or_default()
    };
    for column in 0..columns {
        let name =
            header.as_ref().map_or_else(|| format!("column_{}", column + 1), |names| names[column].clone());
        let role = if let Some(axis) = axes.iter().position(|&c| c == column) {
            Role::Axis(axis)
        } else if value(sample(column), layout.decimal_comma).is_some() {
            layout.names.push(name);
            Role::Column(layout.names.len() - 1)
        } else {
            layout.ignored.push(format!("column `{name}`: text"));
            Role::Text
        };
        layout.roles.push(role);
    }
    Ok(())
}
