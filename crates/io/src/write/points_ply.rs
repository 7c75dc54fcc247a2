//! Classified points as binary PLY, with the attributes of the input.

use super::PointTable;
use crate::columns::{Number, Scalar, each_column, get};
use lineament::{Attribute, Column};
use std::io::{self, Write};

/// Names that this file gives a meaning of its own.
const TAKEN: [&str; 5] = ["x", "y", "z", "class", "score"];

/// Writes x, y and z as double, `class` as uchar, `score` as float if there are scores, and every attribute of the
/// input in its type; 64-bit integers, which PLY does not have, as double.
pub(super) fn write(out: &mut dyn Write, table: &PointTable) -> io::Result<()> {
    let attributes = &table.cloud.attributes;
    header(out, table, attributes)?;
    let mut row = Vec::with_capacity(64);
    for (i, position) in table.cloud.positions.iter().enumerate() {
        row.clear();
        position.iter().for_each(|c| c.put(&mut row));
        row.extend(table.classes.get(i));
        if let Some(score) = table.scores.get(i) {
            score.put(&mut row);
        }
        for attribute in attributes {
            put(&attribute.values, i, &mut row);
        }
        out.write_all(&row)?;
    }
    Ok(())
}

fn header(out: &mut dyn Write, table: &PointTable, attributes: &[Attribute]) -> io::Result<()> {
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\ncomment class: 0 smooth, 1 crease, 2 border, 3 corner\n\
         element vertex {}\nproperty double x\nproperty double y\nproperty double z\nproperty uchar class\n",
        table.cloud.len()
    )?;
    if !table.scores.is_empty() {
        writeln!(out, "property float score")?;
    }
    let mut used: Vec<String> = TAKEN.map(String::from).into();
    for attribute in attributes {
        let name = unique(&attribute.name, &used);
        writeln!(out, "property {} {name}", type_name(Scalar::of(&attribute.values)))?;
        used.push(name);
    }
    writeln!(out, "end_header")
}

/// A property name without blanks that is not yet used.
fn unique(name: &str, used: &[String]) -> String {
    let clean: String = name.chars().map(|c| if c.is_ascii_graphic() { c } else { '_' }).collect();
    let mut unique = if clean.is_empty() { "unnamed".into() } else { clean };
    while used.iter().any(|u| u.eq_ignore_ascii_case(&unique)) {
        unique.insert_str(0, "input_");
    }
    unique
}

fn type_name(kind: Scalar) -> &'static str {
    match kind {
        Scalar::I8 => "char",
        Scalar::U8 => "uchar",
        Scalar::I16 => "short",
        Scalar::U16 => "ushort",
        Scalar::I32 => "int",
        Scalar::U32 => "uint",
        Scalar::F32 => "float",
        Scalar::F64 | Scalar::I64 | Scalar::U64 => "double",
    }
}

fn put(column: &Column, index: usize, row: &mut Vec<u8>) {
    match column {
        Column::I64(_) | Column::U64(_) => get(column, index).put(row),
        _ => each_column!(column, values => if let Some(value) = values.get(index) { value.put(row) }),
    }
}
