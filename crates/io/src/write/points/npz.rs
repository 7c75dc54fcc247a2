//! Classified points as NPZ: `xyz` of (N, 3) f8, `class`, `score`, and an array for every attribute of the input.

use super::npy::{self, blocks};
use super::rows::names;
use super::table::PointTable;
use crate::columns::{Scalar, each_column};
use crate::write::encode::zip::ZipWriter;
use std::io::{self, Write};

/// Writes an archive of arrays that are stored as they are, so that NumPy can map them.
pub(super) fn write(out: &mut dyn Write, table: &PointTable) -> io::Result<()> {
    let count = table.cloud.len();
    let mut archive = ZipWriter::new(out);
    archive.add("xyz.npy", &|out| {
        out.write_all(&npy::header("<f8", &format!("{count}, 3")))?;
        blocks(out, table.cloud.positions.as_flattened())
    })?;
    let names = names(table);
    let own = names.len() - table.cloud.attributes.len();
    for (index, (name, kind)) in names.iter().enumerate() {
        archive.add(&format!("{}.npy", name.replace('/', "_")), &|out| {
            out.write_all(&npy::header(descr(*kind), &format!("{count},")))?;
            match index.checked_sub(own) {
                None if index == 0 && table.classified() => out.write_all(table.classes),
                None => blocks(out, table.scores),
                Some(attribute) => {
                    each_column!(&table.cloud.attributes[attribute].values, values => blocks(out, values))
                }
            }
        })?;
    }
    archive.finish()
}

/// NumPy's name of a type.
fn descr(kind: Scalar) -> &'static str {
    match kind {
        Scalar::I8 => "|i1",
        Scalar::U8 => "|u1",
        Scalar::I16 => "<i2",
        Scalar::U16 => "<u2",
        Scalar::I32 => "<i4",
        Scalar::U32 => "<u4",
        Scalar::I64 => "<i8",
        Scalar::U64 => "<u8",
        Scalar::F16 | Scalar::F32 => "<f4",
        Scalar::F64 => "<f8",
    }
}
