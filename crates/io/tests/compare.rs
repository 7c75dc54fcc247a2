//! Comparisons with other people's programs, where they are installed: set `LINEAMENT_PYTHON` to a Python that has laspy,
//! lazrs, pye57, plyfile, trimesh, ezdxf, pyvista and fiona (any of them may be missing).

mod common;
use common::{example, shared};
use std::path::Path;
use std::process::Command;

/// Runs a script of this folder; the test fails if the script says that something differs.
fn script(name: &str, arguments: &[&Path]) {
    let Some(python) = std::env::var_os("LINEAMENT_PYTHON") else {
        return println!("skipped: LINEAMENT_PYTHON names no Python");
    };
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(name);
    let run = Command::new(python).arg(script).args(arguments).output().unwrap();
    println!("{}", String::from_utf8_lossy(&run.stdout));
    assert!(
        run.status.success(),
        "{}{}",
        String::from_utf8_lossy(&run.stdout),
        String::from_utf8_lossy(&run.stderr)
    );
}

#[test]
fn points_are_those_that_other_readers_read() {
    let Some(reader) = example("positions") else { return };
    let mut files = Vec::new();
    for folder in ["formats", "scans", "models"] {
        let Some(folder) = shared(folder) else { return };
        files.extend(std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()));
    }
    files.retain(|path| path.extension().is_none_or(|extension| extension != "json"));
    files.sort();
    let arguments: Vec<&Path> =
        [reader.as_path()].into_iter().chain(files.iter().map(|path| path.as_path())).collect();
    script("compare.py", &arguments);
}

#[test]
fn written_networks_open_in_other_programs() {
    let Some(writer) = example("network") else { return };
    let folder = tempfile::tempdir().unwrap();
    let outputs =
        ["dxf", "ply", "glb", "vtp", "geojson", "obj", "svg"].map(|e| folder.path().join(format!("a.{e}")));
    assert!(Command::new(writer).args(&outputs).status().unwrap().success());
    script("opens.py", &[folder.path()]);
}
