//! Rows of PCD inputs.

use super::header::Header;
use super::lzf::Lzf;
use crate::columns::{Endian, append};
use crate::error::Error;
use crate::number::{parse, shown, token, tokens};
use crate::read::rows::{Field, Table};
use crate::source::Source;

/// Reads rows of text; gives how many were there whole.
pub(super) fn ascii(
    source: &mut Source,
    header: &Header,
    table: &mut Table,
    salvage: bool,
) -> Result<u64, Error> {
    let mut values = vec![0.0; header.fields.len()];
    let mut row = 0;
    while row < header.points {
        let Some(line) = source.line()? else { break };
        if token(line).is_none() {
            continue;
        }
        let fault = match parse_row(line, header, &mut values) {
            Ok(()) => match table.push(&values) {
                Ok(()) => {
                    row += 1;
                    continue;
                }
                Err(field) => format!(
                    "field `{}` of row {row} is {}, which its type cannot hold",
                    header.fields[field].name, values[field]
                ),
            },
            Err(fault) => fault,
        };
        table.level();
        if salvage && source.peek(1)?.is_empty() {
            break;
        }
        return Err(source.malformed_line(fault, format!("expected {} numbers a line", values.len())));
    }
    Ok(row)
}

fn parse_row(line: &[u8], header: &Header, values: &mut [f64]) -> Result<(), String> {
    let mut words = tokens(line);
    for (value, field) in values.iter_mut().zip(&header.fields) {
        let word = words.next().ok_or_else(|| format!("the row ends before field `{}`", field.name))?;
        *value = parse(word).ok_or_else(|| format!("field `{}` is {}", field.name, shown(word)))?;
    }
    match words.next() {
        Some(word) => Err(format!("the row goes on with {}", shown(word))),
        None => Ok(()),
    }
}

/// Bytes unpacked at a time; a multiple of every number's size.
const CHUNK: usize = 1 << 16;

/// Reads compressed columns, which come one after the other: all x, then all y, ... Gives how many rows are whole, and adds to
/// `extra` the packed bytes that no row needs.
pub(super) fn compressed(
    source: &mut Source,
    header: &Header,
    table: &mut Table,
    room: usize,
    extra: &mut u64,
) -> Result<u64, Error> {
    let sizes = source.peek(8)?;
    let Some(&[a, b, c, d, e, f, g, h]) = sizes.first_chunk() else { return Ok(0) };
    let (packed, unpacked) = (u32::from_le_bytes([a, b, c, d]), u32::from_le_bytes([e, f, g, h]));
    let expected = header.points.saturating_mul(header.stride() as u64);
    if u64::from(unpacked) != expected {
        let found = format!("the columns unpack to {unpacked} bytes where the header needs {expected}");
        return Err(source.malformed(found, "the header and the data do not agree; the file is damaged"));
    }
    source.consume(8);
    if source.remaining().is_some_and(|here| here < u64::from(packed)) {
        return Ok(0);
    }
    table.positions.resize(room, [0.0; 3]);
    let mut lzf = Lzf::new(source, packed.into());
    for index in 0..header.fields.len() {
        if !column(&mut lzf, header.fields[index].place, index, table, room)? {
            table.positions.clear();
            table.level();
            return Ok(0);
        }
    }
    // A pipe shows only now that it ends before its columns do.
    let left = lzf.left();
    let unused = source.skip(left)?;
    if unused < left {
        table.positions.clear();
        table.level();
        return Ok(0);
    }
    *extra = unused;
    Ok(header.points)
}

/// Unpacks one column; `false` if the input ends in it.
fn column(lzf: &mut Lzf, place: Field, index: usize, table: &mut Table, rows: usize) -> Result<bool, Error> {
    let size = place.kind.size();
    let mut chunk = vec![0; CHUNK.min(rows * size)];
    let mut row = 0;
    while row < rows {
        let some = (rows - row).min(CHUNK / size);
        let bytes = &mut chunk[..some * size];
        if !lzf.unpack(bytes)? {
            return Ok(false);
        }
        if let Some(axis) = table.axes.iter().position(|&field| field == index) {
            place.kind.fill_axis(bytes, size, 0, Endian::Little, &mut table.positions[row..], axis);
        }
        if let Some((_, attribute)) = table.columns.iter_mut().find(|(field, _)| *field == index) {
            append(&mut attribute.values, bytes, size, 0, Endian::Little);
        }
        row += some;
    }
    Ok(true)
}
