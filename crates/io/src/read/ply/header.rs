//! The header of a PLY input.

use crate::columns::{Endian, Scalar};
use crate::error::Error;
use crate::number::{integer, shown, tokens};
use crate::read::{ReadOptions, limit};
use crate::source::Source;

/// How rows are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    Binary(Endian),
}

/// A parsed header; the source stands at the first row.
#[derive(Debug)]
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
}

/// A kind of row, and how many rows of it there are said to be.
#[derive(Debug)]
pub(super) struct Element {
    pub name: String,
    pub count: u64,
    pub properties: Vec<Property>,
}

/// One field of a row.
#[derive(Debug)]
pub(super) struct Property {
    pub name: String,
    pub kind: Kind,
}

/// The type of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Scalar(Scalar),
    /// A number of items, then the items.
    List {
        count: Scalar,
        item: Scalar,
    },
}

/// Bytes that a property may take in memory with its column, and times that its name may be there.
const PROPERTY: u64 = 1 << 9;
const NAMES: u64 = 4;

impl Header {
    /// The least bytes of a row of the last element.
    pub fn row_bytes(&self) -> u64 {
        self.elements.last().map_or(0, |element| element.least_bytes(self.encoding))
    }
}

impl Element {
    /// Whether the rows are the points.
    pub fn is_vertex(&self) -> bool {
        self.name == "vertex"
    }

    /// Whether its rows are strips of triangles.
    pub fn is_strips(&self) -> bool {
        self.name == "tristrips"
    }

    /// Of the faces, or of strips of triangles, the list of their vertices, by index.
    pub fn corners(&self) -> Option<usize> {
        let of = |p: &Property| {
            matches!(p.kind, Kind::List { item, .. } if item.is_integer())
                && matches!(p.name.as_str(), "vertex_indices" | "vertex_index")
        };
        (self.name == "face" || self.is_strips()).then(|| self.properties.iter().position(of)).flatten()
    }

    /// The properties x, y and z, by index.
    pub fn axes(&self, source: &Source) -> Result<[usize; 3], Error> {
        let mut axes = [0; 3];
        for (axis, name) in axes.iter_mut().zip(["x", "y", "z"]) {
            let mut found =
                self.properties.iter().enumerate().filter(|(_, p)| p.name.eq_ignore_ascii_case(name));
            let (first, second) = (found.next(), found.next());
            *axis = match (first, second) {
                (Some((index, Property { kind: Kind::Scalar(_), .. })), None) => index,
                (None, _) => return Err(no_axis(source, name, "is missing")),
                (Some((_, Property { kind: Kind::List { .. }, .. })), _) => {
                    return Err(no_axis(source, name, "is a list"));
                }
                (_, Some(_)) => return Err(no_axis(source, name, "stands there twice")),
            };
        }
        Ok(axes)
    }

    /// The least number of bytes that a row can take.
    pub fn least_bytes(&self, encoding: Encoding) -> u64 {
        let of = |property: &Property| match (encoding, property.kind) {
            (Encoding::Ascii, _) => 2,
            (_, Kind::Scalar(kind)) => kind.size() as u64,
            (_, Kind::List { count, .. }) => count.size() as u64,
        };
        self.properties.iter().map(of).sum()
    }
}

fn no_axis(source: &Source, name: &str, what: &str) -> Error {
    source.malformed_line(
        format!("property `{name}` of element `vertex` {what}"),
        "points need one number each for x, y and z",
    )
}

