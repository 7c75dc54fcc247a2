//! `evaluate`: tables, files, and what is refused.

use crate::common::{Sandbox, json};

/// A sandbox with the lines of a box in `box.json`.
fn with_lines() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.run(&["extract", "--sample", "box", "-o", "box.json", "-o", "box.dxf"]).expect(0);
    sandbox
}

#[test]
fn a_result_against_itself_has_no_error() {
    let sandbox = with_lines();
    let args = ["evaluate", "box.json", "--truth", "box.json", "--tolerance", "1e-9"];
    let args = [&args[..], &["-o", "s.json", "-o", "s.png", "-o", "s.svg"]].concat();
    let ran = sandbox.run(&args).expect(0).says(&["wrote s.json, s.png, s.svg"]);
    let table = ran.text();
    for part in [
        "1.0000     1.0000     1.0000",
        "missed: in the truth alone: nothing",
        "false: in the result alone: nothing",
    ] {
        assert!(table.contains(part), "{part} in\n{table}");
    }
    let score = json(&sandbox.path("s.json"));
    assert_eq!(score["schema"], "lineament-evaluation/1");
    assert_eq!([&score["at"][2]["f1"], &score["chamfer"]["hd"], &score["types"]["right"]], [1.0, 0.0, 1.0]);
    assert_eq!(score["curves_found"][0], score["curves_found"][1]);
    assert_eq!(score["topology"]["result"], score["topology"]["truth"]);
    assert!(sandbox.read("s.png").starts_with(b"\x89PNG"));
    let drawing = sandbox.read_text("s.svg");
    assert!(drawing.contains("<g id=\"missed\"") && drawing.matches("<path").count() == 12, "{drawing}");
}

#[test]
fn two_runs_are_told_apart_by_their_lines_and_parameters() {
    let sandbox = with_lines();
    sandbox.run(&["extract", "--sample", "box", "-o", "all.json", "--set", "penalty.fold_deg=24"]).expect(0);
    let text = sandbox.read_text("all.json");
    let mut fewer: serde_json::Value = serde_json::from_str(&text).unwrap();
    let gone = fewer["strips"].as_array_mut().unwrap().remove(0);
    sandbox.write("fewer.json", fewer.to_string());
    let args = ["evaluate", "fewer.json", "--truth", "box.json", "-o", "s.json"];
    let table = sandbox.run(&args).expect(0).text();
    assert!(table.contains("penalty.fold_deg: 24.0, in the truth "), "{table}");
    assert!(table.contains("whole curves found             11 of 12"), "{table}");
    let score = json(&sandbox.path("s.json"));
    let missed = score["missed"].as_array().unwrap();
    assert_eq!(missed.len(), 1);
    let share = missed[0]["length"].as_f64().unwrap() / gone["length"].as_f64().unwrap();
    assert!((0.8..=1.0).contains(&share), "{share}");
    assert_eq!(score["false"].as_array().unwrap().len(), 0);
}

#[test]
fn a_drawing_is_a_truth_once_the_spacing_is_known() {
    let sandbox = with_lines();
    sandbox.run(&["evaluate", "box.dxf", "--truth", "box.dxf"]).expect(2).says(&["--spacing", "--points"]);
    let table =
        sandbox.run(&["evaluate", "box.dxf", "--truth", "box.dxf", "--spacing", "0.05"]).expect(0).text();
    assert!(table.contains("spacing 0.05000 (--spacing)") && table.contains("12 of 12"), "{table}");
    sandbox.run(&["evaluate", "box.json", "--truth", "box.dxf"]).expect(0);
}

#[test]
fn marks_and_lines_are_scored_by_labels() {
    let sandbox = Sandbox::new();
    sandbox.write("marks.txt", "1\n0\n1\n0\n");
    sandbox.write("labels.u8", [1, 0, 2, 3]);
    let table = sandbox
        .run(&["evaluate", "marks.txt", "--labels", "labels.u8", "-o", "m.json"])
        .expect(0)
        .says(&["wrote m.json"])
        .text();
    assert!(table.contains("label 1 and 2, without 3         1.0000     1.0000     1.0000"), "{table}");
    assert_eq!(json(&sandbox.path("m.json"))["points"][0]["precision"], 0.5);
    sandbox.write("short.u8", [1, 0]);
    sandbox.run(&["evaluate", "marks.txt", "--labels", "short.u8"]).expect(3).says(&["4 marks for 2 labels"]);
    // The points of a line are those that its label says.
    sandbox.write("line.obj", "v 0 0 0\nv 3 0 0\nl 1 2\n");
    sandbox.write_points("points.xyz", &[[0.0, 0.0, 0.0], [1.0, 0.1, 0.0], [2.0, 9.0, 0.0], [3.0, 0.0, 5.0]]);
    sandbox.write("labels.u8", [1, 1, 0, 3]);
    let args = [
        "evaluate",
        "line.obj",
        "--truth",
        "line.obj",
        "--points",
        "points.xyz",
        "--labels",
        "labels.u8",
        "--spacing",
        "1",
    ];
    assert!(sandbox.run(&args).expect(0).text().contains("label 1, without 3               1.0000"));
}

