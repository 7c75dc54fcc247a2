//! The order of modules that ARCHITECTURE.md gives, and imports against it.

use std::collections::{BTreeMap, BTreeSet};

use crate::modules::Crate;

/// Modules of a crate from the bottom to the top; the root is not among them.
pub type Order = Vec<String>;

/// The heading that the orders stand under, a line a crate: "- `core`: `math`, `error`, ...".
const HEADING: &str = "## Order of modules";

/// The orders in ARCHITECTURE.md by the names of the crates.
pub fn orders(architecture: &str) -> BTreeMap<String, Order> {
    let section = architecture.split_once(HEADING).map_or("", |(_, after)| after);
    let section = section.split("\n## ").next().unwrap_or_default();
    let entries = section.split("\n- ").skip(1).map(|entry| entry.split("\n\n").next().unwrap_or_default());
    let quoted =
        |entry: &str| -> Vec<String> { entry.split('`').skip(1).step_by(2).map(String::from).collect() };
    entries.map(quoted).filter_map(|names| Some((names.first()?.clone(), names[1..].to_vec()))).collect()
}

/// Modules that the order does not name, and names in it that are no modules.
pub fn unlisted(sources: &Crate, order: &Order) -> Vec<String> {
    let there: BTreeSet<&String> = sources.modules.iter().filter_map(|m| m.path.first()).collect();
    let listed: BTreeSet<&String> = order.iter().collect();
    let root = sources.modules[0].file.display();
    let missing = there.difference(&listed).map(|m| format!("{root}: `{m}` is not in the order of modules"));
    let gone =
        listed.difference(&there).map(|m| format!("{root}: `{m}`, in the order of modules, is no module"));
    missing.chain(gone).collect()
}

/// Imports of a module that stands higher than the one that imports; from the root, of anything.
pub fn upwards(sources: &Crate, order: &Order) -> Vec<String> {
    let height = |m: usize| match sources.modules[m].path.first() {
        Some(name) => order.iter().position(|o| o == name).unwrap_or(order.len()),
        None => order.len() + 1,
    };
    let mut faults = Vec::new();
    for m in 0..sources.modules.len() {
        for (target, import) in sources.imported(m) {
            if height(target) > height(m) {
                let (file, path) = (sources.modules[m].file.display(), import.path.join("::"));
                faults.push(format!("{file}:{}: {path} is higher up", import.line));
            }
        }
    }
    faults
}
