//! Classified points as binary PCD 0.7, with double coordinates.

use super::rows::{bytes, names};
use super::table::PointTable;
use crate::columns::Scalar;
use std::io::{self, Write};

/// Writes fields x, y and z of 8 bytes, class, score and the attributes of the input in their types.
pub(super) fn write(out: &mut dyn Write, table: &PointTable) -> io::Result<()> {
    let count = table.cloud.len();
    let names = names(table);
    let each = |first: &str, of: &dyn Fn(&(String, Scalar)) -> String| {
        names.iter().fold(format!("{first} {first} {first}"), |line, entry| line + " " + &of(entry))
    };
    let kind = |kind: Scalar| match kind {
        Scalar::F16 | Scalar::F32 | Scalar::F64 => "F",
        Scalar::I8 | Scalar::I16 | Scalar::I32 | Scalar::I64 => "I",
        _ => "U",
    };
    writeln!(out, "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7")?;
    writeln!(out, "FIELDS {}", each("", &|(name, _)| name.clone()).replacen("  ", "x y z", 1))?;
    writeln!(out, "SIZE {}", each("8", &|(_, scalar)| scalar.size().to_string()))?;
    writeln!(out, "TYPE {}", each("F", &|(_, scalar)| kind(*scalar).to_string()))?;
    writeln!(out, "COUNT {}", each("1", &|_| "1".to_string()))?;
    writeln!(out, "WIDTH {count}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {count}\nDATA binary")?;
    let mut row = Vec::new();
    for index in 0..count {
        row.clear();
        bytes(table, index, true, &mut row);
        out.write_all(&row)?;
    }
    Ok(())
}
