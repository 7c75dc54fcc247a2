//! The seeds of damaged inputs are whole themselves.

use crate::common::{from_bytes, seeds};
use lineament_io::ReadOptions;

/// With `LINEAMENT_SEEDS` naming a folder they are also written there, for `mutate` in `tools/`.
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

/// Formats whose memory does not follow from their bytes: the bound on it can be raised, and what goes beyond names it.
#[test]
fn an_error_of_the_bound_on_memory_names_the_option_that_raises_it() {
    let narrow = ReadOptions { memory: Some(16), ..ReadOptions::default() };
    let mut bounded = Vec::new();
    for (name, bytes) in seeds() {
        if let Err(error) = from_bytes(&bytes, &name, &narrow) {
            assert!(error.to_string().contains("--memory"), "{error}");
            let wide = ReadOptions { memory: Some(1 << 30), ..ReadOptions::default() };
            assert!(!from_bytes(&bytes, &name, &wide).unwrap().cloud.is_empty(), "{name}");
            bounded.push(name);
        }
    }
    for extension in ["npz", "parquet", "pcd", "laz", "glb", "e57"] {
        assert!(bounded.iter().any(|name| name.ends_with(extension)), "{extension}: {bounded:?}");
    }
}
