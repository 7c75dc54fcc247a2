//! Source text without what is no code: comments and literals are blanked, items for tests are taken out.

/// `source` with comments, strings and characters as blanks; line by line as long as before.
pub fn blanked(source: &str) -> String {
    let text: Vec<char> = source.chars().collect();
    let mut out = String::with_capacity(source.len());
    let mut at = 0;
    while at < text.len() {
        let end = literal_end(&text, at);
        if end == at {
            out.push(text[at]);
            at += 1;
        } else {
            out.extend(text[at..end].iter().map(|&c| if c == '\n' { '\n' } else { ' ' }));
            at = end;
        }
    }
    out
}

/// Where the comment or literal ends that begins at `at`; `at` itself if none does.
fn literal_end(text: &[char], at: usize) -> usize {
    let next = text.get(at + 1).copied();
    match (text[at], next) {
        ('/', Some('/')) => find(text, at, |i| text[i] == '\n'),
        ('/', Some('*')) => block_comment_end(text, at),
        ('"', _) => string_end(text, at + 1),
        ('r', Some('"' | '#')) if !follows_word(text, at) => raw_string_end(text, at),
        ('\'', Some('\\')) => find(text, at + 3, |i| text[i] == '\'') + 1,
        ('\'', Some(_)) if text.get(at + 2) == Some(&'\'') => at + 3,
        _ => at,
    }
}

fn follows_word(text: &[char], at: usize) -> bool {
    // The `b` of a raw byte string is no word.
    at > 0 && (text[at - 1].is_alphanumeric() || text[at - 1] == '_') && text[at - 1] != 'b'
}

fn find(text: &[char], from: usize, is: impl Fn(usize) -> bool) -> usize {
    (from..text.len()).find(|&i| is(i)).unwrap_or(text.len())
}

fn block_comment_end(text: &[char], at: usize) -> usize {
    let (mut depth, mut i) = (0, at);
    while i + 1 < text.len() {
        match (text[i], text[i + 1]) {
            ('/', '*') => (depth, i) = (depth + 1, i + 2),
            ('*', '/') if depth == 1 => return i + 2,
            ('*', '/') => (depth, i) = (depth - 1, i + 2),
            _ => i += 1,
        }
    }
    text.len()
}

fn string_end(text: &[char], mut i: usize) -> usize {
    while i < text.len() && text[i] != '"' {
        i += if text[i] == '\\' { 2 } else { 1 };
    }
    (i + 1).min(text.len())
}

fn raw_string_end(text: &[char], at: usize) -> usize {
    let hashes = text[at + 1..].iter().take_while(|&&c| c == '#').count();
    if text.get(at + 1 + hashes) != Some(&'"') {
        return at;
    }
    let closes = |i: usize| {
        text[i] == '"' && text[i + 1..].len() >= hashes && text[i + 1..][..hashes].iter().all(|&c| c == '#')
    };
    (find(text, at + 2 + hashes, closes) + 1 + hashes).min(text.len())
}

/// Blanked code without the items that stand under `#[cfg(test)]`; lines stay where they are.
pub fn without_tests(code: &str) -> String {
    const MARK: &str = "#[cfg(test)]";
    let mut out = code.to_string();
    while let Some(start) = out.find(MARK) {
        let end = item_end(&out, start + MARK.len());
        let blank: String = out[start..end].chars().map(|c| if c == '\n' { '\n' } else { ' ' }).collect();
        out.replace_range(start..end, &blank);
    }
    out
}

/// Where the item that begins after `from` ends: at its semicolon, or where its braces close.
pub fn item_end(code: &str, from: usize) -> usize {
    let mut depth = 0;
    for (i, c) in code[from..].char_indices() {
        match c {
            '{' | '(' | '[' => depth += 1,
            '}' if depth == 1 => return from + i + 1,
            '}' | ')' | ']' => depth -= 1,
            ';' if depth == 0 => return from + i + 1,
            _ => {}
        }
    }
    code.len()
}

#[test]
fn comments_and_literals_are_no_code() {
    let source = "a // use crate::b;\n/* x /* y */ z */ c \"use \\\" d\" 'e' '\\'' r#\"f\" g\"# <'h> br\"i\"";
    let words: Vec<String> = blanked(source).split_whitespace().map(String::from).collect();
    assert_eq!(words, ["a", "c", "<'h>", "b"]);
    assert_eq!(blanked(source).lines().count(), source.lines().count());
}

#[test]
fn items_for_tests_are_left_out() {
    let code = "mod a;\n#[cfg(test)]\nmod b;\n#[cfg(test)]\nmod c { fn d() { } }\nmod e;";
    let words: Vec<String> = without_tests(code).split_whitespace().map(String::from).collect();
    assert_eq!(words, ["mod", "a;", "mod", "e;"]);
}
