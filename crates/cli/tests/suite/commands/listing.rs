//! `--report`: the list of holes and straight edges, and the summary's words about them.

use crate::common::Sandbox;

/// The cells of a row of CSV by the names of its head.
fn cell(text: &str, row: usize, name: &str) -> String {
    let mut lines = text.lines();
    let column = lines.next().unwrap().split(',').position(|head| head == name).unwrap();
    lines.nth(row).unwrap().split(',').nth(column).unwrap().to_string()
}

#[test]
fn the_hole_and_the_boss_of_the_bracket_are_listed_with_tolerances() {
    let sandbox = Sandbox::new();
    let args = ["extract", "--sample", "bracket", "-o", "a.json"];
    let run = sandbox.run(&[&args[..], &["--report", "list.csv"]].concat()).expect(0);
    let run = run.says(&[
        "hole of diameter 1.80",
        ", 1.200 deep, at ",
        "boss of diameter 1.60",
        "wrote a.json, list.csv",
    ]);
    assert!(run.stderr.contains(" ± 0.00"), "{}", run.stderr);
    let text = sandbox.read_text("list.csv");
    for (row, name, diameter, length) in [(0, "hole", 1.8, 1.2), (1, "boss", 1.6, 1.0)] {
        let number = |column: &str| cell(&text, row, column).parse::<f64>().unwrap();
        assert_eq!(cell(&text, row, "feature"), name);
        let tolerance = number("u95_diameter");
        assert!(
            (0.001..0.01).contains(&tolerance) && (number("diameter") - diameter).abs() < 2.0 * tolerance,
            "{text}"
        );
        assert!((number("length") - length).abs() < 0.02, "{text}");
        assert_eq!(cell(&text, row, "strips").split(' ').count(), 2);
    }
    let edges = text.lines().filter(|l| l.starts_with("straight crease")).count();
    assert!(edges >= 18, "{text}");
    let cells = text.lines().map(|l| l.split(',').count());
    assert!(cells.clone().all(|n| n == cells.clone().next().unwrap()));
    let text = sandbox.run(&[&args[..], &["--report", "-"]].concat()).expect(0).text();
    for part in ["holes and bosses: 2", "straight edges: ", "tolerances are those of 95 %"] {
        assert!(text.contains(part), "{text}");
    }
}

#[test]
fn lists_without_a_form_or_a_place_are_refused() {
    let sandbox = Sandbox::new();
    let args = ["extract", "--sample", "box", "-o", "a.csv"];
    sandbox.write("no", "a file");
    for (list, code, part) in
        [("a.pdf", 2, ".txt, .csv"), ("a.csv", 2, "--report"), ("no/a.csv", 5, "no folder")]
    {
        sandbox.run(&[&args[..], &["--report", list]].concat()).expect(code).says(&[part]);
    }
    sandbox.write_points("p.xyz", &[[0.0; 3]]);
    sandbox.write_points("q.xyz", &[[0.0; 3]]);
    sandbox
        .run(&["extract", "p.xyz", "q.xyz", "-o", "{stem}.json", "--report", "l.txt"])
        .expect(2)
        .says(&["{stem}"]);
}
