//! NPY, the array format of NumPy, version 1.0.

use std::io::{self, Write};

/// Writes `(N)` u8.
pub(super) fn write_classes(out: &mut dyn Write, classes: &[u8]) -> io::Result<()> {
    let mut header = format!("{{'descr': '|u1', 'fortran_order': False, 'shape': ({},), }}", classes.len());
    // Magic, version and length take 10 bytes; the data begin at a multiple of 64, after a line feed.
    let padding = (64 - (10 + header.len() + 1) % 64) % 64;
    header.push_str(&" ".repeat(padding));
    header.push('\n');
    out.write_all(b"\x93NUMPY\x01\x00")?;
    out.write_all(&(header.len() as u16).to_le_bytes())?;
    out.write_all(header.as_bytes())?;
    out.write_all(classes)
}
