//! Lines chosen by their length and certainty.

use crate::common::{Sandbox, cube, json};

#[test]
fn lines_can_be_chosen_by_length_and_certainty() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let count = |args: &[&str]| {
        sandbox.run(&[&["extract", "cube.xyz", "-o", "a.json"], args].concat()).expect(0);
        let root = json(&sandbox.path("a.json"));
        ["strips", "nodes"].map(|list| root[list].as_array().unwrap().len())
    };
    let length = json(&{
        count(&[]);
        sandbox.path("a.json")
    })["strips"][0]["length"]
        .as_f64()
        .unwrap();
    assert_eq!(count(&[]), [12, 8]);
    assert_eq!(count(&["--min-length", &format!("{}", 0.9 * length), "--min-confidence", "0"]), [12, 8]);
    assert_eq!(count(&["--min-length", &format!("{}", 2.0 * length)]), [0, 0]);
    sandbox.run(&["extract", "cube.xyz", "--min-confidence", "2"]).expect(2);
}

#[test]
fn the_summary_counts_the_lines_that_are_written() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let args = ["extract", "cube.xyz", "-o", "a.json", "--min-length", "1e9"];
    let said = sandbox.run(&args).expect(0).stderr;
    assert!(said.contains("0 creases, 0 borders, 0 junctions"), "{said}");
    assert!(said.contains("12 lines of 12 left out") && !said.contains("no line:"), "{said}");
    assert!(!said.contains("12 creases") && !said.contains("relations:"), "{said}");
}

#[test]
fn lines_less_certain_than_asked_are_left_out() {
    let sandbox = Sandbox::new();
    let confidences = |args: &[&str]| {
        sandbox.run(&[&["extract", "--sample", "bracket", "-o", "a.json"], args].concat()).expect(0);
        let root = json(&sandbox.path("a.json"));
        let mut all: Vec<f64> = root["strips"]
            .as_array()
            .unwrap()
            .iter()
            .map(|strip| strip["confidence"].as_f64().unwrap())
            .collect();
        all.sort_by(f64::total_cmp);
        all
    };
    let all = confidences(&[]);
    let middle = all[all.len() / 2];
    assert!(all[0] < middle);
    assert_eq!(
        confidences(&["--min-confidence", &middle.to_string()]),
        all.iter().copied().filter(|&c| c >= middle).collect::<Vec<_>>()
    );
}

#[test]
fn borders_around_small_holes_are_left_out_and_counted() {
    let sandbox = Sandbox::new();
    let mut points = Vec::new();
    for k in 0..2500 {
        let p = [f64::from(k % 50), f64::from(k / 50), 0.0];
        if (p[0] - 25.0).hypot(p[1] - 22.0) > 7.0 {
            points.push(p);
        }
    }
    sandbox.write_points("sheet.xyz", &points);
    let strips = |args: &[&str]| {
        let run = sandbox.run(&[&["extract", "sheet.xyz", "-o", "a.json"], args].concat()).expect(0);
        (json(&sandbox.path("a.json"))["strips"].as_array().unwrap().len(), run.stderr)
    };
    assert_eq!(strips(&["--min-hole", "30"]).0, 5);
    let (left, said) = strips(&["--min-hole", "70"]);
    assert_eq!(left, 4);
    assert!(said.contains("1 line of 5 left out: borders around small holes"), "{said}");
}
