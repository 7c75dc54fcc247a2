//! Sections and slices.

use crate::common::{Sandbox, cube, json};

#[test]
fn sections_of_a_cube_are_closed_and_lie_where_they_were_asked_for() {
    let sandbox = Sandbox::new();
    let args = ["section", "--sample", "cube-15206", "--at=0.1,-0.2", "-o", "a.json", "-o", "a.dxf"];
    sandbox.run(&args).expect(0).says(&["2 slices", "2 contours", "2 closed", "wrote a.json, a.dxf"]);
    let strips = json(&sandbox.path("a.json"))["strips"].clone();
    let heights: Vec<f64> =
        strips.as_array().unwrap().iter().map(|s| s["points"][0][2].as_f64().unwrap()).collect();
    assert!((heights[0] - 0.1).abs() < 1e-9 && (heights[1] + 0.2).abs() < 1e-9, "{heights:?}");
}

#[test]
fn every_is_a_distance_for_sections() {
    let sandbox = Sandbox::new();
    sandbox.run(&["section", "--sample", "cube-15206", "--every", "0.3", "-o", "a.json"]).expect(0);
    let strips = json(&sandbox.path("a.json"))["strips"].clone();
    assert!(strips.as_array().unwrap().len() >= 3);
}

#[test]
fn slices_are_a_picture_each_in_a_folder_that_is_made() {
    let sandbox = Sandbox::new();
    sandbox
        .run(&["slices", "--sample", "cube-15206", "--count", "3", "-o", "out"])
        .expect(0)
        .says(&["3 pictures"]);
    for k in 0..3 {
        assert!(sandbox.read_text(&format!("out/slice_000{k}.svg")).contains("<svg"));
    }
}

#[test]
fn one_bad_file_among_many_leaves_the_sections_of_the_others() {
    let sandbox = Sandbox::new();
    sandbox.write_points("a.xyz", &cube());
    sandbox.write("b.ply", "ply\nnonsense\n");
    sandbox
        .run(&["section", "a.xyz", "b.ply", "-o", "{stem}.json"])
        .expect(1)
        .says(&["1 of 2 inputs failed"]);
    assert_eq!(sandbox.files(), ["a.json", "a.xyz", "b.ply"]);
}

#[test]
fn what_cannot_be_is_refused_with_its_exit_code() {
    let sandbox = Sandbox::new();
    sandbox.write_points("a.xyz", &cube());
    let cases: &[(&[&str], i32)] = &[
        (&["section", "a.xyz"], 2),
        (&["section", "a.xyz", "-o", "a.png"], 2),
        (&["section", "a.xyz", "-o", "a.json", "--axis", "w"], 2),
        (&["section", "a.xyz", "-o", "a.json", "--every", "1", "--count", "3"], 2),
        (&["section", "absent.xyz", "-o", "a.json"], 3),
        (&["section", "a.xyz", "-o", "a.json", "--every", "0"], 4),
        (&["section", "a.xyz", "-o", "absent/a.json"], 5),
    ];
    for (args, code) in cases {
        sandbox.run(args).expect(*code);
        assert_eq!(sandbox.files(), ["a.xyz"], "{args:?}");
    }
}
