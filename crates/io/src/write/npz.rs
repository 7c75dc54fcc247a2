//! Classified points as NPZ: `xyz` of (N, 3) f8, `class`, `score`, and an array for every attribute of the input.

use super::PointTable;
use super::npy;
use super::point_rows::names;
use crate::columns::{Number, Scalar, each_column};
use crate::zip::ZipWriter;
use std::io::{self, Write};

/// Writes an archive of arrays that are stored as they are, so that NumPy can map them.
pub(super) fn write(out: &mut dyn Write, table: &PointTable) -> io::Result<()> {
    let count = table.cloud.len();
    let mut archive = ZipWriter::new(out);
    let mut bytes = npy::header("<f8", &format!("{count}, 3"));
    table.cloud.positions.iter().flatten().for_each(|c| c.put(&mut bytes));
    archive.add("xyz.npy", &bytes)?;
    let names = names(table);
    let own = names.len() - table.cloud.attributes.len();
    for (index, (name, kind)) in names.iter().enumerate() {
        let mut bytes = npy::header(descr(*kind), &format!("{count},"));
        match index.checked_sub(own) {
            None if index == 0 => bytes.extend(table.classes),
            None => table.scores.iter().for_each(|score| score.put(&mut bytes)),
            Some(attribute) => each_column!(&table.cloud.attributes[attribute].values, values => {
                values.iter().for_each(|value| value.put(&mut bytes));
            }),
        }
        archive.add(&format!("{}.npy", name.replace('/', "_")), &bytes)?;
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
        Scalar::F32 => "<f4",
        Scalar::F64 => "<f8",
    }
}
