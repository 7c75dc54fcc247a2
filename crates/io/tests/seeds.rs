//! The seeds of damaged inputs are whole themselves.

mod common;
use common::{from_bytes, seeds};
use lineament_io::ReadOptions;

/// With `LINEAMENT_SEEDS` naming a folder they are also written there, for `examples/mutate`.
#[test]
fn every_seed_reads_whole() {
    let folder = std::env::var_os("LINEAMENT_SEEDS").map(std::path::PathBuf::from);
    for (name, bytes) in seeds() {
        let scan =
            from_bytes(&bytes, &name, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        assert!(!scan.cloud.is_empty() && scan.missing.is_none(), "{name}");
        if let Some(folder) = &folder {
            std::fs::write(folder.join(name), bytes).unwrap();
        }
    }
}
