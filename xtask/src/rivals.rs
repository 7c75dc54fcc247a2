//! Comparisons with other people's programs: on the same inputs, on files of theirs that we read, and on files of ours that
//! they open.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::browser::{BROWSERS, browser};
use crate::workspace::{cargo, root, succeed};

/// The programs compared with.
const PACKAGES: [&str; 15] = [
    "numpy",
    "laspy",
    "lazrs",
    "plyfile",
    "pye57",
    "pypcd4",
    "ezdxf",
    "fiona",
    "trimesh",
    "pyvista",
    "pyarrow",
    "pandas",
    "duckdb",
    "pillow",
    "cadquery-ocp",
];
/// The programs that draw and check GLB.
const MODULES: [&str; 2] = ["three", "gltf-validator"];

/// Installs the programs in `out/venv` and `out/node`, once, and runs the tests that use them.
pub fn run() -> Result<(), String> {
    let venv = root().join("out").join("venv");
    let python = venv.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    if !python.exists() {
        succeed(Command::new("python3").args(["-m", "venv"]).arg(&venv))?;
    }
    for package in PACKAGES {
        or_skip(package, Command::new(&python).args(["-m", "pip", "install", "--quiet", package]));
    }
    compare(&python, modules().as_deref(), installed().as_deref())
}

/// The folder of the node modules, if npm can install them.
fn modules() -> Option<PathBuf> {
    let folder = root().join("out").join("node");
    std::fs::create_dir_all(&folder).ok()?;
    let npm = if cfg!(windows) { "npm.cmd" } else { "npm" };
    let mut install = Command::new(npm);
    install.args(["install", "--silent", "--no-save", "--prefix"]).arg(&folder).args(MODULES);
    or_skip("three.js", &mut install).then(|| folder.join("node_modules"))
}

/// A browser that is there, or that Debian's package manager installs where it may.
fn installed() -> Option<PathBuf> {
    browser().or_else(|| {
        let mut install = Command::new("apt-get");
        install.args(["install", "--yes", "--no-install-recommends", BROWSERS[0]]);
        or_skip("a browser", &mut install);
        browser()
    })
}

fn compare(python: &Path, modules: Option<&Path>, browser: Option<&Path>) -> Result<(), String> {
    // The tests run example programs, which cargo builds only where no test is named.
    let mut build = cargo();
    succeed(build.args(["test", "--locked", "--package", "lineament-io", "--no-run"]))?;
    let mut tests = cargo();
    tests.args(["test", "--locked", "--package", "lineament-io", "in_other_programs", "--"]);
    tests.args(["--nocapture", "--test-threads=1"]).env("LINEAMENT_PYTHON", python);
    let found = [("LINEAMENT_NODE", modules), ("LINEAMENT_BROWSER", browser)];
    tests.envs(found.into_iter().filter_map(|(name, path)| Some((name, path?))));
    succeed(&mut tests)
}

/// Whether a command that installs something worked; says that it is skipped if not.
fn or_skip(what: &str, command: &mut Command) -> bool {
    succeed(command).inspect_err(|why| println!("{what} cannot be installed, and is skipped: {why}")).is_ok()
}
