//! NPY, the array format of NumPy, versions 1 to 3: `(N, 3)` and wider arrays in either order, and structured arrays
//! with fields x, y and z.

use super::rows::{Field, Table, room};
use super::{Decoded, ReadOptions};
use crate::columns::{Endian, Scalar, append_as};
use crate::error::Error;
use crate::source::Source;
use lineament::Column;

/// The first bytes of the format.
pub(crate) const MAGIC: &[u8] = b"\x93NUMPY";

/// Bytes of a header beyond which it is not read: NumPy itself stops at 10,000.
const MAX_HEADER: usize = 1 << 16;

/// The parsed header.
pub(super) struct Header {
    /// Names of the fields; of a plain array, none.
    pub names: Vec<String>,
    pub fields: Vec<Field>,
    pub stride: usize,
    endian: Endian,
    pub rows: u64,
    column_major: bool,
    /// Names of fields that are no numbers.
    left_out: Vec<String>,
}

/// Bytes of a row beyond which it is not read: rows are held one by one at least.
const MAX_ROW: usize = 1 << 20;
/// Columns of a plain array beyond which there must be more rows: else it is taken for one that lies on its side.
const WIDE: usize = 16;

impl Header {
    /// Fields and names that the header holds.
    pub fn described(&self) -> usize {
        self.fields.len() + self.names.len() + self.left_out.len()
    }

    /// Refuses a plain array with a row for each coordinate instead of a column.
    pub fn upright(&self) -> Result<(), String> {
        let columns = self.fields.len();
        if self.names.is_empty() && columns > WIDE && self.rows < columns as u64 {
            return Err(format!(
                "an array of shape [{}, {columns}], wider than long: transpose it",
                self.rows
            ));
        }
        Ok(())
    }

    /// Gives the columns of a plain array their usual names.
    fn named(mut self) -> Result<Self, String> {
        if self.names.is_empty() {
            if self.fields.len() < 3 {
                return Err(format!("an array of shape [{}, {}]", self.rows, self.fields.len()));
            }
            self.upright()?;
            let usual =
                |c: usize| ["x", "y", "z"].get(c).map_or(format!("column_{}", c + 1), |n| (*n).into());
            self.names = (0..self.fields.len()).map(usual).collect();
        }
        Ok(self)
    }
}

/// Reads an NPY input.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    let text = text(source)?;
    let header = parse(&text).and_then(Header::named).map_err(|found| {
        source.malformed(found, "expected an array of (N, 3) or more numbers, or of fields x, y, z")
    })?;
    let find = |name: &str| header.names.iter().position(|n| n.eq_ignore_ascii_case(name));
    let [Some(x), Some(y), Some(z)] = ["x", "y", "z"].map(find) else {
        return Err(
            source.malformed(format!("fields {}", header.names.join(", ")), "there must be x, y and z")
        );
    };
    let left_out = header.left_out.iter().map(|name| format!("field `{name}`: no number"));
    let ignored = left_out.collect();
    let kept = header.names.iter().enumerate().filter(|(i, _)| options.attributes && ![x, y, z].contains(i));
    let attributes = kept.map(|(i, name)| (i, name.clone(), header.fields[i].kind)).collect();
    let room = room(source, header.rows, header.stride as u64);
    let mut table = Table::new([x, y, z], attributes, room);
    let rows = if header.column_major {
        columns(source, &header, &mut table)?
    } else {
        table.read(source, header.rows, header.stride, &header.fields, header.endian)?
    };
    let mut out = Decoded { cloud: table.into_cloud(), ignored, ..Decoded::default() };
    if rows < header.rows {
        out.cut(source, options, "rows", header.rows, rows)?;
    }
    let extra = source.drain()?;
    if out.missing.is_none() {
        super::rows::note_extra(extra, header.stride as u64, "row", &mut out);
    }
    Ok(out)
}

