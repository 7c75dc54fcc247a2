//! The point sets of the Expe library (`.pts`, binary): a text header of properties with their sizes, then rows of
//! little endian floats. Colours of four bytes are red, green, blue and alpha.

use super::rows::{Field, Table, room};
use super::{Decoded, ReadOptions};
use crate::columns::{Endian, Scalar};
use crate::error::Error;
use crate::number::{integer, shown, tokens};
use crate::source::Source;

/// The first line of the binary variant.
pub(crate) const MAGIC: &[u8] = b"[Expe/PointSet/Binary/";

/// Reads an Expe point set.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    source.line()?;
    let (mut fields, mut names, mut count) = (Vec::new(), Vec::new(), None);
    let mut stride = 0;
    loop {
        let Some(line) = source.line()? else {
            return Err(source.malformed_line("the header does not end", "the line `data` is missing"));
        };
        let line = line[..line.len().min(1024)].to_vec();
        match tokens(&line).collect::<Vec<_>>().as_slice() {
            [b"data"] => break,
            [b"nofpoints", number] => count = integer(number),
            [b"property", name, size] => {
                let name = String::from_utf8_lossy(name).into_owned();
                let size = integer(size).filter(|size| (1..=256).contains(size) && stride < 4096);
                let Some(size) = size.map(|size| size as usize) else {
                    return Err(source.malformed_line(shown(&line), "expected a size from 1 to 256 bytes"));
                };
                add(&name, stride, size, &mut fields, &mut names);
                stride += size;
            }
            _ => {
                return Err(source
                    .malformed_line(shown(&line), "expected `property NAME SIZE`, `nofpoints N` or `data`"));
            }
        }
    }
    let axes =
        ["position_0", "position_1", "position_2"].map(|axis| names.iter().position(|name| name == axis));
    let ([Some(x), Some(y), Some(z)], Some(count)) = (axes, count) else {
        return Err(source
            .malformed_line("no `position` of 12 bytes or no `nofpoints`", "there are no points to read"));
    };
    let kept =
        fields.iter().zip(&names).enumerate().filter(|(i, _)| options.attributes && ![x, y, z].contains(i));
    let attributes =
        kept.map(|(i, (field, name)): (_, (&Field, &String))| (i, name.clone(), field.kind)).collect();
    let mut table = Table::new([x, y, z], attributes, room(source, count, stride as u64));
    let rows = table.read(source, count, stride, &fields, Endian::Little)?;
    let mut out = Decoded { cloud: table.into_cloud(), ..Decoded::default() };
    if rows < count {
        out.cut(source, options, "points", count, rows)?;
    }
    Ok(out)
}

/// Adds the numbers of a property: floats, or bytes of a colour.
fn add(name: &str, at: usize, size: usize, fields: &mut Vec<Field>, names: &mut Vec<String>) {
    let kind = if name == "color" || !size.is_multiple_of(4) { Scalar::U8 } else { Scalar::F32 };
    for (index, offset) in (at..at + size).step_by(kind.size()).enumerate() {
        fields.push(Field { offset, kind });
        names.push(match (name, size / kind.size()) {
            ("color", 4) => ["red", "green", "blue", "alpha"][index].into(),
            (_, 1) => name.into(),
            _ => format!("{name}_{index}"),
        });
    }
}
