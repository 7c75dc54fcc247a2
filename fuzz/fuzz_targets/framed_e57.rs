#![no_main]

libfuzzer_sys::fuzz_target!(|parts: lineament_fuzz::E57| lineament_fuzz::reads(
    Some(lineament_io::Format::E57),
    &parts.bytes()
));
