//! Outputs for CAD: their unit, and patches as faces.

use crate::common::{Sandbox, cube};

#[test]
fn files_for_cad_state_the_unit_and_step_warns_where_none_is_told() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let args = ["extract", "cube.xyz", "-o", "a.dxf", "-o", "a.step"];
    sandbox.run(&args).expect(0).says(&["a.step states millimetres, as none is known: --unit tells it"]);
    assert!(sandbox.read_text("a.dxf").contains("$INSUNITS\n70\n0\n"));
    let told = sandbox.run(&[args.as_slice(), &["--unit", "in", "--step-protocol", "ap214"]].concat());
    assert!(!told.expect(0).stderr.contains("warning"));
    assert!(sandbox.read_text("a.dxf").contains("$INSUNITS\n70\n1\n"));
    let step = sandbox.read_text("a.step");
    assert!(step.contains("'INCH'") && step.contains("AUTOMOTIVE_DESIGN"));
    let mile = ["extract", "cube.xyz", "-o", "a.dxf", "--unit", "mile"];
    sandbox.run(&mile).expect(2).says(&["the units are mm, cm, m, in, ft"]);
    let section = ["section", "cube.xyz", "--count", "2", "-o", "b.dxf", "--unit", "ft"];
    sandbox.run(&section).expect(0);
    assert!(sandbox.read_text("b.dxf").contains("$INSUNITS\n70\n2\n"));
}

#[test]
fn patches_are_sewn_to_a_solid_and_those_that_are_no_face_are_named() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let args = ["patches", "cube.xyz", "-o", "a.stp", "--unit", "mm"];
    sandbox.run(&args).expect(0).says(&["STEP: 6 faces in 1 shell, 1 closed; gaps up to "]);
    assert_eq!(sandbox.read_text("a.stp").matches("ADVANCED_FACE(").count(), 6);
    let pipes = ["patches", "--sample", "equal-cylinders", "-o", "b.step", "--unit", "mm"];
    sandbox.run(&pipes).expect(0).says(&["left out: 0 (free-form)"]);
}
