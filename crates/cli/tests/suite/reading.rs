//! What of a file is read.

use crate::common::{Sandbox, cube, json, table};

fn points_read(sandbox: &Sandbox, args: &[&str]) -> usize {
    let outcome = sandbox.run(&[["classify", "cube.xyz", "-o", "a.npy"].as_slice(), args].concat()).expect(0);
    let said = outcome.stderr.split(": ").nth(1).unwrap().split(' ').next().unwrap().to_string();
    let rows = sandbox.read("a.npy").len() - 128;
    assert_eq!(said, rows.to_string(), "one row a point that was read");
    rows
}

#[test]
fn every_n_th_point_is_read() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    assert_eq!(points_read(&sandbox, &["--every", "2"]), 193);
    assert_eq!(points_read(&sandbox, &["--every", "1"]), 386);
}

#[test]
fn points_inside_the_bounds_are_read() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let half = cube().iter().filter(|p| p[0] <= 0.0).count();
    assert_eq!(points_read(&sandbox, &["--bounds", "-9,-9,-9,0,9,9"]), half);
}

#[test]
fn one_point_of_every_voxel_is_read() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let count = points_read(&sandbox, &["--voxel", "0.25"]);
    assert!((60..200).contains(&count), "{count}");
}

#[test]
fn bounds_that_hold_no_point_are_refused_and_say_so() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox
        .run(&["extract", "cube.xyz", "--bounds", "50,50,50,60,60,60"])
        .expect(3)
        .says(&["none of 386 points", "bounds [50.0"]);
    assert_eq!(sandbox.files(), ["cube.xyz"]);
}

#[test]
fn an_input_can_be_taken_for_a_format_that_it_is_not_named_after() {
    let sandbox = Sandbox::new();
    sandbox.write("cube.ply", table(&cube()));
    sandbox.run(&["extract", "cube.ply", "-o", "a.json", "--input-format", "xyz"]).expect(0);
    assert_eq!(json(&sandbox.path("a.json"))["input"]["points"], 386);
}

#[test]
fn values_that_make_no_sense_are_2() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let cases: &[&[&str]] = &[
        &["--every", "0"],
        &["--voxel", "-1"],
        &["--bounds", "1,2,3"],
        &["--scan", "0"],
        &["--memory", "much"],
        &["--input-format", "docx"],
    ];
    for args in cases {
        sandbox.run(&[["extract", "cube.xyz"].as_slice(), args].concat()).expect(2);
    }
}

#[test]
fn drawings_are_seen_from_the_view_asked_for() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    for (view, name) in [("top", "a.svg"), ("iso", "b.svg"), ("0,0,2", "c.svg")] {
        sandbox.run(&["extract", "cube.xyz", "-o", name, "--view", view]).expect(0);
    }
    assert_eq!(sandbox.read("a.svg"), sandbox.read("c.svg"));
    assert_ne!(sandbox.read("a.svg"), sandbox.read("b.svg"));
}
