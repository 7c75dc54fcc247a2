//! The viewer of the reports: bundled from `web` by npm, and tested in a browser.

use std::path::Path;
use std::process::Command;

use crate::browser::browser;
use crate::workspace::{cargo, root, succeed};

/// Installs what the lock file names, checks the types, and bundles the viewer into `crates/io/src/write/report`.
pub fn bundle() -> Result<(), String> {
    install()?;
    for script in ["check", "build"] {
        succeed(npm().args(["run", "--silent", script]))?;
    }
    Ok(())
}

/// Opens reports of the bracket in a browser; skips that, saying so, where there is no browser or no npm.
pub fn test() -> Result<(), String> {
    let Some(browser) = browser() else {
        println!("skipped: no browser is there; LINEAMENT_BROWSER can name one");
        return Ok(());
    };
    if npm().arg("--version").output().is_err() {
        println!("skipped: npm is not there");
        return Ok(());
    }
    install()?;
    let folder = root().join("out").join("report");
    std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let bracket = ["html", "csv"].map(|e| format!("bracket.{e}"));
    let outputs = bracket.iter().flat_map(|name| ["-o", name.as_str()]);
    succeed(lineament(&folder).args(["extract", "--sample", "bracket"]).args(outputs))?;
    succeed(lineament(&folder).args([
        "report",
        "--sample",
        "bracket",
        "--slices",
        "40",
        "-o",
        "stack.html",
    ]))?;
    succeed(Command::new("node").arg(root().join("web/test/run.mjs")).arg(&folder).arg(browser))
}

/// The program that `LINEAMENT_PROGRAM` names, or that of this workspace.
fn lineament(folder: &Path) -> Command {
    let mut command = match std::env::var_os("LINEAMENT_PROGRAM") {
        Some(program) => Command::new(program),
        None => {
            let mut command = cargo();
            let manifest = root().join("Cargo.toml");
            command.args(["run", "--release", "--locked", "--quiet", "--manifest-path"]).arg(manifest);
            command.args(["--package", "lineament-cli", "--"]);
            command
        }
    };
    command.current_dir(folder);
    command
}

fn install() -> Result<(), String> {
    succeed(npm().args(["ci", "--silent", "--ignore-scripts"]))
}

fn npm() -> Command {
    let mut command = Command::new(if cfg!(windows) { "npm.cmd" } else { "npm" });
    command.current_dir(root().join("web"));
    command
}
