//! The Python package: its wheel, and its tests in an environment of their own. Needs Python 3.10 or later with venv and pip, which
//! fetches the tools (maturin, pytest, mypy, pyright) from the network.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::workspace::{cargo, root, succeed};

/// The profile of package and program unless another is named. That of tests inherits it, and they have compiled most of it; `test`
/// itself could not be named, as maturin's `cargo rustc` takes it for a wish to test the library.
const PROFILE: &str = "dev";

/// Said with a failure to make the environment.
const NO_PYTHON: &str = "\
The Python package is built and tested with Python 3.10 or later and its modules venv and pip: install them
(on Debian and Ubuntu: apt-get install python3-venv), and see that `python3` is on the path.";

/// Said with a failure of pip.
const NO_PACKAGES: &str = "\
pip fetches what builds and tests the Python package (python/requirements.txt, maturin) from the network or from where
PIP_INDEX_URL and PIP_FIND_LINKS lead it: the lines above say what it lacks.";

/// Builds the wheel into `out/wheels`.
pub fn wheel() -> Result<(), String> {
    let python = environment()?;
    let wheels = root().join("out").join("wheels");
    let mut build = pip(&python);
    build.args(["wheel", "--no-deps", "--wheel-dir"]).arg(wheels).arg(root());
    or_say(&mut build, NO_PACKAGES)
}

/// Installs the package in `out/python` by pip, as a user would, and runs its tests and the checks of its types.
pub fn test(profile: Option<&str>) -> Result<(), String> {
    let profile = profile.unwrap_or(PROFILE);
    let python = environment()?;
    let asked = root().join("python").join("requirements.txt");
    or_say(pip(&python).args(["install", "--quiet", "--requirement"]).arg(asked), NO_PACKAGES)?;
    let arguments = format!("build-args=--profile={profile}");
    let mut install = pip(&python);
    install.args(["install", "--no-deps", "--force-reinstall", "--config-settings", &arguments]);
    or_say(install.arg(root()), NO_PACKAGES)?;
    // The compiled part is named so that dependencies have the features that it was built with, and are not compiled again.
    let program_of = ["--bin", "lineament", "--package", "lineament-cli", "--package", "lineament-py"];
    succeed(cargo().args(["build", "--locked", "--profile", profile]).args(program_of))?;
    let mut tests = Command::new(&python);
    tests.args(["-m", "pytest", "--quiet"]).current_dir(root());
    succeed(tests.env("LINEAMENT_PROGRAM", program(profile)))
}

/// The program of a profile.
fn program(profile: &str) -> PathBuf {
    let folder = if matches!(profile, "dev" | "test") { "debug" } else { profile };
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
    target.join(folder).join(if cfg!(windows) { "lineament.exe" } else { "lineament" })
}

/// The interpreter of `out/python`, which is made once.
fn environment() -> Result<PathBuf, String> {
    let venv = root().join("out").join("python");
    let python = venv.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    if !has_pip(&python) {
        let name = if cfg!(windows) { "python" } else { "python3" };
        or_say(Command::new(name).args(["-m", "venv", "--clear"]).arg(&venv), NO_PYTHON)?;
    }
    Ok(python)
}

/// Whether there is an interpreter, and it has pip: one that was made without is of no use.
fn has_pip(python: &Path) -> bool {
    let status = pip(python).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    status.is_ok_and(|status| status.success())
}

fn pip(python: &Path) -> Command {
    let mut pip = Command::new(python);
    pip.args(["-m", "pip", "--disable-pip-version-check"]);
    pip
}

fn or_say(command: &mut Command, advice: &str) -> Result<(), String> {
    succeed(command).map_err(|why| format!("{why}\n{advice}"))
}
