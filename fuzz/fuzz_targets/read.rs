//! Any bytes are points or an error: no panic, and columns of one length.
#![no_main]

use libfuzzer_sys::fuzz_target;
use lineament_io::{ReadOptions, read_from};
use std::io::Cursor;

fuzz_target!(|data: &[u8]| {
    for salvage in [false, true] {
        let options = ReadOptions { salvage, ..ReadOptions::default() };
        if let Ok(scan) = read_from(Box::new(Cursor::new(data.to_vec())), "fuzz", &options) {
            assert!(scan.cloud.attributes.iter().all(|a| a.values.len() == scan.cloud.len()));
            assert!(salvage || scan.missing.is_none());
        }
    }
});
