//! NPZ: a ZIP archive of any arrays, whose entries may state other sizes and places than they have.

use super::{Number, or};
use crate::with_entry_checksums;
use arbitrary::Arbitrary;
use flate2::{Compression, write::DeflateEncoder};
use std::io::Write;

#[derive(Arbitrary, Debug)]
struct Entry {
    name: u8,
    descr: u8,
    fortran: bool,
    shape: Vec<Number>,
    data: Vec<u8>,
    packed: bool,
    /// Other numbers in the directory: bytes packed, unpacked, and where the entry begins.
    stated: [Option<Number>; 3],
}

/// The parts of a file.
#[derive(Arbitrary, Debug)]
pub struct Npz {
    entries: Vec<Entry>,
    count: Option<Number>,
}

const NAMES: [&str; 8] = ["x", "y", "z", "points", "xyz", "positions", "a", "intensity"];
const DESCRIPTIONS: [&str; 9] = ["<f8", "<f4", "<f2", ">f8", "|u1", "<i4", "<u8", "|b1", "|O"];

impl Npz {
    /// The file.
    pub fn bytes(&self) -> Vec<u8> {
        let (mut bytes, mut directory) = (Vec::new(), Vec::new());
        for entry in &self.entries {
            let at = bytes.len();
            let array = entry.array();
            let body = if entry.packed { deflated(&array) } else { array.clone() };
            let name = format!("{}.npy", NAMES[usize::from(entry.name) % NAMES.len()]);
            let word = |given: usize, right: usize| (or(entry.stated[given], right) as u32).to_le_bytes();
            let method = if entry.packed { 8u16 } else { 0 }.to_le_bytes();
            let length = (name.len() as u16).to_le_bytes();
            let shared = [
                &[20, 0, 0, 0],
                method.as_slice(),
                &[0; 8],
                &word(0, body.len()),
                &word(1, array.len()),
                &length,
            ];
            bytes.extend(
                [b"PK\x03\x04".as_slice(), &shared.concat(), &[0, 0], name.as_bytes(), &body].concat(),
            );
            let place = word(2, at);
            directory.extend(
                [b"PK\x01\x02\x14\0".as_slice(), &shared.concat(), &[0; 12], &place, name.as_bytes()]
                    .concat(),
            );
        }
        let place = (bytes.len() as u32).to_le_bytes();
        let count = (or(self.count, self.entries.len()) as u16).to_le_bytes();
        let length = (directory.len() as u32).to_le_bytes();
        bytes.extend(directory);
        bytes.extend([b"PK\x05\x06\0\0\0\0".as_slice(), &count, &count, &length, &place, &[0, 0]].concat());
        with_entry_checksums(&bytes)
    }
}

impl Entry {
    fn array(&self) -> Vec<u8> {
        let shape: Vec<String> = self.shape.iter().map(|n| n.0.to_string()).collect();
        let shape = shape.join(", ") + if shape.len() == 1 { "," } else { "" };
        let fortran = if self.fortran { "True" } else { "False" };
        let descr = DESCRIPTIONS[usize::from(self.descr) % DESCRIPTIONS.len()];
        let mut header = format!("{{'descr': '{descr}', 'fortran_order': {fortran}, 'shape': ({shape}), }}");
        header += &" ".repeat((10 + header.len() + 1).next_multiple_of(64) - 10 - header.len() - 1);
        header.push('\n');
        let length = (header.len() as u16).to_le_bytes();
        [b"\x93NUMPY\x01\0".as_slice(), &length, header.as_bytes(), &self.data].concat()
    }
}

fn deflated(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::fast());
    let written = encoder.write_all(bytes).and_then(|()| encoder.finish());
    written.unwrap_or_default()
}
