//! The program among odd surroundings: without standard error, beside leftovers, over limits, given names that are no commands.

use crate::common::Sandbox;
use std::process::Stdio;
use std::time::{Duration, Instant};

/// A sheet of 20 by 20 points, slightly bent.
fn sheet() -> Vec<[f64; 3]> {
    (0..400).map(|i| (f64::from(i % 20), f64::from(i / 20))).map(|(x, y)| [x, y, 0.01 * x * x]).collect()
}

#[cfg(target_os = "linux")]
#[test]
fn an_error_needs_no_standard_error() {
    let sandbox = Sandbox::new();
    sandbox.write_points("good.xyz", &sheet());
    let full = || Stdio::from(std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap());
    let code = |args: &[&str]| sandbox.command(args).stderr(full()).status().unwrap().code();
    assert_eq!(code(&["info", "none.xyz"]), Some(3));
    assert_eq!(code(&["extract", "none.xyz", "good.xyz"]), Some(1));
    assert!(sandbox.path("good.lines.json").exists());
}

#[cfg(unix)]
#[test]
fn a_replaced_file_keeps_its_permissions_and_a_link_its_place() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let sandbox = Sandbox::new();
    sandbox.write_points("good.xyz", &sheet());
    sandbox.write("private.json", "old");
    std::fs::set_permissions(sandbox.path("private.json"), PermissionsExt::from_mode(0o600)).unwrap();
    symlink("there.json", sandbox.path("link.json")).unwrap();
    sandbox.run(&["extract", "good.xyz", "-o", "private.json", "-o", "link.json"]).expect(0);
    let mode = std::fs::metadata(sandbox.path("private.json")).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o600);
    assert!(std::fs::symlink_metadata(sandbox.path("link.json")).unwrap().file_type().is_symlink());
    assert_eq!(sandbox.read("there.json"), sandbox.read("private.json"));
}

