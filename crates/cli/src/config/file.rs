//! Parameter files: TOML tables, flattened to dotted keys, or the `parameters` of a JSON file that `extract` wrote.

use std::path::Path;

use lineament::params::Params;
use serde_json::Value;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::failure::{Code, Failure};

/// Sets every parameter that the file names.
///
/// # Errors
/// Input if the file cannot be read or is not TOML, refused if a parameter is; all with file and line.
pub fn read(path: &Path, params: &mut Params) -> Result<(), Failure> {
    each(path, &mut |key, value| super::set(params, key, value))
}

/// What takes a key and its value.
type Take<'a> = dyn FnMut(&str, &str) -> Result<(), Failure> + 'a;

/// Hands every key that the file names, with its value, to `take`.
///
/// # Errors
/// Input if the file cannot be read or is not TOML, or as `take`; all with file and line.
pub fn each(path: &Path, take: &mut Take) -> Result<(), Failure> {
    let name = path.display();
    let text = std::fs::read_to_string(path)
        .map_err(|e| Failure::new(Code::Input, format!("{name}: cannot read the parameter file: {e}")))?;
    if text.trim_start().starts_with('{') {
        return from_json(&text, take).map_err(|e| e.at(name));
    }
    let table = DeTable::parse(&text).map_err(|e| {
        let line = e.span().map_or(1, |span| line_of(&text, span.start));
        Failure::new(Code::Input, format!("{name}:{line}: not TOML: {}", e.message()))
            .advise("`lineament params` prints a valid file to start from")
    })?;
    set_table(&text, "", table.get_ref(), take).map_err(|(line, e)| e.at(format!("{name}:{line}")))
}

/// Takes every parameter of the object `parameters`.
fn from_json(text: &str, take: &mut Take) -> Result<(), Failure> {
    let fail = |what: String| {
        Failure::new(Code::Input, what).advise("give a TOML file, or the JSON that `lineament extract` wrote")
    };
    let root: Value = serde_json::from_str(text).map_err(|e| fail(format!("not JSON: {e}")))?;
    let entries = root["parameters"].as_object().ok_or_else(|| fail("no object `parameters`".into()))?;
    for (key, value) in entries {
        let plain = value.as_str().map_or_else(|| value.to_string(), String::from);
        take(key, &plain)?;
    }
    Ok(())
}

/// The one-based line of a byte offset.
fn line_of(text: &str, offset: usize) -> usize {
    1 + text.as_bytes().iter().take(offset).filter(|&&byte| byte == b'\n').count()
}

fn set_table(text: &str, prefix: &str, table: &DeTable, take: &mut Take) -> Result<(), (usize, Failure)> {
    for (key, value) in table {
        let key_text = format!("{prefix}{}", key.get_ref());
        match value.get_ref() {
            DeValue::Table(inner) => set_table(text, &format!("{key_text}."), inner, take)?,
            _ => {
                let line = line_of(text, key.span().start);
                set_value(text, &key_text, value, take).map_err(|e| (line, e))?;
            }
        }
    }
    Ok(())
}

fn set_value(text: &str, key: &str, value: &Spanned<DeValue>, take: &mut Take) -> Result<(), Failure> {
    let source = text.get(value.span()).unwrap_or_default();
    let plain = match value.get_ref() {
        DeValue::String(string) => string.to_string(),
        DeValue::Integer(_) | DeValue::Float(_) => source.replace('_', ""),
        DeValue::Boolean(truth) => truth.to_string(),
        _ => {
            let message =
                format!("parameter `{key}` = `{source}`: a number, a truth value or a text is expected");
            return Err(Failure::new(Code::Refused, message));
        }
    };
    take(key, &plain)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_text(text: &str) -> Result<Params, Failure> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("p.toml");
        std::fs::write(&path, text).unwrap();
        let mut params = Params::default();
        read(&path, &mut params).map(|()| params)
    }

    fn value_of(params: &Params, key: &str) -> String {
        params.entries().into_iter().find(|e| e.key == key).unwrap().value
    }

    #[test]
    fn printed_defaults_read_back_as_they_were() {
        let text = super::super::text::commented(&Params::default());
        let again = read_text(&text).unwrap();
        assert_eq!(super::super::text::commented(&again), text);
    }

    #[test]
    fn tables_and_dotted_keys_are_the_same() {
        for text in ["[penalty]\ngamma = 0.25\n", "penalty.gamma = 0.25", "penalty = { gamma = \"0.25\" }"] {
            assert_eq!(value_of(&read_text(text).unwrap(), "penalty.gamma"), "0.25", "{text}");
        }
    }

    #[test]
    fn errors_name_file_line_key_and_value() {
        let cases = [
            ("\n[penalty]\n\ngamma = 7.5\n", Code::Refused, ":4: ", "penalty.gamma"),
            ("[penalty]\nwarp = 1\n", Code::Refused, ":2: ", "penalty.warp"),
            ("[penalty]\ngamma = [1, 2]\n", Code::Refused, ":2: ", "[1, 2]"),
            ("a = 1\nb = = 2\n", Code::Input, ":2: ", "not TOML"),
        ];
        for (text, code, line, part) in cases {
            let failure = read_text(text).unwrap_err();
            assert_eq!(failure.code, code, "{text}");
            for expected in ["p.toml", line, part] {
                assert!(failure.message.contains(expected), "{} in {}", expected, failure.message);
            }
        }
    }
}
