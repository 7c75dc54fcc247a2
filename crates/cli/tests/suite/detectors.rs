//! `classify --detector` and `--scores`.

use crate::common::{Sandbox, cube};

const DETECTORS: [&str; 6] = [
    "projection",
    "surface-variation",
    "mean-curvature",
    "normal-difference",
    "multiscale-variation",
    "persistence",
];

fn with_cube() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox
}

fn marked(sandbox: &Sandbox, name: &str) -> usize {
    let npy = sandbox.read(name);
    npy[npy.len() - 386..].iter().filter(|&&class| class != 0).count()
}

#[test]
fn projection_marks_the_cubes_92_as_a_detector_and_as_a_method() {
    let sandbox = with_cube();
    sandbox.run(&["classify", "cube.xyz", "-o", "a.npy", "--detector", "projection"]).expect(0).says(&[
        "386 points read",
        "294 smooth points",
        "92 crease points",
    ]);
    sandbox.run(&["classify", "cube.xyz", "-o", "b.npy", "--method", "projection"]).expect(0);
    assert_eq!(marked(&sandbox, "a.npy"), 92);
    assert_eq!(sandbox.read("a.npy"), sandbox.read("b.npy"));
}

#[test]
fn every_detector_has_its_own_marks() {
    let sandbox = with_cube();
    for name in DETECTORS {
        sandbox.run(&["classify", "cube.xyz", "-o", "a.npy", "--detector", name]).expect(0);
        assert!((92..=260).contains(&marked(&sandbox, "a.npy")), "{name}");
    }
}

#[test]
fn scores_writes_every_measure_as_an_attribute() {
    let sandbox = with_cube();
    for method in [["--detector", "persistence"], ["--method", "penalty"]] {
        let args = [&["classify", "cube.xyz", "-o", "a.ply", "--scores"], method.as_slice()].concat();
        sandbox.run(&args).expect(0);
        let header = String::from_utf8_lossy(&sandbox.read("a.ply")[..700]).into_owned();
        for name in DETECTORS {
            assert!(header.contains(&format!("property float {}\n", name.replace('-', "_"))), "{header}");
        }
    }
}

#[test]
fn scores_go_into_every_format_that_has_attributes() {
    let sandbox = with_cube();
    let formats = ["las", "pcd", "csv", "xyz"];
    let outputs = formats.map(|f| format!("a.{f}"));
    let outputs = outputs.iter().flat_map(|o| ["-o", o.as_str()]);
    let args: Vec<&str> = ["classify", "cube.xyz", "--scores"].into_iter().chain(outputs).collect();
    sandbox.run(&args).expect(0);
    for format in formats {
        let bytes = sandbox.read(&format!("a.{format}"));
        let head = String::from_utf8_lossy(&bytes[..bytes.len().min(4000)]).into_owned();
        for name in DETECTORS {
            assert!(head.contains(&name.replace('-', "_")), "{format}: {name}");
        }
    }
}

#[test]
fn what_cannot_be_is_refused_before_anything_is_read() {
    let sandbox = with_cube();
    for args in [
        ["--detector", "no-such-detector", "-o", "a.npy"].as_slice(),
        &["--detector", "projection", "--method", "penalty", "-o", "a.npy"],
        &["--scores", "-o", "a.npy"],
    ] {
        let outcome = sandbox.run(&[&["classify", "cube.xyz"], args].concat()).expect(2);
        assert!(!outcome.stderr.is_empty(), "{args:?}");
    }
    let outcome = sandbox.run(&["classify", "cube.xyz", "-o", "a.npy", "--detector", "none"]).expect(2);
    assert!(outcome.stderr.contains("surface-variation"), "{}", outcome.stderr);
    assert_eq!(sandbox.files(), ["cube.xyz"]);
}
