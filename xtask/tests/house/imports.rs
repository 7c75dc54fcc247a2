//! What a file imports: its `use` declarations, and the paths within its code that begin at the crate or above.

use crate::code::item_end;

/// A path that a file names.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// The segments, the last a name or `*`.
    pub path: Vec<String>,
    /// The name under which it is known here.
    pub name: String,
    /// Whether the file hands it on.
    pub is_public: bool,
    /// Whether the file itself makes use of it: a name that is only handed on ties two files no closer than `mod` does.
    pub is_used: bool,
    /// Line of the file, from 1 on.
    pub line: usize,
}

/// All imports of blanked code.
pub fn imports(code: &str) -> Vec<Import> {
    let mut found = Vec::new();
    let mut rest = code.to_string();
    for start in word_starts(code, "use") {
        let end = item_end(code, start);
        let is_public = code[..start].rsplit([';', '}', '{']).next().is_some_and(|s| s.contains("pub"));
        let line = line_of(code, start);
        let tree: String = code[start + 3..end - 1].chars().collect();
        expand(&tree, &[], &mut |path, name| {
            found.push(Import { path, name, is_public, is_used: true, line });
        });
        let blank: String = code[start..end].chars().map(|c| if c == '\n' { '\n' } else { ' ' }).collect();
        rest.replace_range(start..end, &blank);
    }
    for import in found.iter_mut().filter(|i| i.is_public) {
        import.is_used = !word_starts(&rest, &import.name).is_empty();
    }
    found.extend(paths(&rest));
    found
}

/// Paths outside of `use` declarations that begin with `crate`, `super` or `self`.
fn paths(code: &str) -> Vec<Import> {
    let starts = ["crate", "super", "self"].into_iter().flat_map(|w| word_starts(code, w));
    let path = |start: usize| -> Option<Import> {
        // `pub(in crate::a)` says who may see an item and imports nothing.
        if ["::", "pub(in "].iter().any(|before| code[..start].ends_with(before)) {
            return None;
        }
        let length = code[start..].find(|c: char| !(is_word(c) || c == ':')).unwrap_or(code.len() - start);
        let path: Vec<String> =
            code[start..start + length].split("::").filter(|s| !s.is_empty()).map(String::from).collect();
        let name = path.last()?.clone();
        (path.len() > 1).then(|| Import {
            path,
            name,
            is_public: false,
            is_used: true,
            line: line_of(code, start),
        })
    };
    starts.filter_map(path).collect()
}

/// Calls `take` with each path of a use tree and the name that it has here.
fn expand(tree: &str, before: &[String], take: &mut impl FnMut(Vec<String>, String)) {
    let tree = tree.trim().trim_start_matches("::");
    if let Some(open) = tree.find('{') {
        let head = segments(&tree[..open]);
        let before: Vec<String> = before.iter().cloned().chain(head).collect();
        let inner = tree[open + 1..].trim_end().trim_end_matches('}');
        split_outside_braces(inner).into_iter().for_each(|part| expand(part, &before, take));
        return;
    }
    let (path, alias) = match tree.split_once(" as ") {
        Some((path, alias)) => (path, Some(alias.trim().to_string())),
        None => (tree, None),
    };
    let mut all: Vec<String> = before.iter().cloned().chain(segments(path)).collect();
    if all.len() > 1 && all.last().is_some_and(|s| s == "self") {
        all.pop();
    }
    if let Some(name) = alias.or_else(|| all.last().cloned()) {
        take(all, name);
    }
}

fn segments(path: &str) -> Vec<String> {
    path.split("::").map(str::trim).filter(|s| !s.is_empty()).map(String::from).collect()
}

/// The parts between the commas that stand in no braces.
fn split_outside_braces(text: &str) -> Vec<&str> {
    let (mut parts, mut depth, mut start) = (Vec::new(), 0, 0);
    for (i, c) in text.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&text[start..i]);
                start = i + 1;
            }
            _ => {}
        }
    }
    parts.push(&text[start..]);
    parts.retain(|p| !p.trim().is_empty());
    parts
}

/// Where a word stands by itself.
fn word_starts(code: &str, word: &str) -> Vec<usize> {
    let alone = |&(at, _): &(usize, &str)| {
        let before = code[..at].chars().next_back().is_some_and(|c| is_word(c) || c == '\'');
        let after = code[at + word.len()..].chars().next().is_some_and(is_word);
        !before && !after
    };
    code.match_indices(word).filter(alone).map(|(at, _)| at).collect()
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn line_of(code: &str, at: usize) -> usize {
    code[..at].matches('\n').count() + 1
}

#[test]
fn use_trees_and_inline_paths_are_found() {
    let code = "pub use a::{b, c::{self, d as e}, f::*};\nfn g(x: &crate::h::I) { super::j::k(x); y.use_it() }\npub(in crate::l) fn m() {}";
    assert!(imports("pub use a::b; fn c() { b() }")[0].is_used && !imports("pub use a::b;")[0].is_used);
    let found: Vec<(String, String, bool, usize)> =
        imports(code).into_iter().map(|i| (i.path.join("::"), i.name, i.is_public, i.line)).collect();
    let is = |path: &str, name: &str, public, line| (path.into(), name.into(), public, line);
    assert_eq!(
        found,
        [
            is("a::b", "b", true, 1),
            is("a::c", "c", true, 1),
            is("a::c::d", "e", true, 1),
            is("a::f::*", "*", true, 1),
            is("crate::h::I", "I", false, 2),
            is("super::j::k", "k", false, 2),
        ]
    );
}
