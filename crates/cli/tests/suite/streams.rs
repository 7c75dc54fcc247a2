//! Standard input and output as `-`.

use std::process::Stdio;

use crate::common::{Sandbox, cube, table};

#[test]
fn a_cloud_on_standard_input_gives_what_its_file_gives() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox.run(&["extract", "cube.xyz", "-o", "a.obj"]).expect(0);
    sandbox.run_with(&["extract", "-", "-o", "b.obj"], table(&cube()).as_bytes()).expect(0);
    assert_eq!(sandbox.read("a.obj"), sandbox.read("b.obj"));
}

#[test]
fn standard_output_holds_the_result_alone() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let json: serde_json::Value =
        serde_json::from_slice(&sandbox.run(&["extract", "cube.xyz", "-o", "-", "-v"]).expect(0).stdout)
            .unwrap();
    assert_eq!(json["strips"].as_array().unwrap().len(), 12);
    assert!(sandbox.run(&["classify", "cube.xyz", "-o", "-"]).expect(0).stdout.starts_with(b"\x93NUMPY"));
    assert!(sandbox.run(&["render", "cube.xyz", "-o", "-"]).expect(0).stdout.starts_with(b"\x89PNG"));
}

#[test]
fn standard_input_without_outputs_goes_to_standard_output() {
    let sandbox = Sandbox::new();
    let outcome = sandbox.run_with(&["extract", "-"], table(&cube()).as_bytes()).expect(0);
    assert!(outcome.stdout.starts_with(b"{"));
    assert_eq!(sandbox.files(), [""; 0]);
}

#[test]
fn info_reads_standard_input() {
    let sandbox = Sandbox::new();
    assert!(sandbox.run_with(&["info", "-"], b"0 0 0\n1 0 0\n0 1 0\n").expect(0).text().contains("stdin"));
}

#[test]
fn a_reader_that_leaves_early_is_no_error_for_listings() {
    let sandbox = Sandbox::new();
    let mut child = sandbox.command(&["params"]).stdout(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(0));
}