/// The header's text; the source then stands at the first number.
pub(super) fn text(source: &mut Source) -> Result<String, Error> {
    let start: Vec<u8> = source.peek(12)?.iter().take(12).copied().collect();
    let version = start.get(6).copied().unwrap_or(0);
    let (length, before) = match (version, start.as_slice()) {
        (1, [_, _, _, _, _, _, _, _, a, b, ..]) => (usize::from(u16::from_le_bytes([*a, *b])), 10),
        (2 | 3, [_, _, _, _, _, _, _, _, a, b, c, d]) => (u32::from_le_bytes([*a, *b, *c, *d]) as usize, 12),
        _ => return Err(source.malformed(format!("version {version}"), "versions 1 to 3 are read")),
    };
    if length > MAX_HEADER {
        return Err(source
            .malformed(format!("a header of {length} bytes"), "no array needs that; the file is damaged"));
    }
    let here = source.peek(before + length)?;
    let Some(text) = here.get(before..before + length).map(|t| String::from_utf8_lossy(t).into_owned())
    else {
        let there = (here.len() - before.min(here.len())) as u64;
        return Err(source.ends_early("bytes of the header", length as u64, there));
    };
    source.consume(before + length);
    Ok(text)
}

/// The text after a key of the dictionary.
fn value<'a>(text: &'a str, key: &str) -> Option<&'a str> {
    let at = text.find(&format!("'{key}'")).or_else(|| text.find(&format!("\"{key}\"")))?;
    text[at + key.len() + 2..].trim_start().strip_prefix(':').map(str::trim_start)
}

/// The header of an array of one or two dimensions.
pub(super) fn parse(text: &str) -> Result<Header, String> {
    let missing = |key: &str| format!("a header without `{key}`: {}", crate::number::shown(text.as_bytes()));
    let descr = value(text, "descr").ok_or_else(|| missing("descr"))?;
    let order = value(text, "fortran_order").ok_or_else(|| missing("fortran_order"))?;
    let shape = shape(value(text, "shape").ok_or_else(|| missing("shape"))?)?;
    let column_major = order.starts_with("True");
    if descr.starts_with('[') {
        let Structure { names, fields, stride, endian, left_out } = structured(descr)?;
        let &[rows] = shape.as_slice() else { return Err(format!("a structured array of shape {shape:?}")) };
        return Ok(Header { names, fields, stride, endian, rows, column_major: false, left_out });
    }
    let (kind, endian) = scalar(quoted(descr).ok_or_else(|| format!("type {descr}"))?)?;
    let (rows, columns) = match *shape.as_slice() {
        [rows] => (rows, 1),
        [rows, columns @ 1..=4096] => (rows, columns as usize),
        _ => return Err(format!("an array of shape {shape:?}")),
    };
    let fields = (0..columns).map(|c| Field { offset: c * kind.size(), kind }).collect();
    let (names, left_out) = (Vec::new(), Vec::new());
    Ok(Header { names, fields, stride: columns * kind.size(), endian, rows, column_major, left_out })
}

/// A tuple of whole numbers.
fn shape(text: &str) -> Result<Vec<u64>, String> {
    let inner = text.strip_prefix('(').and_then(|t| t.split_once(')')).map(|(inner, _)| inner);
    let numbers = inner.map(|inner| inner.split(',').map(str::trim).filter(|n| !n.is_empty()));
    let parsed = numbers.and_then(|numbers| numbers.map(|n| n.trim_end_matches('L').parse().ok()).collect());
    parsed.ok_or_else(|| format!("shape {}", crate::number::shown(text.as_bytes())))
}

/// The text in the quotes that come first.
fn quoted(text: &str) -> Option<&str> {
    let quote = text.chars().next().filter(|c| matches!(c, '\'' | '"'))?;
    text[1..].split(quote).next()
}

/// A number type such as `<f4`.
fn scalar(descr: &str) -> Result<(Scalar, Endian), String> {
    let endian = if descr.starts_with('>') { Endian::Big } else { Endian::Little };
    let kind = match descr.trim_start_matches(['<', '>', '=', '|']) {
        "f2" => Scalar::F16,
        "f4" => Scalar::F32,
        "f8" => Scalar::F64,
        "i1" => Scalar::I8,
        "u1" | "b1" => Scalar::U8,
        "i2" => Scalar::I16,
        "u2" => Scalar::U16,
        "i4" => Scalar::I32,
        "u4" => Scalar::U32,
        "i8" => Scalar::I64,
        "u8" => Scalar::U64,
        _ => return Err(format!("type {}", crate::number::shown(descr.as_bytes()))),
    };
    Ok((kind, endian))
}

/// The fields of a structured type.
#[derive(Default)]
struct Structure {
    names: Vec<String>,
    fields: Vec<Field>,
    stride: usize,
    endian: Endian,
    left_out: Vec<String>,
}

