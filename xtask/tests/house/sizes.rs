//! The limits of files, functions and folders.

use std::path::{Path, PathBuf};

use crate::code::{blanked, item_end};

/// Greatest length of a file, lines.
const FILE_LINES: usize = 350;
/// Greatest length of a function, lines from its name to its last brace.
const FUNCTION_LINES: usize = 50;
/// Greatest number of files in a folder.
const FOLDER_FILES: usize = 16;
/// Folders with one file a format or a shape, which may hold more.
const ONE_FILE_A_KIND: [&str; 4] =
    ["crates/core/src/shapes/parts", "crates/io/src/read", "crates/io/tests/suite", "fuzz/fuzz_targets"];

/// Source files that are too long.
pub fn long_files(root: &Path) -> Vec<String> {
    let length = |file: &PathBuf| read(file).lines().count();
    let long = sources(root).into_iter().map(|f| (length(&f), f)).filter(|(lines, _)| *lines > FILE_LINES);
    long.map(|(lines, file)| format!("{}: {lines} lines", file.display())).collect()
}

/// Functions that are too long.
pub fn long_functions(root: &Path) -> Vec<String> {
    sources(root)
        .iter()
        .flat_map(|file| {
            let long = functions(&read(file)).into_iter().filter(|f| f.lines > FUNCTION_LINES);
            long.map(|f| format!("{}:{}: {} has {} lines", file.display(), f.line, f.name, f.lines))
                .collect::<Vec<_>>()
        })
        .collect()
}

/// Folders with too many files. A file `x.rs` beside a folder `x` belongs to that folder.
pub fn full_folders(root: &Path) -> Vec<String> {
    let mut folders: Vec<PathBuf> =
        sources(root).iter().filter_map(|f| Some(f.parent()?.to_path_buf())).collect();
    folders.dedup();
    let exempt = |folder: &Path| ONE_FILE_A_KIND.iter().any(|e| folder == root.join(e));
    let full = folders.into_iter().filter(|f| !exempt(f)).map(|f| (files(&f), f));
    let full = full.filter(|(count, _)| *count > FOLDER_FILES);
    full.map(|(count, folder)| format!("{}: {count} files", folder.display())).collect()
}

fn files(folder: &Path) -> usize {
    entries(folder).iter().filter(|p| is_rust(p) && !p.with_extension("").is_dir()).count()
}

/// A function with its length.
#[derive(Debug, PartialEq)]
pub struct Function {
    pub name: String,
    pub line: usize,
    pub lines: usize,
}

/// The functions of a file that have a body.
pub fn functions(source: &str) -> Vec<Function> {
    let code = blanked(source);
    let starts = code.match_indices("fn ").map(|(at, _)| at);
    let starts = starts.filter(|&at| !code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_'));
    let function = |at: usize| {
        let name: String = code[at + 3..].chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
        let end = item_end(&code, at);
        let has_body = code[at..end].ends_with('}');
        let line = code[..at].matches('\n').count() + 1;
        let lines = code[at..end].matches('\n').count() + 1;
        (has_body && !name.is_empty()).then_some(Function { name, line, lines })
    };
    starts.filter_map(function).collect()
}

/// Folders of the workspace that hold sources: those of the crates with their tests, benches and examples.
const SOURCES: [&str; 5] = ["crates", "examples", "fuzz", "tools", "xtask"];

/// All source files of the workspace.
fn sources(root: &Path) -> Vec<PathBuf> {
    let mut all = Vec::new();
    let folders = SOURCES.map(|folder| root.join(folder));
    folders.iter().filter(|f| f.is_dir()).for_each(|f| collect(f, &mut all));
    all
}

fn collect(folder: &Path, all: &mut Vec<PathBuf>) {
    let (folders, files): (Vec<PathBuf>, Vec<PathBuf>) =
        entries(folder).into_iter().partition(|p| p.is_dir());
    all.extend(files.into_iter().filter(|p| is_rust(p)));
    folders.iter().filter(|f| !f.ends_with("target")).for_each(|f| collect(f, all));
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let listed = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut paths: Vec<PathBuf> = listed.map(|e| e.unwrap().path()).collect();
    paths.sort();
    paths
}

fn is_rust(path: &Path) -> bool {
    path.extension().is_some_and(|e| e == "rs")
}

fn read(file: &Path) -> String {
    std::fs::read_to_string(file).unwrap_or_else(|e| panic!("{}: {e}", file.display()))
}

#[test]
fn the_length_of_a_function_runs_from_its_name_to_its_last_brace() {
    let source = "trait A {\n    fn none(&self);\n}\nfn two(x: [u8; 3]) {\n}\n/// fn not() {\nfn four(\n) {\n    \"}\";\n}\n";
    let found: Vec<(String, usize, usize)> =
        functions(source).into_iter().map(|f| (f.name, f.line, f.lines)).collect();
    assert_eq!(found, [("two".into(), 4, 2), ("four".into(), 7, 4)]);
}
