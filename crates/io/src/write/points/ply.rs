//! Classified points as PLY, with the attributes of the input.

use super::rows::{bytes, names};
use super::table::PointTable;
use crate::columns::Scalar;
use crate::write::encode::ply;
use std::io::{self, Write};

/// Writes x, y and z as double, `class` as uchar, `score` as float if there are scores, and every attribute of the
/// input in its type; 64-bit integers, which PLY does not have, as double.
pub(super) fn write(out: &mut dyn Write, table: &PointTable) -> io::Result<()> {
    let names = names(table);
    let more = columns(&names);
    let comments = ["class: 0 smooth, 1 crease, 2 border, 3 corner, 4 clutter"];
    let comments = if table.classified() { &comments[..] } else { &[] };
    ply::header(out, comments, &[ply::vertices(table.cloud.len(), &more)])?;
    rows(out, table)
}

/// Type and name of each property after x, y and z.
pub(in crate::write) fn columns(names: &[(String, Scalar)]) -> Vec<(&str, &str)> {
    names.iter().map(|(name, kind)| (type_name(*kind), name.as_str())).collect()
}

/// The vertices.
pub(in crate::write) fn rows(out: &mut dyn Write, table: &PointTable) -> io::Result<()> {
    let mut row = Vec::with_capacity(64);
    for index in 0..table.cloud.len() {
        row.clear();
        bytes(table, index, false, &mut row);
        out.write_all(&row)?;
    }
    Ok(())
}

fn type_name(kind: Scalar) -> &'static str {
    match kind {
        Scalar::I8 => "char",
        Scalar::U8 => "uchar",
        Scalar::I16 => "short",
        Scalar::U16 => "ushort",
        Scalar::I32 => "int",
        Scalar::U32 => "uint",
        Scalar::F16 | Scalar::F32 => "float",
        Scalar::F64 | Scalar::I64 | Scalar::U64 => "double",
    }
}
