//! The header of a PCD input.

use crate::columns::Scalar;
use crate::error::Error;
use crate::number::{self, integer, shown, tokens};
use crate::read::rows::Field;
use crate::read::{ReadOptions, limit};
use crate::source::Source;

/// How rows are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Data {
    Ascii,
    Binary,
    Compressed,
}

/// A parsed header; the source stands behind its last line.
#[derive(Debug)]
pub(super) struct Header {
    /// One entry a number of a row: a field of `COUNT` 3 is three of them.
    pub fields: Vec<NamedField>,
    pub points: u64,
    pub data: Data,
    viewpoint: Option<String>,
    version: bool,
}

/// A number of a row.
#[derive(Debug)]
pub(super) struct NamedField {
    pub name: String,
    pub place: Field,
}

/// Share of the bound on memory that a number of a row stands for: so many that they go beyond it are a damaged header
/// rather than a feature descriptor.
const FIELD: u64 = 1 << 10;

/// Times that a name may be in memory at once.
const NAMES: u64 = 4;

/// No sensible header has a longer line; binary data taken for a header has.
const MAX_LINE: usize = 1 << 20;

/// Lines of the header as they come.
#[derive(Default)]
struct Lines {
    names: Vec<String>,
    sizes: Vec<u64>,
    kinds: Vec<Vec<u8>>,
    counts: Vec<u64>,
    width: Option<u64>,
    height: Option<u64>,
    points: Option<u64>,
    viewpoint: Option<String>,
    version: bool,
}

impl Header {
    /// Bytes of a row.
    pub fn stride(&self) -> usize {
        self.fields.last().map_or(0, |last| last.place.offset + last.place.kind.size())
    }

    /// The fields x, y and z, by index.
    pub fn axes(&self, source: &Source) -> Result<[usize; 3], Error> {
        let mut axes = [0; 3];
        for (axis, name) in axes.iter_mut().zip(["x", "y", "z"]) {
            let found = self.fields.iter().position(|field| field.name.eq_ignore_ascii_case(name));
            *axis = found.ok_or_else(|| {
                let names: Vec<&str> = self.fields.iter().map(|field| field.name.as_str()).collect();
                let found = format!("the fields are {}", names.join(" "));
                source.malformed_line(found, format!("there is no field `{name}`: no points to read"))
            })?;
        }
        Ok(axes)
    }

    /// Index, name and type of every field that is no padding.
    pub fn columns(&self) -> impl Iterator<Item = (usize, &str, Scalar)> {
        let named = self.fields.iter().enumerate().filter(|(_, field)| !field.name.starts_with('_'));
        named.map(|(index, field)| (index, field.name.as_str(), field.place.kind))
    }

    /// Parts of the header that are not in the cloud.
    pub fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if let Some(viewpoint) = &self.viewpoint {
            notes.push(format!(
                "viewpoint {viewpoint}: coordinates are left in the frame that they are stored in"
            ));
        }
        if !self.version {
            notes.push("the header states no version".into());
        }
        notes
    }
}

/// Parses the header, and leaves the source behind its last line.
pub(super) fn parse(source: &mut Source, options: &ReadOptions) -> Result<Header, Error> {
    source.detect_terminator()?;
    let mut lines = Lines::default();
    loop {
        let Some(line) = source.line()? else {
            return Err(source.malformed_line("the header does not end", "the line `DATA` is missing"));
        };
        if line.len() > MAX_LINE {
            let found = format!("a header line of {} bytes", line.len());
            let advice =
                format!("no header line of more than {MAX_LINE} bytes is read: this is no PCD header");
            return Err(source.malformed_line(found, advice));
        }
        let line = line.to_vec();
        let words: Vec<&[u8]> = tokens(&line).collect();
        let Some((&key, values)) = words.split_first() else { continue };
        if key == b"DATA" {
            let data = match values {
                [b"ascii"] => Data::Ascii,
                [b"binary"] => Data::Binary,
                [b"binary_compressed"] => Data::Compressed,
                _ => {
                    let found = format!("line {}", shown(&line));
                    return Err(
                        source.malformed_line(found, "expected DATA ascii, binary or binary_compressed")
                    );
                }
            };
            return lines.finish(source, options, data);
        }
        if !key.starts_with(b"#") {
            lines.take(source, key, values)?;
        }
    }
}

