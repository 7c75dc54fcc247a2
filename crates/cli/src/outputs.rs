//! Outputs: named, checked before the long work begins, and written so that an interrupt leaves none in pieces.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use lineament_io as io;

use crate::failure::{Code, Failure};
use crate::interrupt;

/// Extensions of what `extract` writes when no output is named.
const DEFAULTS: [&str; 2] = ["lines.json", "lines.obj"];

/// The outputs asked for, or the default ones beside the input; standard output for standard input.
pub fn or_default(asked: &[PathBuf], stem: Option<&Path>) -> Vec<PathBuf> {
    match stem {
        _ if !asked.is_empty() => asked.to_vec(),
        Some(stem) => DEFAULTS.map(|extension| with_suffix(stem, extension)).to_vec(),
        None => vec![PathBuf::from("-")],
    }
}

fn with_suffix(stem: &Path, extension: &str) -> PathBuf {
    let mut name = OsString::from(stem);
    name.push(".");
    name.push(extension);
    name.into()
}

/// Refuses outputs that cannot be: two of one name, an input, a folder that is not there, or by `known` an extension
/// that no format has.
pub fn check<F, E: Into<Failure>>(
    outputs: &[PathBuf],
    inputs: &[PathBuf],
    known: impl Fn(&Path) -> Result<F, E>,
) -> Result<(), Failure> {
    for (i, output) in outputs.iter().enumerate() {
        if outputs[..i].contains(output) {
            return Err(Failure::new(Code::Usage, format!("{}: named as output twice", output.display())));
        }
        known(output).map_err(|e| Failure { code: Code::Usage, ..e.into() })?;
        if output.as_os_str() != "-" {
            io::check_output(output, inputs)?;
        }
    }
    Ok(())
}

/// Writes one output; an interrupt waits until it is whole.
pub fn write<T, E: Into<Failure>>(path: &Path, write: impl FnOnce() -> Result<T, E>) -> Result<T, Failure> {
    let _guard = (path.as_os_str() != "-").then(interrupt::writing);
    write().map_err(Into::into)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn default_outputs_stand_beside_the_input() {
        let expected = ["scans/a.b.lines.json", "scans/a.b.lines.obj"].map(PathBuf::from);
        assert_eq!(or_default(&[], Some(Path::new("scans/a.b"))), expected);
        assert_eq!(or_default(&[], None), [PathBuf::from("-")]);
        assert_eq!(or_default(&["x.dxf".into()], Some(Path::new("a"))), [PathBuf::from("x.dxf")]);
    }
}
