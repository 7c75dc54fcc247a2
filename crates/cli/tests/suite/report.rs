//! HTML reports of every command that writes them.

use crate::common::{Sandbox, cube};
use serde_json::Value;

/// The data of a report.
fn data(sandbox: &Sandbox, name: &str) -> Value {
    let page = sandbox.read_text(name);
    assert!(page.starts_with("<!doctype html>") && page.ends_with("</html>\n") && page.len() < 15_000_000);
    let (_, rest) = page.split_once("id=\"data\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn report_writes_lines_patches_and_slices_beside_the_input() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox
        .run(&["report", "cube.xyz", "--slices", "7", "--axis", "z"])
        .expect(0)
        .says(&["12 creases", "wrote cube.html"]);
    let data = data(&sandbox, "cube.html");
    assert_eq!(data["input"]["name"], "cube.xyz");
    assert_eq!(data["input"]["sha256"].as_str().unwrap().len(), 64);
    let count = |member: &str| data[member].as_array().unwrap().len();
    assert_eq!([count("strips"), count("nodes"), count("patches")], [12, 8, 6]);
    assert_eq!(data["sections"]["planes"].as_array().unwrap().len(), 7);
    assert_eq!(data["points"]["count"], 386);
    assert!(data["points"]["labels"].is_string() && data["points"]["classes"].is_string());
}

#[test]
fn a_report_has_the_axis_up_that_is_asked_for() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    for (args, up) in [(&[][..], [0.0, 0.0, 1.0]), (&["--up", "y"], [0.0, 1.0, 0.0])] {
        sandbox.run(&[&["report", "cube.xyz"], args].concat()).expect(0);
        assert_eq!(data(&sandbox, "cube.html")["up"], serde_json::json!(up));
    }
    sandbox.run(&["report", "cube.xyz", "--up", "w"]).expect(2);
}

#[test]
fn every_command_of_results_writes_reports() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    for (command, member) in [
        ("extract", "strips"),
        ("patches", "patches"),
        ("classify", "strips"),
        ("section", "sections"),
        ("clean", "points"),
    ] {
        let name = format!("{command}.html");
        sandbox.run(&[command, "cube.xyz", "-o", &name]).expect(0);
        let data = data(&sandbox, &name);
        assert_eq!(data["input"]["name"], "cube.xyz", "{command}");
        assert!(!data[member].is_null(), "{command}");
        assert_eq!(data["points"]["count"], 386, "{command}");
    }
}

#[test]
fn a_report_has_the_lines_that_were_chosen() {
    let sandbox = Sandbox::new();
    sandbox
        .run(&["extract", "--sample", "bracket", "-o", "a.html", "-o", "a.csv", "--min-length", "3"])
        .expect(0);
    let strips = data(&sandbox, "a.html")["strips"].as_array().unwrap().len();
    let csv = sandbox.read_text("a.csv");
    let last = csv.lines().last().unwrap().split(',').next().unwrap().parse::<usize>().unwrap();
    assert_eq!(strips, last + 1);
    assert!(strips < 20, "{strips} of 23 lines");
}

#[test]
fn report_refuses_other_formats_and_an_axis_without_slices() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox.run(&["report", "cube.xyz", "-o", "a.pdf"]).expect(2).says(&["a.pdf", ".html"]);
    sandbox.run(&["report", "cube.xyz", "--axis", "z"]).expect(2).says(&["--slices"]);
    assert_eq!(sandbox.files(), ["cube.xyz"]);
}

#[test]
fn a_report_on_standard_output_is_a_page() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let page = sandbox.run(&["report", "cube.xyz", "-o", "-"]).expect(0).text();
    assert!(page.starts_with("<!doctype html>"));
}
