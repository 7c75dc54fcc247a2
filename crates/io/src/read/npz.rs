//! NPZ, NumPy's archives of arrays: the points are an array of (N, 3) or more numbers, a structured array with x, y and
//! z, or three arrays called x, y and z. Every other array with a row for each point becomes attributes.

use super::npy::{self, Header};
use super::rows::Field;
use super::zip::{self, Entry};
use super::{Decoded, ReadOptions, limit};
use crate::columns::{Scalar, get};
use crate::error::{Error, Place};
use crate::source::{Shared, Source};
use lineament::{Attribute, Cloud, Column};

/// Share of the bound on memory that an array stands for: its stream is opened with buffers of its own.
const ARRAY: u64 = 1 << 14;
/// Bytes in memory for a field of an array, and bytes of an array that are looked at for its header.
const FIELD: u64 = 96;
const HEADER: usize = 1 << 12;
/// Names that arrays of points have by custom; the only array with three columns is taken under any name.
const POINTS: [&str; 8] = ["points", "xyz", "positions", "pos", "coords", "coordinates", "vertices", "pc"];

/// An array: its name, its place, and its header.
struct Array {
    name: String,
    entry: Entry,
    header: Header,
    /// Bytes before its numbers.
    begins: u64,
}

/// The places of the coordinates: three columns of arrays, by array and column.
type Axes = [(usize, usize); 3];

/// Reads an NPZ input.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    let archive = source.seekable()?;
    let archive = Shared::new(archive).map_err(|e| source.io(e))?;
    let mut out = Decoded::default();
    let arrays = headers(source, options, &archive, &mut out)?;
    let axes = axes(source, &arrays)?;
    let rows = arrays[axes[0].0].header.rows;
    let (kept, other): (Vec<_>, Vec<_>) = arrays.into_iter().enumerate().partition(|(index, array)| {
        let is_point = axes.iter().any(|axis| axis.0 == *index);
        is_point || options.attributes && array.header.rows == rows
    });
    out.ignored.extend(other.iter().map(|(_, a)| format!("array `{}` of {} rows", a.name, a.header.rows)));
    let held = |field: &Field| Scalar::of(&field.kind.column(0)).size();
    let row_bytes = kept.iter().flat_map(|(_, a)| &a.header.fields).map(held).sum::<usize>() + 24;
    limit::check(source, options, rows, row_bytes)?;
    let mut columns = Vec::new();
    for (index, array) in kept {
        let Some(read) = content(source, &archive, &array)? else {
            out.cut(source, options, &format!("rows of array `{}`", array.name), rows, 0)?;
            return Ok(out);
        };
        columns.push((index, array, read));
    }
    out.cloud = assemble(axes, rows as usize, columns, options.attributes);
    Ok(out)
}

/// The headers of all arrays of numbers; other entries are noted.
fn headers(
    source: &Source,
    options: &ReadOptions,
    archive: &Shared,
    out: &mut Decoded,
) -> Result<Vec<Array>, Error> {
    let entries = zip::entries(source, archive)?;
    if entries.len() as u64 * ARRAY > limit::bound(source, options) {
        return Err(limit::beyond(source, options, 0, &format!("an archive of {} entries", entries.len())));
    }
    zip::apart(source, archive, &entries)?;
    let (mut arrays, mut held) = (Vec::new(), 0);
    for entry in entries {
        let Some(name) = entry.name.strip_suffix(".npy").map(String::from) else {
            out.ignored.push(format!("entry `{}`: no array", entry.name));
            continue;
        };
        let mut stream = zip::open(source, archive, &entry)?.in_steps(HEADER);
        match npy::parse(&npy::text(&mut stream)?) {
            Ok(header) if header.stride > 0 => {
                held += header.described() as u64 * FIELD;
                if held > limit::bound(source, options) {
                    return Err(limit::beyond(
                        source,
                        options,
                        0,
                        "an archive of arrays whose fields take more",
                    ));
                }
                let begins = stream.offset();
                arrays.push(Array { name, entry, header, begins });
            }
            Ok(_) => out.ignored.push(format!("array `{name}`: no fields")),
            Err(what) => out.ignored.push(format!("array `{name}`: {what}")),
        }
    }
    Ok(arrays)
}

