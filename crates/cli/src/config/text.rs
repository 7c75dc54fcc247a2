//! Parameters as TOML text.

use std::fmt::Write;

use lineament::params::{Entry, Params};

/// Width of the comments.
const COLUMNS: usize = 100;

/// Every parameter as a TOML file that `--params` reads back: meaning, unit, range and default above each.
pub fn commented(params: &Params) -> String {
    let mut text = String::from(
        "# Parameters of lineament. Lengths are in spacings of the cloud unless their unit is another, angles in degrees.\n",
    );
    let entries = params.entries();
    let (plain, tabled): (Vec<&Entry>, Vec<&Entry>) = entries.iter().partition(|e| !e.key.contains('.'));
    plain.into_iter().for_each(|entry| write_entry(&mut text, entry, &entry.key));
    let mut open = "";
    for entry in tabled {
        let (table, key) = entry.key.rsplit_once('.').unwrap_or(("", &entry.key));
        if table != open {
            let _ = write!(text, "\n[{table}]\n");
            open = table;
        }
        write_entry(&mut text, entry, key);
    }
    text
}

fn write_entry(text: &mut String, entry: &Entry, key: &str) {
    let _ = writeln!(text);
    for line in wrapped(entry.doc, COLUMNS) {
        let _ = writeln!(text, "# {line}");
    }
    let facts: Vec<&str> = [entry.unit, &entry.accepts].into_iter().filter(|t| !t.is_empty()).collect();
    let facts = if facts.is_empty() { String::new() } else { format!("{}; ", facts.join(", ")) };
    let _ = writeln!(text, "# {facts}default {}", value(&entry.default));
    let _ = writeln!(text, "{key} = {}", value(&entry.value));
}

/// The text of a value as TOML: numbers and truth values bare, all else quoted.
pub fn value(text: &str) -> String {
    let is_number = text.parse::<f64>().is_ok_and(f64::is_finite) && !text.starts_with(['.', '+']);
    if is_number || text == "true" || text == "false" {
        text.into()
    } else {
        toml::Value::String(text.into()).to_string()
    }
}

/// The words of a text in lines of at most `columns` characters, or one word where that is longer.
fn wrapped(text: &str, columns: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= columns => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.into()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_toml() {
        assert_eq!(value("0.5"), "0.5");
        assert_eq!(value("12"), "12");
        assert_eq!(value("true"), "true");
        assert_eq!(value("auto"), "\"auto\"");
        assert_eq!(value("a\"b"), "'a\"b'");
    }

    #[test]
    fn the_text_is_toml_with_every_parameter() {
        let params = Params::default();
        let table: toml::Table = commented(&params).parse().unwrap();
        for entry in params.entries() {
            let mut keys = entry.key.split('.');
            let first = table.get(keys.next().unwrap());
            assert!(keys.fold(first, |t, key| t.and_then(|t| t.get(key))).is_some(), "{}", entry.key);
        }
    }

    #[test]
    fn long_texts_are_wrapped() {
        assert_eq!(wrapped("one two  three", 7), ["one two", "three"]);
        assert_eq!(wrapped("", 7), Vec::<String>::new());
    }
}