#[test]
fn leftovers_of_ended_processes_are_cleared_and_their_names_taken() {
    let sandbox = Sandbox::new();
    sandbox.write_points("good.xyz", &sheet());
    for number in 0..3 {
        sandbox.write(&format!(".out.json.1-{number}.part"), "cut");
    }
    sandbox.write(".out.json.other.part", "of another program");
    sandbox.run(&["extract", "good.xyz", "-o", "out.json"]).expect(0);
    assert_eq!(sandbox.files(), [".out.json.other.part", "good.xyz", "out.json"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_limit_on_file_sizes_is_an_error_of_the_output() {
    let sandbox = Sandbox::new();
    sandbox.write_points("good.xyz", &sheet());
    let script =
        format!("ulimit -f 1; exec {} classify good.xyz -o out.ply", env!("CARGO_BIN_EXE_lineament"));
    let run = std::process::Command::new("sh")
        .arg("-c")
        .arg(script)
        .current_dir(sandbox.path(""))
        .output()
        .unwrap();
    assert_eq!(run.status.code(), Some(5), "{run:?}");
    assert!(String::from_utf8_lossy(&run.stderr).contains("cannot write `out.ply`"), "{run:?}");
    assert_eq!(sandbox.files(), ["good.xyz"]);
}

#[cfg(target_os = "linux")]
#[test]
fn an_interrupt_ends_a_run_that_waits_for_the_reader_of_a_pipe() {
    let sandbox = Sandbox::new();
    sandbox.write_points("good.xyz", &sheet());
    assert!(std::process::Command::new("mkfifo").arg(sandbox.path("pipe.json")).status().unwrap().success());
    let mut child = sandbox.command(&["extract", "good.xyz", "-o", "pipe.json"]).spawn().unwrap();
    std::thread::sleep(Duration::from_secs(2));
    let kill = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(kill.success());
    let start = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > Duration::from_secs(5) {
            child.kill().unwrap();
            panic!("the interrupt was ignored");
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    assert_eq!(child.wait().unwrap().code(), Some(130));
}

#[test]
fn outputs_that_are_other_inputs_are_refused() {
    let sandbox = Sandbox::new();
    sandbox.write_points("good.xyz", &sheet());
    sandbox.write("tuning.toml", "method = \"penalty\"\n");
    std::fs::hard_link(sandbox.path("tuning.toml"), sandbox.path("same.json")).unwrap();
    let run = sandbox.run(&["extract", "good.xyz", "--params", "tuning.toml", "-o", "same.json"]);
    run.expect(5).says(&["never overwritten"]);
    let buffer: Vec<u8> = sheet().iter().flatten().flat_map(|c| (*c as f32).to_le_bytes()).collect();
    sandbox.write("points.json", buffer);
    let gltf = "{\"asset\":{\"version\":\"2.0\"},\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\
        \"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":400,\"type\":\"VEC3\"}],\
        \"bufferViews\":[{\"buffer\":0,\"byteLength\":4800}],\"buffers\":[{\"byteLength\":4800,\"uri\":\"points.json\"}]}";
    sandbox.write("sheet.gltf", gltf);
    let before = sandbox.read("points.json");
    sandbox.run(&["extract", "sheet.gltf", "-o", "points.json"]).expect(5).says(&["never overwritten"]);
    assert_eq!(sandbox.read("points.json"), before);
}

#[test]
fn nothing_in_a_file_steers_the_terminal() {
    let sandbox = Sandbox::new();
    let rows = sheet().iter().map(|[x, y, z]| format!("{x},{y},{z},1\n")).collect::<String>();
    sandbox.write("names.csv", format!("x,y,z,a\x1b[2Jb\n{rows}"));
    let told = sandbox.run(&["info", "names.csv"]).expect(0);
    let text = String::from_utf8(told.stdout.clone()).unwrap();
    assert!(text.contains("u{1b}") && !text.contains('\x1b'), "{text:?}");
}

#[test]
fn a_wrong_name_is_answered_by_the_one_that_was_meant() {
    let sandbox = Sandbox::new();
    sandbox.write_points("part.xyz", &sheet());
    sandbox
        .run(&["extract", "part.xyz", "--set", "gamma=0.4"])
        .expect(4)
        .says(&["did you mean `penalty.gamma`?"]);
    sandbox.run(&["extract", "part.xyz", "--method", "penlaty"]).expect(4).says(&["did you mean `penalty`?"]);
    for (setting, said) in [
        ("surface.clutter=kep", "did you mean `keep`?"),
        ("surface.clutter=on", "expected one of"),
        ("patches.find=tru", "did you mean `true`?"),
        ("patches.find=on", "expected auto or true or false"),
        ("neighbors.k=3", "expected a whole number from 4 to 64"),
    ] {
        let run = sandbox.run(&["extract", "part.xyz", "--set", setting]).expect(4).says(&[said]);
        assert_eq!(run.stderr.contains("did you mean"), said.starts_with("did"), "{setting}: {}", run.stderr);
    }
    sandbox.run(&["part.xyz"]).expect(2).says(&["`lineament extract part.xyz` finds its lines"]);
    let sample = ["extract", "--sample", "braket", "-o", "a.json"];
    sandbox.run(&sample).expect(2).says(&["did you mean `bracket`?"]);
}

#[test]
fn a_point_far_out_does_not_make_a_line_of_a_plane() {
    let sandbox = Sandbox::new();
    let mut points = sheet();
    points.push([1e9, 3.0, 7.0]);
    sandbox.write_points("far.xyz", &points);
    sandbox.run(&["extract", "far.xyz", "-o", "far.json"]).expect(0);
}

/// Rows and columns at distances of `e^-14` to `e^14`, so that a mean spacing says nothing of the places.
#[cfg(target_os = "linux")]
#[test]
fn a_spacing_over_many_decades_takes_memory_in_proportion() {
    let place = |i: i32| (0.28 * f64::from(i - 50)).exp();
    let points = |k: i32| {
        let [x, y] = [place(k % 101), place(k / 101)];
        [x, y, x.min(y)]
    };
    let sandbox = Sandbox::new();
    sandbox.write_points("decades.xyz", &(0..101 * 101).map(points).collect::<Vec<_>>());
    let script = format!(
        "ulimit -v 450000; exec {} extract decades.xyz --method segments --threads 1 -o o.json",
        env!("CARGO_BIN_EXE_lineament")
    );
    let mut shell = std::process::Command::new("sh");
    let run = shell.arg("-c").arg(script).current_dir(sandbox.path("")).output().unwrap();
    assert_eq!(run.status.code(), Some(0), "{run:?}");
    assert_eq!(sandbox.files(), ["decades.xyz", "o.json"]);
}

#[test]
fn lines_of_other_points_are_not_drawn() {
    let sandbox = Sandbox::new();
    sandbox.write_points("good.xyz", &sheet());
    for far in ["1e308", "1e6"] {
        let strip = format!(
            "\"kind\":\"crease\",\"closed\":false,\"start\":0,\"end\":1,\"points\":[[{far},{far},{far}],[-{far},-{far},-{far}]]"
        );
        let network = format!("{{\"schema\":\"lineament-network/1\",\"nodes\":[],\"strips\":[{{{strip}}}]}}");
        sandbox.write("far.json", network);
        let run = sandbox.run(&["render", "good.xyz", "--network", "far.json", "-o", "far.png"]).expect(4);
        run.says(&[
            "good.xyz",
            "lines of these points, which lie from [0.0, 0.0, 0.0] to [19.0, 19.0, 3.61]",
        ]);
    }
    assert!(!sandbox.path("far.png").exists());
}

#[cfg(target_os = "linux")]
#[test]
fn the_file_behind_standard_input_is_not_replaced() {
    let sandbox = Sandbox::new();
    sandbox.write_points("good.xyz", &sheet());
    let before = sandbox.read("good.xyz");
    let redirected = |args: &[&str]| {
        let input = std::fs::File::open(sandbox.path("good.xyz")).unwrap();
        sandbox.command(args).stdin(input).output().unwrap()
    };
    let run = redirected(&["classify", "-", "-o", "good.xyz"]);
    assert_eq!(run.status.code(), Some(5), "{run:?}");
    assert!(String::from_utf8_lossy(&run.stderr).contains("inputs are never overwritten"), "{run:?}");
    assert_eq!(sandbox.read("good.xyz"), before);
    assert_eq!(redirected(&["classify", "-", "-o", "other.xyz"]).status.code(), Some(0));
}
