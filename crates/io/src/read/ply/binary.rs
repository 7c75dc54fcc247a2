//! Rows of binary PLY inputs.

use super::header::{Element, Kind};
use crate::columns::{Endian, append};
use crate::error::Error;
use crate::read::rows::{Field, Table};
use crate::source::Source;

/// The offset of every property in a row and the bytes of a row; `None` if a list makes rows differ.
fn layout(element: &Element) -> Option<(Vec<Field>, usize)> {
    let mut stride = 0;
    let mut fields = Vec::with_capacity(element.properties.len());
    for property in &element.properties {
        let Kind::Scalar(kind) = property.kind else { return None };
        fields.push(Field { offset: stride, kind });
        stride += kind.size();
    }
    Some((fields, stride))
}

/// Reads rows into the table; gives how many were there whole.
pub(super) fn rows(
    source: &mut Source,
    element: &Element,
    endian: Endian,
    table: &mut Table,
) -> Result<u64, Error> {
    match layout(element) {
        Some((fields, stride)) => table.read(source, element.count, stride, &fields, endian),
        None => varied(source, element, endian, table),
    }
}

/// Walks over rows; gives how many were there whole.
pub(super) fn skip(source: &mut Source, element: &Element, endian: Endian) -> Result<u64, Error> {
    match layout(element) {
        Some((_, 0)) => Ok(element.count),
        Some((_, stride)) => {
            let wanted = element.count.saturating_mul(stride as u64);
            let got = source.skip(wanted)?;
            Ok(if got == wanted { element.count } else { got / stride as u64 })
        }
        None => {
            let mut row = 0;
            while row < element.count && walk(source, element, endian, |_, _| ())? {
                row += 1;
            }
            Ok(row)
        }
    }
}

/// Rows with lists: one at a time.
fn varied(source: &mut Source, element: &Element, endian: Endian, table: &mut Table) -> Result<u64, Error> {
    let mut row = 0;
    let mut fields = vec![[0u8; 8]; element.properties.len()];
    while row < element.count {
        if !walk(source, element, endian, |index, bytes| fields[index][..bytes.len()].copy_from_slice(bytes))?
        {
            break;
        }
        let value = |index: usize| match element.properties[index].kind {
            Kind::Scalar(kind) => kind.value(&fields[index], endian),
            Kind::List { .. } => 0.0,
        };
        table.positions.push(table.axes.map(value));
        for (index, attribute) in &mut table.columns {
            append(&mut attribute.values, &fields[*index], 8, 0, endian);
        }
        row += 1;
    }
    Ok(row)
}

/// Moves over one row, handing every scalar's index and bytes to `take`. `false` where the input ends before.
fn walk(
    source: &mut Source,
    element: &Element,
    endian: Endian,
    mut take: impl FnMut(usize, &[u8]),
) -> Result<bool, Error> {
    for (index, property) in element.properties.iter().enumerate() {
        let (first, item) = match property.kind {
            Kind::Scalar(kind) => (kind, None),
            Kind::List { count, item } => (count, Some(item)),
        };
        let here = source.peek(first.size())?;
        if here.len() < first.size() {
            return Ok(false);
        }
        let count = first.value(here, endian);
        if item.is_none() {
            take(index, &here[..first.size()]);
        } else if count < 0.0 {
            let found = format!("list `{}` has {count} items", property.name);
            return Err(source.malformed(found, "a length cannot be negative; the file is damaged"));
        }
        source.consume(first.size());
        if let Some(item) = item {
            let wanted = (count as u64).saturating_mul(item.size() as u64);
            if source.skip(wanted)? < wanted {
                return Ok(false);
            }
        }
    }
    Ok(true)
}