/// Bytes of a field that is no number: padding, which has no name, bytes or text.
fn opaque(descr: &str) -> Option<usize> {
    let bare = descr.trim_start_matches(['<', '>', '=', '|']);
    let wide = match bare.get(..1)? {
        "V" | "S" | "a" => 1,
        "U" => 4,
        _ => return None,
    };
    bare[1..].parse::<u32>().ok().map(|count| wide * count as usize)
}

/// The fields of `[('x', '<f4'), ('y', '<f4'), ...]`, the numbers all of one byte order.
fn structured(text: &str) -> Result<Structure, String> {
    let list = text.strip_prefix('[').and_then(|t| t.split_once(']')).map(|(list, _)| list).unwrap_or("");
    let mut all = Structure::default();
    let mut order = None;
    for entry in list.split('(').skip(1) {
        let parts: Vec<&str> = entry.split(['\'', '"']).collect();
        let &[_, name, _, descr, rest] = parts.as_slice() else { return Err(format!("field ({entry}")) };
        if rest.trim().trim_end_matches(',').trim() != ")" {
            return Err(format!("field `{name}`, which is an array,"));
        }
        if let Some(bytes) = opaque(descr) {
            all.stride += bytes;
            all.left_out.extend((!name.is_empty()).then(|| name.to_string()));
            continue;
        }
        let (kind, endian) = scalar(descr)?;
        if kind.size() > 1 && *order.get_or_insert(endian) != endian {
            return Err("fields of both byte orders".into());
        }
        all.names.push(name.into());
        all.fields.push(Field { offset: all.stride, kind });
        all.stride += kind.size();
    }
    if all.stride > MAX_ROW {
        return Err(format!("rows of {} bytes", all.stride));
    }
    all.endian = order.unwrap_or_default();
    Ok(all)
}

/// All fields of an array as columns; `None` if it ends early.
pub(super) fn arrays(source: &mut Source, header: &Header) -> Result<Option<Vec<Column>>, Error> {
    let mut columns: Vec<Column> =
        header.fields.iter().map(|f| f.kind.column(header.rows as usize)).collect();
    let (stride, passes) = if header.column_major { (None, columns.len()) } else { (Some(header.stride), 1) };
    for pass in 0..passes {
        let stride = stride.unwrap_or(header.fields[pass].kind.size());
        let mut row = 0;
        while row < header.rows {
            let here = source.peek(stride.max(1 << 16))?;
            let some = ((here.len() / stride) as u64).min(header.rows - row) as usize;
            if some == 0 {
                return Ok(None);
            }
            let bytes = &here[..some * stride];
            if header.column_major {
                append_as(header.fields[pass].kind, &mut columns[pass], bytes, stride, 0, header.endian);
            } else {
                let filled = columns.iter_mut().zip(&header.fields);
                filled.for_each(|(column, f)| {
                    append_as(f.kind, column, bytes, stride, f.offset, header.endian)
                });
            }
            source.consume(some * stride);
            row += some as u64;
        }
    }
    Ok(Some(columns))
}

/// Reads columns one after the other. Gives how many rows are whole: all or none.
fn columns(source: &mut Source, header: &Header, table: &mut Table) -> Result<u64, Error> {
    let needed = header.rows.saturating_mul(header.stride as u64);
    if source.remaining().is_some_and(|here| here < needed) {
        return Ok(0);
    }
    for (index, field) in header.fields.iter().enumerate() {
        let (size, mut row) = (field.kind.size(), 0);
        while row < header.rows as usize {
            let here = source.peek(1 << 16)?;
            let some = (here.len() / size).min(header.rows as usize - row);
            if some == 0 {
                table.positions.clear();
                table.level();
                return Ok(0);
            }
            let bytes = &here[..some * size];
            if let Some(axis) = table.axes.iter().position(|&a| a == index) {
                table.positions.resize(table.positions.len().max(row + some), [0.0; 3]);
                field.kind.fill_axis(bytes, size, 0, header.endian, &mut table.positions[row..], axis);
            }
            if let Some((_, attribute)) = table.columns.iter_mut().find(|(field, _)| *field == index) {
                append_as(field.kind, &mut attribute.values, bytes, size, 0, header.endian);
            }
            source.consume(some * size);
            row += some;
        }
    }
    Ok(header.rows)
}