impl Lines {
    fn take(&mut self, source: &Source, key: &[u8], values: &[&[u8]]) -> Result<(), Error> {
        match key {
            b"VERSION" => self.version = true,
            b"FIELDS" | b"COLUMNS" => {
                self.names = values.iter().map(|v| String::from_utf8_lossy(v).into_owned()).collect();
            }
            b"TYPE" => self.kinds = values.iter().map(|v| v.to_vec()).collect(),
            b"SIZE" => self.sizes = integers(source, key, values)?,
            b"COUNT" => self.counts = integers(source, key, values)?,
            b"WIDTH" => self.width = Some(one(source, key, values)?),
            b"HEIGHT" => self.height = Some(one(source, key, values)?),
            b"POINTS" => self.points = Some(one(source, key, values)?),
            b"VIEWPOINT" => {
                let identity =
                    ["0", "0", "0", "1", "0", "0", "0"].iter().map(|v| number::parse(v.as_bytes()));
                if !values.iter().map(|v| number::parse(v)).eq(identity) {
                    self.viewpoint = Some(values.iter().map(|v| String::from_utf8_lossy(v) + " ").collect());
                }
            }
            _ => {
                let found = format!("header line {}", shown(key));
                return Err(
                    source.malformed_line(found, "expected FIELDS, SIZE, TYPE, COUNT, WIDTH, ... DATA")
                );
            }
        }
        Ok(())
    }

    fn finish(self, source: &Source, options: &ReadOptions, data: Data) -> Result<Header, Error> {
        let fail = |found: String, advice: &str| Err(source.malformed_line(found, advice));
        let count = self.names.len();
        let counts = if self.counts.is_empty() { vec![1; count] } else { self.counts };
        if count == 0 || [self.sizes.len(), self.kinds.len(), counts.len()] != [count; 3] {
            let (sizes, kinds) = (self.sizes.len(), self.kinds.len());
            let found = format!("{count} FIELDS, {sizes} SIZE, {kinds} TYPE, {} COUNT", counts.len());
            return fail(found, "they must be equally many");
        }
        let numbers = counts.iter().fold(0u64, |sum, &count| sum.saturating_add(count));
        // Every number of a field has the name of the field.
        let named = |(name, &count): (&String, &u64)| count.saturating_mul(NAMES * name.len() as u64);
        let names = self.names.iter().zip(&counts).map(named).fold(0, u64::saturating_add);
        if numbers.saturating_mul(FIELD).saturating_add(names) > limit::bound(source, options) {
            let what = format!("a row of {numbers} numbers: COUNT {counts:?}");
            return Err(limit::beyond(source, options, 0, &what));
        }
        let mut fields = Vec::new();
        let mut offset = 0;
        for (((name, size), kind), count) in self.names.iter().zip(self.sizes).zip(self.kinds).zip(counts) {
            let Some(kind) = scalar(&kind, size) else {
                return fail(
                    format!("field `{name}` has type {} and size {size}", shown(&kind)),
                    "expected I or U with 1, 2, 4 or 8, or F with 4 or 8",
                );
            };
            for item in 0..count {
                let name = if count == 1 { name.clone() } else { format!("{name}_{item}") };
                fields.push(NamedField { name, place: Field { offset, kind } });
                offset += kind.size();
            }
        }
        let grid = self.width.map(|width| width.saturating_mul(self.height.unwrap_or(1)));
        let points = match (self.points, grid) {
            (Some(points), Some(grid)) if points != grid => {
                return fail(
                    format!("POINTS {points} where WIDTH times HEIGHT is {grid}"),
                    "they must agree",
                );
            }
            (Some(points), _) | (None, Some(points)) => points,
            (None, None) => {
                return fail("no line POINTS and no line WIDTH".into(), "the number of points is missing");
            }
        };
        Ok(Header { fields, points, data, viewpoint: self.viewpoint, version: self.version })
    }
}

fn integers(source: &Source, key: &[u8], values: &[&[u8]]) -> Result<Vec<u64>, Error> {
    values
        .iter()
        .map(|value| {
            integer(value).ok_or_else(|| {
                let found = format!("{} is {}", String::from_utf8_lossy(key), shown(value));
                source.malformed_line(found, "expected a whole number from 0 to 2^64 - 1")
            })
        })
        .collect()
}

fn one(source: &Source, key: &[u8], values: &[&[u8]]) -> Result<u64, Error> {
    match integers(source, key, values)?.as_slice() {
        [value] => Ok(*value),
        values => {
            let found = format!("{} has {} values", String::from_utf8_lossy(key), values.len());
            Err(source.malformed_line(found, "expected one"))
        }
    }
}

/// The number type of `TYPE` and `SIZE`.
fn scalar(kind: &[u8], size: u64) -> Option<Scalar> {
    Some(match (kind, size) {
        (b"I", 1) => Scalar::I8,
        (b"U", 1) => Scalar::U8,
        (b"I", 2) => Scalar::I16,
        (b"U", 2) => Scalar::U16,
        (b"I", 4) => Scalar::I32,
        (b"U", 4) => Scalar::U32,
        (b"I", 8) => Scalar::I64,
        (b"U", 8) => Scalar::U64,
        (b"F", 4) => Scalar::F32,
        (b"F", 8) => Scalar::F64,
        _ => return None,
    })
}
