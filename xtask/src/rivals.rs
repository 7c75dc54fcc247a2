//! Comparisons with other people's programs: what they read of the same files, and whether they open what is written.

use std::path::Path;
use std::process::Command;

use crate::{cargo, root};

/// What is compared with.
const PACKAGES: [&str; 10] =
    ["numpy", "laspy", "lazrs", "plyfile", "pye57", "ezdxf", "fiona", "trimesh", "pyvista", "pyarrow"];

/// Installs the programs in a virtual environment in `out/venv`, once, and runs the tests that use them.
pub fn run() -> Result<(), String> {
    let venv = root().join("out").join("venv");
    let python = venv.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    if !python.exists() {
        succeed(Command::new("python3").args(["-m", "venv"]).arg(&venv))?;
    }
    for package in PACKAGES {
        if let Err(message) =
            succeed(Command::new(&python).args(["-m", "pip", "install", "--quiet", package]))
        {
            println!("{package} cannot be installed, and is skipped: {message}");
        }
    }
    compare(&python)
}

fn compare(python: &Path) -> Result<(), String> {
    // The tests run example programs, which cargo builds only where no test is named.
    let mut build = cargo();
    succeed(build.args(["test", "--locked", "--package", "lineament-io", "--no-run"]))?;
    let mut tests = cargo();
    tests.args(["test", "--locked", "--package", "lineament-io", "in_other_programs", "--"]);
    tests.args(["--nocapture", "--test-threads=1"]).env("LINEAMENT_PYTHON", python);
    succeed(&mut tests)
}

fn succeed(command: &mut Command) -> Result<(), String> {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{command:?} failed ({status})")),
        Err(e) => Err(format!("{command:?}: {e}")),
    }
}
