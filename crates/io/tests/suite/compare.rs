//! Comparisons with other people's programs: `cargo xtask rivals` installs them and runs these tests. By themselves they
//! need `LINEAMENT_PYTHON`, a Python with laspy, lazrs, pye57, plyfile, pypcd4, trimesh, ezdxf, pyvista, pyarrow, pandas,
//! duckdb, fiona and cadquery-ocp, any of which may be missing; for pictures a browser, `LINEAMENT_BROWSER`, and a folder of node modules,
//! `LINEAMENT_NODE`.

use crate::common::{example, shared};
use lineament::{Network, Node, NodeKind};
use lineament_io::write_network;
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
fn points_are_the_same_in_other_programs() {
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
    let outputs = ["dxf", "ply", "glb", "vtp", "geojson", "gpkg", "obj", "svg", "csv"]
        .map(|e| folder.path().join(format!("a.{e}")));
    assert!(Command::new(writer).args(&outputs).status().unwrap().success());
    script("opens.py", &[folder.path()]);
    let node = Node { position: [1.0, 2.0, 3.0], kind: NodeKind::Apex, degree: 0, source: 0, sigma: None };
    let loose = Network { nodes: vec![node], strips: Vec::new() };
    write_network(&folder.path().join("empty.glb"), &[], &loose, &Default::default()).unwrap();
    script("browser.py", &[folder.path()]);
}

#[test]
fn curves_are_those_of_json_in_other_programs() {
    use lineament::section::{Axis, Planes, SectionParams, section};
    use lineament_io::{SectionContext, write_sections};
    let folder = tempfile::tempdir().unwrap();
    let axis = Axis::Vector([1.0, 0.2, 0.3]);
    let params = SectionParams { axis, planes: Planes::Count(5), fit: true, ..SectionParams::default() };
    for name in ["box", "bracket", "stepped-shaft", "pipe-cross"] {
        let cloud = (lineament::shapes::sample(name).unwrap().make)(1).cloud;
        let network = lineament::extract(&cloud, &Default::default()).unwrap().network;
        let sections = section(&cloud, &params).unwrap();
        for extension in ["json", "dxf"] {
            let path = |suffix: &str| folder.path().join(format!("{name}{suffix}.{extension}"));
            write_network(&path(""), &[], &network, &Default::default()).unwrap();
            write_sections(&path(".sections"), &[], &sections, &SectionContext::default()).unwrap();
        }
        write_network(&folder.path().join(format!("{name}.step")), &[], &network, &Default::default())
            .unwrap();
    }
    script("cad.py", &[folder.path()]);
}

#[test]
fn solids_are_closed_shells_of_valid_faces_in_other_programs() {
    use lineament::shapes::{Sampling, Scan, bracket, cube, stepped_shaft};
    use lineament::{Method, Params, params::Auto};
    use lineament_io::{NetworkContext, PointTable, write_patches};
    let folder = tempfile::tempdir().unwrap();
    let mut params = Params { method: Method::Segments, ..Params::default() };
    params.patches.find = Auto::Given(true);
    for (name, shape) in [("cube", cube(10.0)), ("bracket", bracket()), ("shaft", stepped_shaft())] {
        for noise in [0.0, 0.05] {
            let scan = Scan::new(Sampling::Area { count: 60_000 }).noise(noise).seed(1);
            let cloud = shape.sample(&scan).cloud;
            let found = lineament::extract(&cloud, &params).unwrap();
            let classes = vec![0; cloud.len()];
            let table = PointTable { cloud: &cloud, classes: &classes, scores: &[], las: None };
            let context = NetworkContext { patches: found.patches, ..NetworkContext::default() };
            let path = folder.path().join(format!("{name}-{noise}.solid.step"));
            write_patches(&path, &[], &found.network, &context, &table).unwrap();
        }
    }
    script("cad.py", &[folder.path()]);
}

#[test]
fn files_written_in_other_programs_read_as_they_were() {
    let Some(reader) = example("positions") else { return };
    script("foreign.py", &[&reader]);
}

#[test]
fn written_points_open_in_other_programs() {
    use lineament::{Attribute, Cloud, Column};
    use lineament_io::{PointTable, write_points};
    let folder = tempfile::tempdir().unwrap();
    let at = |i: u32| [665_187.25 + f64::from(i) / 64.0, 5_648_349.5 - f64::from(i), f64::from(i % 7) / 8.0];
    let mut cloud = Cloud::new((0..500).map(at).collect());
    cloud.attributes.push(Attribute { name: "intensity".into(), values: Column::U16((0..500).collect()) });
    let classes: Vec<u8> = (0..500u32).map(|i| (i % 4) as u8).collect();
    let table = PointTable { cloud: &cloud, classes: &classes, scores: &[0.5; 500], las: None };
    for extension in ["las", "laz", "ply", "pcd", "npz", "parquet", "csv", "npy"] {
        write_points(&folder.path().join(format!("points.{extension}")), &[], &table).unwrap();
    }
    let bytes: Vec<u8> = cloud.positions.iter().flatten().flat_map(|c| c.to_le_bytes()).collect();
    std::fs::write(folder.path().join("points.f64"), bytes).unwrap();
    script("opens.py", &[folder.path()]);
}