/// Finds the coordinates.
fn axes(source: &Source, arrays: &[Array]) -> Result<Axes, Error> {
    let wide = |array: &Array| array.header.names.is_empty() && array.header.fields.len() >= 3;
    let structured = |array: &Array| {
        let find = |axis: &str| array.header.names.iter().position(|n| n.eq_ignore_ascii_case(axis));
        Some([find("x")?, find("y")?, find("z")?])
    };
    let named = |name: &str| arrays.iter().position(|a| a.name.eq_ignore_ascii_case(name));
    if let Some(index) = POINTS.iter().find_map(|name| named(name).filter(|&i| wide(&arrays[i]))) {
        return plain(source, arrays, index);
    }
    if let [Some(x), Some(y), Some(z)] = ["x", "y", "z"].map(named) {
        let rows = arrays[x].header.rows;
        if [x, y, z].iter().all(|&i| arrays[i].header.fields.len() == 1 && arrays[i].header.rows == rows) {
            return Ok([(x, 0), (y, 0), (z, 0)]);
        }
    }
    if let Some((index, fields)) = arrays.iter().enumerate().find_map(|(i, a)| Some((i, structured(a)?))) {
        return Ok(fields.map(|field| (index, field)));
    }
    let all: Vec<usize> = (0..arrays.len()).filter(|&i| wide(&arrays[i])).collect();
    match all.as_slice() {
        &[index] => plain(source, arrays, index),
        _ if arrays.is_empty() => Err(source.fault(
            Place::Byte(0),
            "a ZIP archive without NumPy arrays",
            "unpack it, and give the scan in it",
        )),
        several => {
            let names: Vec<&str> = arrays.iter().map(|a| a.name.as_str()).collect();
            let found = format!("arrays {}, {} of them (N, 3) or wider", names.join(", "), several.len());
            let advice = "call the one with the points `points`, or have arrays x, y and z";
            Err(source.fault(Place::Byte(0), found, advice))
        }
    }
}

/// The first three columns of a plain array.
fn plain(source: &Source, arrays: &[Array], index: usize) -> Result<Axes, Error> {
    let Array { name, header, .. } = &arrays[index];
    let refused =
        |what| source.fault(Place::Byte(0), format!("array `{name}`: {what}"), "points need a row each");
    header.upright().map_err(refused)?;
    Ok([0, 1, 2].map(|column| (index, column)))
}

/// The columns of an array; `None` if it ends early.
fn content(source: &Source, archive: &Shared, array: &Array) -> Result<Option<Vec<Column>>, Error> {
    let needed = array.header.rows.saturating_mul(array.header.stride as u64).saturating_add(array.begins);
    if needed > array.entry.bytes {
        return Ok(None);
    }
    if needed < array.entry.bytes {
        let found = format!("array `{}` of {needed} bytes in an entry of {}", array.name, array.entry.bytes);
        return Err(source.fault(
            Place::Byte(0),
            found,
            "the header of the array and its bytes do not agree",
        ));
    }
    let mut stream = zip::open(source, archive, &array.entry)?;
    npy::text(&mut stream)?;
    let columns = npy::arrays(&mut stream, &array.header)?;
    stream.drain()?;
    Ok(columns)
}

/// The cloud: coordinates, and all other columns under names of their own.
fn assemble(axes: Axes, rows: usize, arrays: Vec<(usize, Array, Vec<Column>)>, attributes: bool) -> Cloud {
    let mut positions = vec![[0.0; 3]; rows];
    let mut named = Vec::new();
    for (index, array, columns) in arrays {
        let several = columns.len() > 1;
        for (number, column) in columns.into_iter().enumerate() {
            if let Some(axis) = axes.iter().position(|&a| a == (index, number)) {
                positions.iter_mut().enumerate().for_each(|(row, p)| p[axis] = get(&column, row));
            } else if attributes {
                let name = match array.header.names.get(number) {
                    Some(field) => field.clone(),
                    None if several => format!("{}_{number}", array.name),
                    None => array.name.clone(),
                };
                named.push(Attribute { name, values: column });
            }
        }
    }
    Cloud { positions, attributes: named }
}
