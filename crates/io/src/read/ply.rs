//! PLY, the polygon file format (Turk 1994): a header of elements with typed properties, then their rows as text
//! or as little or big endian bytes. The points are element `vertex`; everything else is walked over, so that a
//! file that ends early is noticed wherever it ends.

mod ascii;
mod binary;
mod faces;
mod header;

use super::rows::{self, Table, room};
use super::{Decoded, ReadOptions};
use crate::error::Error;
use crate::source::Source;
use header::{Element, Encoding, Header, Kind};

/// Reads a PLY input from its first byte.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    let header = header::parse(source, options)?;
    let mut out = Decoded::default();
    for element in &header.elements {
        let whole = if element.is_vertex() {
            read_vertices(source, &header, element, options, &mut out)?
        } else {
            let rows = match element.corners().filter(|_| options.mesh.is_some()) {
                Some(list) => faces::read(source, header.encoding, element, list, &mut out)?,
                None => skip(source, header.encoding, element)?,
            };
            check(source, element, rows, options, &mut out)?
        };
        if !whole {
            break;
        }
    }
    note_ignored(source, &header, options, &mut out)?;
    Ok(out)
}

/// Whether all rows of an element were there; otherwise an error, or with salvage a note.
fn check(
    source: &Source,
    element: &Element,
    rows: u64,
    options: &ReadOptions,
    out: &mut Decoded,
) -> Result<bool, Error> {
    if rows == element.count {
        return Ok(true);
    }
    let unit =
        if element.is_vertex() { "points".into() } else { format!("rows of element `{}`", element.name) };
    out.cut(source, options, &unit, element.count, rows)?;
    Ok(false)
}

fn read_vertices(
    source: &mut Source,
    header: &Header,
    element: &Element,
    options: &ReadOptions,
    out: &mut Decoded,
) -> Result<bool, Error> {
    let mut table = table(source, header.encoding, element, options)?;
    let rows = match header.encoding {
        Encoding::Ascii => ascii::rows(source, element, &mut table, options.salvage)?,
        Encoding::Binary(endian) => binary::rows(source, element, endian, &mut table)?,
    };
    out.cloud = table.into_cloud();
    check(source, element, rows, options, out)
}

fn skip(source: &mut Source, encoding: Encoding, element: &Element) -> Result<u64, Error> {
    match encoding {
        Encoding::Ascii => ascii::skip(source, element),
        Encoding::Binary(endian) => binary::skip(source, element, endian),
    }
}

/// Empty columns, with room for the announced number of rows, up to the number that the bytes of the input can hold.
fn table(
    source: &Source,
    encoding: Encoding,
    element: &Element,
    options: &ReadOptions,
) -> Result<Table, Error> {
    let axes = element.axes(source)?;
    let room = room(source, element.count, element.least_bytes(encoding));
    let mut attributes = Vec::new();
    let kept = element.properties.iter().enumerate().filter(|(i, _)| options.attributes && !axes.contains(i));
    for (index, property) in kept {
        if let Kind::Scalar(kind) = property.kind {
            attributes.push((index, property.name.clone(), kind));
        }
    }
    Ok(Table::new(axes, attributes, room))
}

/// Notes the elements that were skipped and the bytes after the last one.
fn note_ignored(
    source: &mut Source,
    header: &Header,
    options: &ReadOptions,
    out: &mut Decoded,
) -> Result<(), Error> {
    for element in &header.elements {
        if !element.is_vertex() {
            if element.count > 0 && (options.mesh.is_none() || element.corners().is_none()) {
                out.ignored.push(format!("element `{}`, {} rows: not points", element.name, element.count));
            }
            continue;
        }
        for property in &element.properties {
            if matches!(property.kind, Kind::List { .. }) {
                out.ignored.push(format!("list property `{}` of the points", property.name));
            }
        }
        if !options.attributes && element.properties.len() > 3 {
            out.ignored.push(format!("{} properties beside the positions", element.properties.len() - 3));
        }
    }
    if out.missing.is_some() {
        return Ok(());
    }
    if header.encoding == Encoding::Ascii {
        let counts: Vec<String> = header.elements.iter().map(|e| format!("{} {}", e.count, e.name)).collect();
        rows::no_more_rows(source, &counts.join(" and "))?;
        out.warnings.extend(source.open_end());
        return Ok(());
    }
    let extra = source.drain()?;
    rows::note_extra(extra, header.row_bytes(), "element", out);
    Ok(())
}
