//! NPY, the array format of NumPy, version 1.0.

use std::io::{self, Write};

/// Writes `(N)` u8.
pub(super) fn write_classes(out: &mut dyn Write, classes: &[u8]) -> io::Result<()> {
    out.write_all(&header("|u1", &format!("{},", classes.len())))?;
    out.write_all(classes)
}

/// The head of an array of this type and shape; its numbers follow.
pub(super) fn header(descr: &str, shape: &str) -> Vec<u8> {
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
