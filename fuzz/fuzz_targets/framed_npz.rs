#![no_main]

libfuzzer_sys::fuzz_target!(|parts: lineament_fuzz::Npz| lineament_fuzz::reads(
    Some(lineament_io::Format::Npz),
    &parts.bytes()
));
