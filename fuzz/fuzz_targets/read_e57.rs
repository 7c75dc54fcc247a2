#![no_main]
use lineament_fuzz::{reads, with_checksums};

libfuzzer_sys::fuzz_target!(|data: &[u8]| reads(Some(lineament_io::Format::E57), &with_checksums(data)));
