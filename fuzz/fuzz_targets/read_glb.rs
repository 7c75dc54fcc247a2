#![no_main]
libfuzzer_sys::fuzz_target!(|data: &[u8]| lineament_fuzz::reads(Some(lineament_io::Format::Gltf), data));
