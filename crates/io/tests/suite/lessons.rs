//! The lessons in `examples/` run to their ends and write the files that they announce; their own asserts check the results.

use crate::common::example;
use std::process::Command;

fn runs(name: &str, files: &[&str]) {
    let program = example(name).expect("the lessons are not built: `cargo test -p lineament-io` builds them");
    let folder = tempfile::tempdir().unwrap();
    let run = Command::new(program).current_dir(folder.path()).output().unwrap();
    assert!(run.status.success(), "{name}: {}", String::from_utf8_lossy(&run.stderr));
    assert!(!run.stdout.is_empty() || name == "05_render", "{name} prints nothing");
    for file in files {
        assert!(std::fs::metadata(folder.path().join(file)).unwrap().len() > 100, "{name}: {file}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), files.len(), "{name}");
}

#[test]
fn lines_are_extracted() {
    runs("01_extract", &["bracket.obj", "bracket.json"]);
}

#[test]
fn points_are_classified() {
    runs("02_classify", &["cube.ply"]);
}

#[test]
fn patches_are_found() {
    runs("03_patches", &["flange.json"]);
}

#[test]
fn sections_are_cut() {
    runs("04_section", &["shaft.svg", "shaft.dxf"]);
}

#[test]
fn a_picture_is_drawn() {
    runs("05_render", &["bracket.png"]);
}

#[test]
fn a_detector_of_ones_own_feeds_the_linker() {
    runs("06_custom_pipeline", &["block.obj"]);
}