/// Parses the header, and leaves the source behind its last line.
pub(super) fn parse(source: &mut Source, options: &ReadOptions) -> Result<Header, Error> {
    source.detect_terminator()?;
    source.line()?;
    let (mut encoding, mut elements, mut properties) = (None, Vec::new(), 0);
    loop {
        let Some(line) = source.line()? else {
            return Err(source.malformed_line("the header does not end", "`end_header` is missing"));
        };
        if line.len() > MAX_LINE {
            let found = format!("a header line of {} bytes", line.len());
            return Err(source.malformed_line(found, "this is no PLY header"));
        }
        let line = line.to_vec();
        let words: Vec<&[u8]> = tokens(&line).collect();
        match words.as_slice() {
            [b"end_header", ..] => break,
            [] | [b"comment" | b"obj_info", ..] => {}
            [b"format", name, ..] => encoding = Some(parse_encoding(source, name)?),
            [b"element", name, count] => elements.push(parse_element(source, name, count)?),
            [b"property", rest @ ..] => {
                add_property(source, &mut elements, rest)?;
                properties += PROPERTY + NAMES * line.len() as u64;
                if properties > limit::bound(source, options) {
                    let what = "a header whose properties take more memory";
                    return Err(limit::beyond(source, options, source.offset(), what));
                }
            }
            _ => return Err(unknown(source, &line)),
        }
    }
    let Some(encoding) = encoding else {
        return Err(source.malformed_line("the header has no line `format`", "it must say ascii or binary"));
    };
    if !elements.iter().any(Element::is_vertex) {
        return Err(
            source.malformed_line("the header has no element `vertex`", "there are no points to read")
        );
    }
    if elements.iter().filter(|element| element.is_vertex()).count() > 1 {
        let found = "the header has more than one element `vertex`";
        return Err(source.malformed_line(found, "which of them are the points cannot be told: leave one"));
    }
    Ok(Header { encoding, elements })
}

/// No sensible header has a longer line; binary data taken for a header has.
const MAX_LINE: usize = 1 << 16;

fn unknown(source: &Source, line: &[u8]) -> Error {
    source.malformed_line(
        format!("header line {}", shown(line)),
        "expected `format`, `element NAME COUNT`, `property TYPE NAME`, `comment` or `end_header`",
    )
}

fn parse_encoding(source: &Source, name: &[u8]) -> Result<Encoding, Error> {
    match name {
        b"ascii" => Ok(Encoding::Ascii),
        b"binary_little_endian" => Ok(Encoding::Binary(Endian::Little)),
        b"binary_big_endian" => Ok(Encoding::Binary(Endian::Big)),
        _ => Err(source.malformed_line(
            format!("format {}", shown(name)),
            "expected ascii, binary_little_endian or binary_big_endian",
        )),
    }
}

fn parse_element(source: &Source, name: &[u8], count: &[u8]) -> Result<Element, Error> {
    let name = String::from_utf8_lossy(name).into_owned();
    let Some(count) = integer(count) else {
        let found = format!("element `{name}` has count {}", shown(count));
        return Err(source.malformed_line(found, "expected a whole number from 0 to 2^64 - 1"));
    };
    Ok(Element { name, count, properties: Vec::new() })
}

fn add_property(source: &Source, elements: &mut [Element], words: &[&[u8]]) -> Result<(), Error> {
    let Some(element) = elements.last_mut() else {
        return Err(
            source.malformed_line("a property before any element", "expected `element NAME COUNT` first")
        );
    };
    let of = |name: &[u8]| {
        let advice = "expected char, uchar, short, ushort, int, uint, float, double or int8 to float64";
        scalar(name).ok_or_else(|| source.malformed_line(format!("type {}", shown(name)), advice))
    };
    let (name, kind) = match words {
        [b"list", count, item, name] => {
            let (count_type, item) = (of(count)?, of(item)?);
            if !count_type.is_integer() {
                let found = format!("list count type {}", shown(count));
                return Err(source.malformed_line(found, "the length of a list must be an integer"));
            }
            (name, Kind::List { count: count_type, item })
        }
        [kind, name] => (name, Kind::Scalar(of(kind)?)),
        _ => {
            let found = format!("property line with {} words", words.len());
            return Err(source
                .malformed_line(found, "expected `property TYPE NAME` or `property list COUNT ITEM NAME`"));
        }
    };
    let name = String::from_utf8_lossy(name).into_owned();
    element.properties.push(Property { name, kind });
    Ok(())
}

/// Number types by their names in headers.
fn scalar(name: &[u8]) -> Option<Scalar> {
    Some(match name {
        b"char" | b"int8" => Scalar::I8,
        b"uchar" | b"uint8" => Scalar::U8,
        b"short" | b"int16" => Scalar::I16,
        b"ushort" | b"uint16" => Scalar::U16,
        b"int" | b"int32" => Scalar::I32,
        b"uint" | b"uint32" => Scalar::U32,
        b"int64" => Scalar::I64,
        b"uint64" => Scalar::U64,
        b"float" | b"float32" => Scalar::F32,
        b"double" | b"float64" => Scalar::F64,
        _ => return None,
    })
}
