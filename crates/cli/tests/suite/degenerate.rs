//! Clouds that are hardly one: a valid result or a named refusal, soon.

use std::time::Duration;

use crate::common::{Outcome, Sandbox, cube, json};

const SOON: Duration = Duration::from_secs(5);

fn scaled(factor: f64, offset: f64) -> Vec<[f64; 3]> {
    cube().iter().map(|p| p.map(|x| x * factor + offset)).collect()
}

fn extract(sandbox: &Sandbox, points: &[[f64; 3]]) -> Outcome {
    sandbox.write_points("cloud.xyz", points);
    let outcome = sandbox.run(&["extract", "cloud.xyz", "-o", "a.json"]);
    assert!(outcome.took < SOON, "{:?}", outcome.took);
    outcome
}

#[test]
fn clouds_without_a_surface_are_refused_by_name_and_leave_no_file() {
    let line = |n: i32| (0..n).map(|i| [f64::from(i) * 0.1, 2.0, 3.0]).collect::<Vec<_>>();
    let slanted = (0..500).map(|i| [f64::from(i), f64::from(i) * 2.0, f64::from(i) * 3.0]).collect();
    let nans = vec![[f64::NAN, 0.0, 1.0]; 50];
    let cases: Vec<(&str, Vec<[f64; 3]>)> = vec![
        ("one point", line(1)),
        ("two points", line(2)),
        ("three points", vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
        ("coincident", vec![[3.0, 4.0, 5.0]; 1000]),
        ("two places", [vec![[0.0; 3]; 500], vec![[1.0; 3]; 500]].concat()),
        ("collinear", line(500)),
        ("collinear, slanted", slanted),
        ("not finite", nans),
    ];
    for (name, points) in cases {
        let sandbox = Sandbox::new();
        let outcome = extract(&sandbox, &points);
        assert_eq!(outcome.code, Some(4), "{name}: {}", outcome.stderr);
        assert!(outcome.stderr.contains("distinct"), "{name}: {}", outcome.stderr);
        assert_eq!(sandbox.files(), ["cloud.xyz"], "{name}");
    }
}

#[test]
fn no_points_at_all_are_refused() {
    let sandbox = Sandbox::new();
    sandbox.write("cloud.ply", "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n");
    let code = sandbox.run(&["extract", "cloud.ply"]).code;
    assert!(matches!(code, Some(3 | 4)), "{code:?}");
    assert_eq!(sandbox.files(), ["cloud.ply"]);
}

#[test]
fn a_plane_has_a_border_and_no_crease() {
    let sandbox = Sandbox::new();
    let plane: Vec<[f64; 3]> = (0..900).map(|i| [f64::from(i % 30), f64::from(i / 30), 0.0]).collect();
    extract(&sandbox, &plane).expect(0);
    let strips = json(&sandbox.path("a.json"))["strips"].as_array().unwrap().clone();
    assert!(strips.iter().all(|strip| strip["kind"] == "border"), "{strips:?}");
    assert!(!strips.is_empty());
}

#[test]
fn rows_that_are_not_finite_change_nothing_but_their_count() {
    let sandbox = Sandbox::new();
    let mut points = cube();
    for i in [0, 100, 387] {
        points.insert(i, [1.0, f64::NAN, f64::INFINITY]);
    }
    extract(&sandbox, &points).expect(0).says(&["3 not finite", "12 creases", "8 junctions"]);
}

/// Grids write 1.70141e38, and others 1e30, where they have no value.
#[test]
fn numbers_that_stand_for_no_value_leave_the_lines_of_the_others() {
    let sandbox = Sandbox::new();
    for none in [1e30, 1.70141e38] {
        let mut points = cube();
        points.push([none; 3]);
        extract(&sandbox, &points).expect(0).says(&["12 creases", "0 borders, 8 junctions"]);
    }
    for none in [[-3.4e38; 3], [0.5, 0.5, -f64::MAX]] {
        let points = [vec![none; 9], cube()].concat();
        let said = ["9 of the points hold numbers that stand for no value", "12 creases", "8 junctions"];
        extract(&sandbox, &points).expect(0).says(&said);
    }
}

#[test]
fn scale_and_offset_leave_the_cube_a_cube() {
    for (factor, offset) in [(1e-9, 0.0), (1e9, 0.0), (1.0, 1e7), (1e-3, -1e4), (1e9, 1e9)] {
        let sandbox = Sandbox::new();
        extract(&sandbox, &scaled(factor, offset)).expect(0).says(&["12 creases", "8 junctions"]);
    }
}

#[test]
fn few_points_on_a_surface_give_a_result_or_a_refusal() {
    for count in 4..40 {
        let sandbox = Sandbox::new();
        let outcome = extract(&sandbox, &cube()[..count]);
        assert!(matches!(outcome.code, Some(0 | 4)), "{count}: {}", outcome.stderr);
    }
}

#[test]
fn points_alone_can_always_be_drawn_and_described() {
    let line: Vec<[f64; 3]> = (0..50).map(|i| [f64::from(i), 0.0, 0.0]).collect();
    for points in [&line[..1], &line[..2], &line[..], &[[1e9, 2.0, 3.0]; 40]] {
        let sandbox = Sandbox::new();
        sandbox.write_points("cloud.xyz", points);
        sandbox.run(&["render", "cloud.xyz", "-o", "a.png", "--network", "none"]).expect(0);
        sandbox.run(&["info", "cloud.xyz"]).expect(0);
    }
}
