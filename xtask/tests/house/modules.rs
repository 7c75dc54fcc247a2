//! The modules of a crate, found from its root by their declarations.

use std::path::{Path, PathBuf};

use crate::code::{blanked, without_tests};
use crate::imports::{Import, imports};

/// A file of a crate.
pub struct Module {
    /// The path of the module below the crate, without `crate`; empty for the root.
    pub path: Vec<String>,
    pub file: PathBuf,
    pub imports: Vec<Import>,
}

/// The files of a crate, the root first; those for tests are left out.
#[derive(Default)]
pub struct Crate {
    pub modules: Vec<Module>,
}

impl Crate {
    /// Reads the crate with this source folder.
    pub fn read(src: &Path) -> Crate {
        let root = ["lib.rs", "main.rs"].map(|n| src.join(n)).into_iter().find(|p| p.exists());
        let root = root.unwrap_or_else(|| panic!("{} holds no crate", src.display()));
        let mut all = Crate::default();
        all.add(Vec::new(), root, src.to_path_buf());
        all
    }

    /// Adds a file and those that it declares, which stand in `folder`.
    fn add(&mut self, path: Vec<String>, file: PathBuf, folder: PathBuf) {
        let text = std::fs::read_to_string(&file).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
        let code = without_tests(&blanked(&text));
        self.modules.push(Module { path: path.clone(), file, imports: imports(&code) });
        for name in declared(&code) {
            let own = [folder.join(format!("{name}.rs")), folder.join(&name).join("mod.rs")];
            let file = own.into_iter().find(|p| p.exists());
            let file = file.unwrap_or_else(|| panic!("module {name} is not in {}", folder.display()));
            let path = path.iter().cloned().chain([name.clone()]).collect();
            self.add(path, file, folder.join(&name));
        }
    }

    /// The module with this path.
    pub fn find(&self, path: &[String]) -> Option<usize> {
        self.modules.iter().position(|m| m.path == path)
    }

    /// The files that a file imports from: where each name is defined, whatever file hands it on. What stands below a
    /// file and is only handed on by it is no import of its own.
    pub fn imported(&self, module: usize) -> Vec<(usize, &Import)> {
        let own = &self.modules[module].path;
        let all = self.modules[module].imports.iter();
        let found = all.filter_map(|i| Some((self.definition(module, &i.path, 0)?, i)));
        let counts = |target: usize, import: &Import| {
            target != module && (import.is_used || !self.modules[target].path.starts_with(own))
        };
        found.filter(|&(target, import)| counts(target, import)).collect()
    }

    /// The file that defines what `path` names as seen from a module; `None` if it is not of this crate.
    fn definition(&self, from: usize, path: &[String], depth: usize) -> Option<usize> {
        let (mut place, rest) = self.start(from, path)?;
        let mut rest = rest.iter();
        while let Some(name) = rest.next() {
            let child: Vec<String> = place.iter().chain([name]).cloned().collect();
            if self.find(&child).is_some() {
                place = child;
                continue;
            }
            let holder = self.find(&place)?;
            let handed_on = self.modules[holder].imports.iter().find(|i| i.is_public && i.name == *name);
            // A name that is handed on in a ring is defined nowhere: the compiler says so.
            return match handed_on.filter(|_| depth < 16) {
                Some(import) => {
                    let onwards: Vec<String> = import.path.iter().chain(rest).cloned().collect();
                    self.definition(holder, &onwards, depth + 1)
                }
                None => Some(holder),
            };
        }
        self.find(&place)
    }

    /// The module that the head of a path names, and what follows the head.
    fn start<'a>(&self, from: usize, path: &'a [String]) -> Option<(Vec<String>, &'a [String])> {
        let own = &self.modules[from].path;
        let ups = path.iter().take_while(|s| *s == "super").count();
        if ups > 0 {
            return Some((own[..own.len().checked_sub(ups)?].to_vec(), &path[ups..]));
        }
        match path.first()?.as_str() {
            "crate" => Some((Vec::new(), &path[1..])),
            "self" => Some((own.clone(), &path[1..])),
            child => {
                let below: Vec<String> = own.iter().cloned().chain([child.to_string()]).collect();
                self.find(&below).map(|_| (below, &path[1..]))
            }
        }
    }
}

/// The names of the modules that are declared with files of their own.
fn declared(code: &str) -> Vec<String> {
    let words: Vec<&str> = code.split_whitespace().collect();
    let pairs = words.windows(2).filter(|w| w[0] == "mod");
    pairs.filter_map(|w| w[1].strip_suffix(';')).map(String::from).collect()
}
