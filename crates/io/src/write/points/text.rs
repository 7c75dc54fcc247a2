//! Classified points as text: XYZ with blanks, CSV with commas; the first line names the columns.

use super::rows::{names, text};
use super::table::PointTable;
use std::io::{self, Write};

/// Writes a line for each point. Numbers are the shortest decimals that give the same value back. Names in XYZ stand behind
/// `//`, as CloudCompare writes them.
pub(super) fn write(out: &mut dyn Write, table: &PointTable, separator: char) -> io::Result<()> {
    let mut header = String::from(if separator == ' ' { "//x" } else { "x" });
    for name in ["y", "z"].into_iter().map(String::from).chain(names(table).into_iter().map(|(name, _)| name))
    {
        header.push(separator);
        header += &name;
    }
    writeln!(out, "{header}")?;
    for index in 0..table.cloud.len() {
        writeln!(out, "{}", text(table, index, separator))?;
    }
    Ok(())
}
