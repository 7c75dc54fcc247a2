//! NPY, the array format of NumPy, version 1.0.

use super::table::PointTable;
use crate::columns::Number;
use std::io::{self, Write};

/// Numbers whose bytes are gathered before they go out.
const BLOCK: usize = 1 << 14;

/// Writes the classes, `(N)` u8, or the positions where there are none, `(N, 3)` f8.
pub(super) fn write(out: &mut dyn Write, table: &PointTable) -> io::Result<()> {
    let count = table.cloud.len();
    if table.classified() {
        out.write_all(&header("|u1", &format!("{count},")))?;
        return out.write_all(table.classes);
    }
    out.write_all(&header("<f8", &format!("{count}, 3")))?;
    blocks(out, table.cloud.positions.as_flattened())
}

/// The bytes of numbers, some at a time.
pub(in crate::write) fn blocks<T: Number>(out: &mut dyn Write, numbers: &[T]) -> io::Result<()> {
    let mut bytes = Vec::new();
    numbers.chunks(BLOCK).try_for_each(|block| {
        bytes.clear();
        block.iter().for_each(|number| number.put(&mut bytes));
        out.write_all(&bytes)
    })
}

/// The head of an array of this type and shape; its numbers follow.
pub(in crate::write) fn header(descr: &str, shape: &str) -> Vec<u8> {
    let mut text = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': ({shape}), }}");
    // Magic, version and length take 10 bytes; the data begin at a multiple of 64, after a line feed.
    let padding = (64 - (10 + text.len() + 1) % 64) % 64;
    text.push_str(&" ".repeat(padding));
    text.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((text.len() as u16).to_le_bytes());
    bytes.extend(text.as_bytes());
    bytes
}
