//! Files that import each other in a circle.

use std::collections::BTreeSet;

use crate::modules::Crate;

/// The circles of a crate: each set of files of which every one leads to every other, with what ties them.
pub fn circles(sources: &Crate) -> Vec<String> {
    let count = sources.modules.len();
    let next: Vec<BTreeSet<usize>> =
        (0..count).map(|m| sources.imported(m).into_iter().map(|(target, _)| target).collect()).collect();
    let reached: Vec<BTreeSet<usize>> = (0..count).map(|m| reach(&next, m)).collect();
    let mut seen = BTreeSet::new();
    let mut faults = Vec::new();
    for m in 0..count {
        let circle: Vec<usize> =
            reached[m].iter().copied().filter(|&other| reached[other].contains(&m)).collect();
        if !circle.is_empty() && seen.insert(circle.clone()) {
            let ties = circle.iter().flat_map(|&a| next[a].iter().map(move |&b| (a, b)));
            let ties = ties.filter(|(_, b)| circle.contains(b));
            let named = |m: usize| sources.modules[m].file.display();
            let ties: Vec<String> = ties.map(|(a, b)| format!("  {} -> {}", named(a), named(b))).collect();
            faults.push(format!("{} files in a circle:\n{}", circle.len(), ties.join("\n")));
        }
    }
    faults
}

/// All files that a file leads to; itself only if it comes back.
fn reach(next: &[BTreeSet<usize>], from: usize) -> BTreeSet<usize> {
    let mut found = BTreeSet::new();
    let mut open: Vec<usize> = next[from].iter().copied().collect();
    while let Some(m) = open.pop() {
        if found.insert(m) {
            open.extend(&next[m]);
        }
    }
    found
}
