//! Rows of ascii PLY inputs: one line each, blank lines between them allowed.

use super::header::{Element, Kind, Property};
use crate::error::Error;
use crate::number::{parse, shown, token};
use crate::read::rows::Table;
use crate::source::Source;

/// Reads rows into the table; gives how many were there whole. With `salvage` a row that is cut off at the very
/// end of the input is one that is missing.
pub(super) fn rows(
    source: &mut Source,
    element: &Element,
    table: &mut Table,
    salvage: bool,
) -> Result<u64, Error> {
    let mut values = vec![0.0; element.properties.len()];
    let mut row = 0;
    while row < element.count {
        let Some(line) = source.line()? else { break };
        if is_blank_line(line) {
            continue;
        }
        let fault = match parse_row(line, element, &mut values) {
            Err(fault) => fault,
            Ok(()) => match table.push(&values) {
                Ok(()) => {
                    row += 1;
                    continue;
                }
                Err(index) => Fault::Range(index, values[index]),
            },
        };
        table.level();
        if source.peek(1)?.is_empty() && (salvage || matches!(fault, Fault::Short(_))) {
            break;
        }
        return Err(report(source, element, row, fault));
    }
    Ok(row)
}

/// Walks over rows; gives how many were there.
pub(super) fn skip(source: &mut Source, element: &Element) -> Result<u64, Error> {
    if element.properties.is_empty() {
        return Ok(element.count);
    }
    let mut row = 0;
    while row < element.count {
        let Some(line) = source.line()? else { break };
        row += u64::from(!is_blank_line(line));
    }
    Ok(row)
}

fn is_blank_line(line: &[u8]) -> bool {
    token(line).is_none()
}

/// The fault of a row.
enum Fault {
    /// It ends before this property.
    Short(usize),
    /// This token is not the number that the property needs.
    Token(usize, String),
    /// The type of this property cannot hold this value.
    Range(usize, f64),
    /// This token stands behind the last property.
    Long(String),
}

fn parse_row(line: &[u8], element: &Element, values: &mut [f64]) -> Result<(), Fault> {
    let mut rest = line;
    for (index, property) in element.properties.iter().enumerate() {
        let (value, after) = take(rest, index)?;
        values[index] = value;
        rest = after;
        if let Kind::List { .. } = property.kind {
            if !(value >= 0.0 && value.fract() == 0.0) {
                return Err(Fault::Token(index, format!("`{value}` as a list length")));
            }
            for _ in 0..value as u64 {
                rest = take(rest, index)?.1;
            }
        }
    }
    match token(rest) {
        Some((extra, _)) => Err(Fault::Long(shown(extra))),
        None => Ok(()),
    }
}

#[inline]
fn take(line: &[u8], index: usize) -> Result<(f64, &[u8]), Fault> {
    let (word, rest) = token(line).ok_or(Fault::Short(index))?;
    let value = parse(word).ok_or_else(|| Fault::Token(index, shown(word)))?;
    Ok((value, rest))
}

fn report(source: &Source, element: &Element, row: u64, fault: Fault) -> Error {
    let of = |index: usize| element.properties.get(index).map_or("?", |Property { name, .. }| name.as_str());
    let (found, advice) = match fault {
        Fault::Short(index) => (
            format!("row {row} of element `{}` ends before property `{}`", element.name, of(index)),
            format!("expected {} values a line", element.properties.len()),
        ),
        Fault::Token(index, token) => {
            (format!("property `{}` of row {row} is {token}", of(index)), "expected a number".into())
        }
        Fault::Range(index, value) => (
            format!("property `{}` of row {row} is {value}", of(index)),
            "the type that the header gives it cannot hold that".into(),
        ),
        Fault::Long(token) => (
            format!("row {row} of element `{}` goes on with {token} after its last property", element.name),
            format!("expected {} values a line", element.properties.len()),
        ),
    };
    source.malformed_line(found, advice)
}
