#![no_main]

libfuzzer_sys::fuzz_target!(|parts: lineament_fuzz::Parquet| lineament_fuzz::reads(
    Some(lineament_io::Format::Parquet),
    &parts.bytes()
));
