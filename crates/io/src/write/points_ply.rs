//! Classified points as binary PLY, with the attributes of the input.

use super::PointTable;
use super::point_rows::{bytes, names};
use crate::columns::Scalar;
use std::io::{self, Write};

/// Writes x, y and z as double, `class` as uchar, `score` as float if there are scores, and every attribute of the
/// input in its type; 64-bit integers, which PLY does not have, as double.
pub(super) fn write(out: &mut dyn Write, table: &PointTable) -> io::Result<()> {
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\ncomment class: 0 smooth, 1 crease, 2 border, 3 corner\n\
         element vertex {}\nproperty double x\nproperty double y\nproperty double z\n",
        table.cloud.len()
    )?;
    for (name, kind) in names(table) {
        writeln!(out, "property {} {name}", type_name(kind))?;
    }
    writeln!(out, "end_header")?;
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
