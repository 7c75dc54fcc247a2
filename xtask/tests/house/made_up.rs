//! The checks see what they are for, in small made-up trees.

use std::path::PathBuf;

use crate::circles::circles;
use crate::layers::{Order, orders, unlisted, upwards};
use crate::modules::Crate;
use crate::sizes;

/// A workspace whose crates have no sources but the given ones, in a folder of its own.
struct MadeUp(PathBuf);

impl MadeUp {
    fn new(name: &str, files: &[(&str, &str)]) -> MadeUp {
        let root = std::env::temp_dir().join(format!("lineament-house-{name}-{}", std::process::id()));
        for (_, folder) in crate::CRATES {
            std::fs::create_dir_all(root.join(folder).join("src")).unwrap();
        }
        for (path, text) in files {
            let path = root.join("crates/core/src").join(path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
        MadeUp(root)
    }

    fn sources(&self) -> Crate {
        Crate::read(&self.0.join("crates/core/src"))
    }
}

impl Drop for MadeUp {
    fn drop(&mut self) {
        // What cannot be removed stays in the folder for temporary files.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn order() -> Order {
    orders("# A\n\n## Order of modules\n\nText.\n\n- `core`: `low`,\n  `high`\n\n## B\n\n- `c`: `d`\n")
        .remove("core")
        .unwrap()
}

#[test]
fn the_order_is_read_from_its_section_alone() {
    assert_eq!(order(), ["low", "high"]);
}

#[test]
fn an_import_upwards_is_found_through_a_name_that_is_handed_on() {
    let lib = ("lib.rs", "mod high;\nmod low;\npub use high::High;\n");
    let high = ("high.rs", "pub struct High;\n");
    for (low, faults) in [
        ("// use crate::High;\n#[cfg(test)]\nmod tests { use crate::High; }\n", 0),
        ("use crate::High;\n", 1),
        ("use crate::{High as Other};\n", 1),
        ("use super::high::*;\n", 1),
        ("pub use super::high::High;\n", 1),
        ("fn f(_: crate::high::High) {}\n", 1),
    ] {
        let tree = MadeUp::new("upwards", &[lib, high, ("low.rs", low)]);
        let found = upwards(&tree.sources(), &order());
        assert_eq!(found.len(), faults, "{low}: {found:?}");
        assert!(found.iter().all(|f| f.contains("low.rs:")));
    }
}

#[test]
fn an_import_downwards_is_none() {
    let files = [
        ("lib.rs", "mod high;\nmod low;\n"),
        ("high.rs", "use crate::low::Low;\n"),
        ("low.rs", "pub struct Low;\n"),
    ];
    let tree = MadeUp::new("downwards", &files);
    assert!(upwards(&tree.sources(), &order()).is_empty());
    assert!(unlisted(&tree.sources(), &order()).is_empty());
    assert_eq!(unlisted(&tree.sources(), &vec!["low".into(), "gone".into()]).len(), 2);
}

#[test]
fn a_circle_between_files_is_found_and_a_facade_that_hands_names_on_is_none() {
    let facade = ("low.rs", "mod a;\nmod b;\npub use a::A;\npub use b::B;\n");
    let a = ("low/a.rs", "pub struct A;\n");
    let b = ("low/b.rs", "use super::A;\npub struct B;\n");
    let lib = ("lib.rs", "mod low;\n");
    let sound = MadeUp::new("facade", &[lib, facade, a, b]);
    assert_eq!(circles(&sound.sources()), [""; 0]);
    let back = ("low/a.rs", "use super::b::B;\npub struct A;\n");
    let circle = MadeUp::new("circle", &[lib, facade, back, b]);
    let found = circles(&circle.sources());
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with("2 files in a circle"), "{found:?}");
    let child = ("low/a.rs", "use super::Shared;\npub struct A;\n");
    for (parent, circle) in [("", 0), ("fn f(_: A) {}\n", 1)] {
        let parent = format!("mod a;\npub use a::A;\npub struct Shared;\n{parent}");
        let tree = MadeUp::new("parent", &[lib, ("low.rs", &parent), child]);
        assert_eq!(circles(&tree.sources()).len(), circle, "{parent}");
    }
}

#[test]
fn files_functions_and_folders_beyond_the_limits_are_found() {
    let function = format!("fn f() {{\n{}}}\n", "    f();\n".repeat(49));
    let short = MadeUp::new("short", &[("lib.rs", &function[..]), ("a.rs", &"\n".repeat(350))]);
    assert!(sizes::long_functions(&short.0).len() == 1 && sizes::long_files(&short.0).is_empty());
    let within = function.replacen("    f();\n", "", 1);
    let long = MadeUp::new("long", &[("lib.rs", &within[..]), ("a.rs", &"\n".repeat(351))]);
    assert!(sizes::long_functions(&long.0).is_empty() && sizes::long_files(&long.0).len() == 1);
    let names: Vec<String> = (0..17).map(|i| format!("full/f{i}.rs")).collect();
    let files: Vec<(&str, &str)> = names.iter().map(|n| (&n[..], "")).collect();
    assert_eq!(sizes::full_folders(&MadeUp::new("full", &files).0).len(), 1);
    assert!(sizes::full_folders(&MadeUp::new("fits", &files[1..]).0).is_empty());
}
