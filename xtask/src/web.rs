//! The viewer of the reports: bundled from `web` by npm, and tested in a browser.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::browser::browser;
use crate::workspace::{cargo, root, succeed};

/// Fails on what ezdxf has to say of a DXF, or where it holds no creases, or borders.
const AUDIT: &str = "
import sys, ezdxf
document = ezdxf.readfile(sys.argv[1])
found = document.audit()
layers = [line.dxf.layer for line in document.modelspace().query('POLYLINE')]
assert not found.errors and not found.fixes, (found.errors, found.fixes)
assert layers and set(layers) == {'CREASE'}, layers
print(f'ok      ezdxf finds nothing wrong with the DXF of {len(layers)} lines')";

/// Installs what the lock file names, checks the types, and bundles the viewer into `crates/io/src/write/report`.
pub fn bundle() -> Result<(), String> {
    install()?;
    for script in ["check", "build"] {
        succeed(npm().args(["run", "--silent", script]))?;
    }
    Ok(())
}

/// Opens reports in a browser, as somebody who has the file alone; skips that, saying so, where there is no browser or no npm.
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
    reports(&folder)?;
    succeed(Command::new("node").arg(root().join("web/test/run.mjs")).arg(&folder).arg(browser))?;
    audit(&folder.join("left.dxf"))
}

/// Makes the reports that are opened.
fn reports(folder: &Path) -> Result<(), String> {
    let bracket = ["html", "csv"].map(|e| format!("bracket.{e}"));
    let outputs = bracket.iter().flat_map(|name| ["-o", name.as_str()]);
    succeed(lineament(folder).args(["extract", "--sample", "bracket"]).args(outputs))?;
    let stack = ["report", "--sample", "bracket", "--slices", "40", "-o", "stack.html"];
    succeed(lineament(folder).args(stack))?;
    let plate = format!("{}/web/test/plate.mjs", root().display());
    succeed(Command::new("node").arg(plate).arg(folder.join("plate.xyz")))?;
    succeed(lineament(folder).args(["extract", "plate.xyz", "-o", "plate.html"]))
}

/// Whether a DXF that was saved in the browser is whole, as ezdxf says; skips that, saying so, where no Python has it.
fn audit(saved: &Path) -> Result<(), String> {
    let named = std::env::var_os("LINEAMENT_PYTHON").map(PathBuf::from);
    let ours = ["venv", "python"].map(|name| root().join("out").join(name).join("bin/python"));
    let pythons = named.into_iter().chain(ours).chain(["python3".into()]);
    let has = |python: &PathBuf| {
        let mut import = Command::new(python);
        import
            .args(["-c", "import ezdxf"])
            .stderr(Stdio::null())
            .status()
            .is_ok_and(|status| status.success())
    };
    let Some(python) = pythons.into_iter().find(has) else {
        println!("skipped: no Python with ezdxf is there to audit the DXF; LINEAMENT_PYTHON can name one");
        return Ok(());
    };
    succeed(Command::new(python).args(["-c", AUDIT]).arg(saved))
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
