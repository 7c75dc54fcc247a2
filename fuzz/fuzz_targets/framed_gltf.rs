#![no_main]

libfuzzer_sys::fuzz_target!(|parts: lineament_fuzz::Gltf| lineament_fuzz::reads(
    Some(lineament_io::Format::Gltf),
    &parts.bytes()
));
