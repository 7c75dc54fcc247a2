//! Manual pages, one for the program and one for each command.

use crate::workspace::{cargo, root};

/// Has the program write its pages to `out/man`.
pub fn run() -> Result<(), String> {
    let folder = root().join("out").join("man");
    std::fs::create_dir_all(&folder).map_err(|e| format!("cannot make {}: {e}", folder.display()))?;
    let status = cargo()
        .args(["run", "--quiet", "--locked", "--release", "--package", "lineament-cli", "--", "man"])
        .arg(&folder)
        .status();
    match status {
        Ok(status) if status.success() => {
            println!("wrote {}", folder.display());
            Ok(())
        }
        Ok(status) => Err(format!("the program could not write its manual pages ({status})")),
        Err(e) => Err(format!("cannot run cargo: {e}")),
    }
}