#[test]
fn classes_of_points_are_marks_in_every_format() {
    let sandbox = Sandbox::new();
    let names = ["m.npy", "m.npz", "m.ply", "m.csv", "m.las"];
    let outputs: Vec<&str> = names.iter().flat_map(|name| ["-o", name]).collect();
    sandbox.run(&[&["classify", "--sample", "cube-386"], &outputs[..]].concat()).expect(0);
    let tables = names.map(|name| sandbox.run(&["evaluate", name, "--labels", "m.npy"]).expect(0).text());
    assert!(tables[0].contains("1.0000     1.0000     1.0000"), "{}", tables[0]);
    assert!(tables.iter().all(|table| *table == tables[0]));
    let advice = ["marks of points", "--labels FILE in place of --truth"];
    sandbox.run(&["evaluate", "m.npy", "--truth", "m.npy"]).expect(3).says(&advice);
    sandbox.write("no.csv", "x,y,z,w\n1,2,3,4\n");
    sandbox.run(&["evaluate", "no.csv", "--labels", "m.npy"]).expect(3).says(&["`class`", "`w`", ".npy"]);
}

#[test]
fn a_result_scores_the_same_in_every_format_of_lines() {
    let sandbox = Sandbox::new();
    let names = ["a.json", "a.dxf", "a.step"];
    let outputs: Vec<&str> = names.iter().flat_map(|name| ["-o", name]).collect();
    sandbox.run(&[&["extract", "--sample", "bracket"], &outputs[..]].concat()).expect(0);
    let whole: serde_json::Value = json(&sandbox.path("a.json"));
    // Without the straight lines, the circles alone are known, and the share of their length is the precision.
    let mut round = whole.clone();
    let straight =
        |strip: &serde_json::Value| strip["curves"].as_array().unwrap().iter().all(|c| c["type"] == "line");
    round["strips"].as_array_mut().unwrap().retain(|strip| !straight(strip));
    sandbox.write("round.json", round.to_string());
    let wide = format!("{}", 2.0 * whole["spacing"].as_f64().unwrap());
    let precision = names.map(|name| {
        // Where arcs are written in far shorter pieces than are counted.
        let args = ["evaluate", name, "--truth", "round.json", "--spacing", &wide, "-o", "s.json"];
        sandbox.run(&args).expect(0);
        json(&sandbox.path("s.json"))["at"][0]["precision"].as_f64().unwrap()
    });
    assert!(precision[0] > 0.1 && precision[0] < 0.7, "{precision:?}");
    assert!(precision.iter().all(|p| (p - precision[0]).abs() < 0.02), "{precision:?}");
}

#[test]
fn what_cannot_be_scored_is_refused() {
    let sandbox = with_lines();
    sandbox.write_points("points.xyz", &[[0.0; 3], [1.0, 0.0, 0.0]]);
    for (args, code, part) in [
        (&["box.json"][..], 2, "--truth"),
        (&["box.json", "--truth", "box.dxf", "-o", "a.pdf"], 2, "a.pdf"),
        (&["box.json", "--truth", "box.dxf", "-o", "box.json"], 5, "box.json"),
        (&["points.xyz", "--truth", "box.dxf"], 3, "without faces"),
        (&["box.json", "--truth", "absent.json"], 3, "absent.json"),
        (&["box.json", "--truth", "box.dxf", "--spacing", "1e-12"], 4, "spacing"),
        (&["box.json", "--truth", "box.dxf", "--view", "up"], 2, "view"),
    ] {
        sandbox.run(&[&["evaluate"], args].concat()).expect(code).says(&[part]);
    }
}
