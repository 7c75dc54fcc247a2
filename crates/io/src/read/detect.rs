//! Recognising the format of an input: by its content first, by its name second.

use super::{expe, foreign, gltf, npy, off, parquet, ptx, raster, stl};
use crate::error::Error;
use crate::format::Format;
use crate::number::{parse, shown, tokens};
use std::path::Path;

/// First bytes of formats that have them.
const MAGIC: [(Format, &[u8]); 8] = [
    (Format::Las, b"LASF"),
    (Format::E57, b"ASTM-E57"),
    (Format::Npy, npy::MAGIC),
    (Format::Npz, b"PK\x03\x04"),
    (Format::Parquet, parquet::MAGIC),
    (Format::Expe, expe::MAGIC),
    (Format::Pcd, b"# .PCD"),
    (Format::Gltf, gltf::MAGIC),
];

/// The byte order mark of UTF-8, which some editors put before text.
const MARK: &[u8] = b"\xef\xbb\xbf";

const OBJ_KEYWORDS: [&[u8]; 14] =
    [b"v", b"vn", b"vt", b"vp", b"f", b"l", b"p", b"o", b"g", b"s", b"mtllib", b"usemtl", b"cstype", b"deg"];

/// The format of an input that begins with `start` (several kilobytes, or all of it), has `length` bytes if that is
/// known, and is called `name`.
pub(super) fn detect(start: &[u8], length: Option<u64>, name: &str) -> Result<Format, Error> {
    if start.is_empty() {
        return Err(Error::Empty { name: name.into() });
    }
    let named = Path::new(name).extension().and_then(|e| e.to_str()).and_then(Format::parse);
    let found = by_magic(start).or_else(|| stl(start, length, named)).or_else(|| by_text(start, named));
    found.ok_or_else(|| unknown(start, named, name))
}

/// What to say of an input that is read as a table though its name suggests another format.
pub(super) fn misnamed(name: &str, format: Format) -> Option<String> {
    let named = Path::new(name).extension().and_then(|e| e.to_str()).and_then(Format::parse)?;
    let other = format == Format::Table && named != Format::Table;
    other.then(|| format!("the name suggests {named}; the content is a table of numbers, and read as one"))
}

fn unknown(start: &[u8], named: Option<Format>, name: &str) -> Error {
    let names: Vec<String> = Format::all().iter().map(Format::to_string).collect();
    let known = format!("known formats are {}; --input-format says which it is", names.join(", "));
    let advice = foreign::advice(start).map(String::from).unwrap_or_else(|| match named {
        Some(_) if start.strip_prefix(MARK).is_some_and(|text| by_magic(text).is_some()) => {
            "a byte order mark stands before the first word: save the file without it".into()
        }
        Some(format) => format!("the name suggests {format}, the content does not; {known}"),
        None => known,
    });
    Error::UnknownFormat { name: name.into(), found: shown(&start[..start.len().min(16)]), advice }
}

fn by_magic(start: &[u8]) -> Option<Format> {
    let word =
        |word: &[u8]| start.starts_with(word) && start.get(word.len()).is_none_or(u8::is_ascii_whitespace);
    if word(b"ply") {
        return Some(Format::Ply);
    }
    if [b"VERSION" as &[u8], b"FIELDS", b"COLUMNS"].into_iter().any(word) {
        return Some(Format::Pcd);
    }
    MAGIC.iter().find(|(_, magic)| start.starts_with(magic)).map(|(format, _)| *format)
}

/// STL has no magic: binary is recognised by its length, or by its name where the length does not fit.
fn stl(start: &[u8], length: Option<u64>, named: Option<Format>) -> Option<Format> {
    let cut = named == Some(Format::Stl) && start.contains(&0);
    (stl::is_binary(start, length) || stl::is_ascii(start) || cut).then_some(Format::Stl)
}

/// Text is recognised by its first statement, without one by its name, and is otherwise a table.
fn by_text(start: &[u8], named: Option<Format>) -> Option<Format> {
    let start = start.strip_prefix(MARK).unwrap_or(start);
    if start.contains(&0) {
        return None;
    }
    if ptx::begins(start) {
        return Some(Format::Ptx);
    }
    if start.trim_ascii_start().starts_with(b"{") {
        return (named == Some(Format::Gltf) || gltf::begins(start)).then_some(Format::Gltf);
    }
    let mut lines = start.split(|&b| b == b'\n' || b == b'\r');
    let statement = lines.find_map(|line| tokens(line).next().filter(|t| !t.starts_with(b"#")));
    match statement {
        Some(_) if foreign::advice(start).is_some() => None,
        Some(word) if OBJ_KEYWORDS.contains(&word) => Some(Format::Obj),
        Some(word) if off::is_keyword(word) => Some(Format::Off),
        Some(word) if raster::begins(word) => Some(Format::Raster),
        None if named == Some(Format::Obj) => Some(Format::Obj),
        Some(_) if named == Some(Format::Off) => Some(Format::Off),
        Some(_) if named.is_some_and(|format| format != Format::Table && format != Format::Obj) => {
            is_clean_table(start).then_some(Format::Table)
        }
        _ => Some(Format::Table),
    }
}

/// Whether all lines are rows of as many numbers, three at least, but for comments and a first line, which may name the columns.
fn is_clean_table(start: &[u8]) -> bool {
    let lines = start.split(|&b| b == b'\n' || b == b'\r').map(<[u8]>::trim_ascii);
    let mut lines: Vec<&[u8]> = lines.filter(|line| !line.is_empty() && !line.starts_with(b"#")).collect();
    if lines.len() > 3 && !start.ends_with(b"\n") {
        // It may go on behind what was looked at.
        lines.pop();
    }
    let numbers = |line: &&[u8]| {
        let fields = line.split(|b| b.is_ascii_whitespace() || b",;".contains(b));
        let mut values = fields.filter(|field| !field.is_empty()).map(parse);
        values.try_fold(0usize, |count, value| value.map(|_| count + 1))
    };
    let first = usize::from(lines.first().is_some_and(|line| numbers(line).is_none()));
    let rows = &lines[first.min(lines.len())..];
    let columns = rows.first().and_then(numbers).unwrap_or(0);
    columns >= 3 && rows.len() >= 2 && rows.iter().all(|row| numbers(row) == Some(columns))
}
