#![no_main]
use lineament_fuzz::{reads, with_entry_checksums};

libfuzzer_sys::fuzz_target!(|data: &[u8]| reads(
    Some(lineament_io::Format::Npz),
    &with_entry_checksums(data)
));
