//! The house rules that can be read from the sources: who imports whom, and how long files, functions and folders are.

mod circles;
mod code;
mod imports;
mod layers;
mod made_up;
mod modules;
mod sizes;

use std::path::{Path, PathBuf};

use circles::circles;
use layers::{Order, orders, unlisted, upwards};
use modules::Crate;

/// The crates of the workspace that have an order of their own, with their folders.
const CRATES: [(&str, &str); 5] = [
    ("core", "crates/core"),
    ("io", "crates/io"),
    ("cli", "crates/cli"),
    ("py", "crates/py"),
    ("xtask", "xtask"),
];

fn root() -> PathBuf {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    own.parent().unwrap_or(own).to_path_buf()
}

/// Every crate with the order that ARCHITECTURE.md gives its modules.
fn crates() -> Vec<(Crate, Order)> {
    let text = std::fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let mut orders = orders(&text);
    let all = CRATES.map(|(name, folder)| {
        let order = orders.remove(name).unwrap_or_else(|| panic!("ARCHITECTURE.md has no order of `{name}`"));
        (Crate::read(&root().join(folder).join("src")), order)
    });
    assert!(orders.is_empty(), "ARCHITECTURE.md orders crates that are not checked: {:?}", orders.keys());
    all.into()
}

fn holds(faults: Vec<String>) {
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn the_order_in_architecture_names_every_module_and_no_other() {
    holds(crates().iter().flat_map(|(sources, order)| unlisted(sources, order)).collect());
}

#[test]
fn no_module_imports_one_above_it() {
    holds(crates().iter().flat_map(|(sources, order)| upwards(sources, order)).collect());
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    holds(crates().iter().flat_map(|(sources, _)| circles(sources)).collect());
}

#[test]
fn no_file_has_more_than_350_lines() {
    holds(sizes::long_files(&root()));
}

#[test]
fn no_function_has_more_than_50_lines() {
    holds(sizes::long_functions(&root()));
}

#[test]
fn no_folder_has_more_than_16_files() {
    holds(sizes::full_folders(&root()));
}
