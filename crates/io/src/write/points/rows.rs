//! The columns of classified points, one value at a time, for the formats that hold rows.

use super::table::PointTable;
use crate::columns::{Number, Scalar, each_column, get};
use lineament::Column;
use std::collections::BTreeMap;

/// Names of coordinates, class and score in every format.
const TAKEN: [&str; 5] = ["x", "y", "z", "class", "score"];

/// Names of all columns after x, y and z, with their types: class and score where there are such, then the attributes of the
/// input, renamed where the name is taken.
pub(in crate::write) fn names(table: &PointTable) -> Vec<(String, Scalar)> {
    // Without classes the columns of a classified input keep their names.
    let taken = if table.classified() { &TAKEN[..] } else { &TAKEN[..3] };
    let mut used: BTreeMap<String, usize> = taken.iter().map(|name| (name.to_string(), 1)).collect();
    let mut names = Vec::new();
    if table.classified() {
        names.push(("class".to_string(), Scalar::U8));
    }
    if !table.scores.is_empty() {
        names.push(("score".into(), Scalar::F32));
    }
    for attribute in &table.cloud.attributes {
        names.push((unique(&attribute.name, &mut used), Scalar::of(&attribute.values)));
    }
    names
}

/// A name of printable signs without commas that is not yet used, whatever the case of its letters: with `input_` before it, and
/// a number behind it where that is used too. `used` counts how often a name was asked for.
fn unique(name: &str, used: &mut BTreeMap<String, usize>) -> String {
    let plain = |c: char| if c.is_ascii_graphic() && c != ',' && c != '"' { c } else { '_' };
    let clean: String = name.chars().map(plain).collect();
    let clean = if clean.is_empty() { "unnamed".into() } else { clean };
    let mut found = clean.clone();
    while used.contains_key(&found.to_ascii_lowercase()) {
        let times = used.entry(clean.to_ascii_lowercase()).or_insert(1);
        *times += 1;
        found = if *times == 2 { format!("input_{clean}") } else { format!("input_{clean}_{}", *times - 1) };
    }
    used.insert(found.to_ascii_lowercase(), 1);
    found
}

/// Appends the bytes of value `index` of a column; of 64-bit integers, as double if `wide` is not there.
pub(super) fn put(column: &Column, index: usize, wide: bool, row: &mut Vec<u8>) {
    match column {
        Column::I64(_) | Column::U64(_) if !wide => get(column, index).put(row),
        _ => each_column!(column, values => if let Some(value) = values.get(index) { value.put(row) }),
    }
}

/// The bytes of a whole row: x, y and z as double, class, score, attributes.
pub(in crate::write) fn bytes(table: &PointTable, index: usize, wide: bool, row: &mut Vec<u8>) {
    table.cloud.positions[index].iter().for_each(|c| c.put(row));
    row.extend(table.classes.get(index));
    if let Some(score) = table.scores.get(index) {
        score.put(row);
    }
    table.cloud.attributes.iter().for_each(|attribute| put(&attribute.values, index, wide, row));
}

/// The values of a whole row as text.
pub(super) fn text(table: &PointTable, index: usize, separator: char) -> String {
    let [x, y, z] = table.cloud.positions[index];
    let mut line = format!("{x:?}{separator}{y:?}{separator}{z:?}");
    if let Some(class) = table.classes.get(index) {
        line += &format!("{separator}{class}");
    }
    if let Some(score) = table.scores.get(index) {
        line += &format!("{separator}{score:?}");
    }
    for attribute in &table.cloud.attributes {
        line.push(separator);
        line += &each_column!(&attribute.values, values => values.get(index).map_or("nan".into(), |v| format!("{v:?}")));
    }
    line
}
