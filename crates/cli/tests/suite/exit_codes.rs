//! Each documented exit code, with a message that names the file, the place, the value and what to do.

use std::process::Stdio;

use crate::common::{Sandbox, cube, table};

fn with_cube() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox
}

#[test]
fn usage_is_2_and_nothing_is_written() {
    let sandbox = with_cube();
    let cases: &[&[&str]] = &[
        &[],
        &["extract"],
        &["extract", "cube.xyz", "--sample", "bracket"],
        &["extract", "--sample", "no-such-sample", "-o", "a.json"],
        &["extract", "cube.xyz", "-o", "a.unknown"],
        &["extract", "cube.xyz", "-o", "a.json", "-o", "a.json"],
        &["extract", "cube.xyz", "--set", "penalty.gamma"],
        &["extract", "cube.xyz", "--threads", "0"],
        &["extract", "cube.xyz", "-q", "-v"],
        &["classify", "cube.xyz"],
        &["classify", "cube.xyz", "-o", "a.json"],
        &["render", "cube.xyz", "-o", "a.jpg"],
        &["render", "cube.xyz", "-o", "a.png", "--view", "sideways"],
        &["render", "cube.xyz", "-o", "a.png", "--view", "top,1,2"],
        &["render", "cube.xyz", "-o", "a.svg", "--point-color", "class"],
        &["render", "cube.xyz", "-o", "a.png", "--point-color", "class", "--network", "none"],
        &["render", "cube.xyz", "-o", "a.png", "--size", "1000000x2"],
        &["completions", "no-such-shell"],
    ];
    for args in cases {
        let outcome = sandbox.run(args).expect(2);
        assert!(!outcome.stderr.is_empty(), "{args:?}");
        assert_eq!(sandbox.files(), ["cube.xyz"], "{args:?}");
    }
}

#[test]
fn unreadable_or_malformed_input_is_3_and_names_file_and_place() {
    let sandbox = with_cube();
    sandbox.write("empty.xyz", "");
    sandbox.write("words.xyz", "1 2 3\n4 5 6\n7 eight 9\n");
    sandbox.write("short.ply", "ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\n");
    sandbox.write("bad.toml", "[penalty\n");
    sandbox.write("bad.json", "{\"schema\": 3}");
    let before = sandbox.files();
    let cases: &[(&[&str], &str)] = &[
        (&["extract", "absent.ply"], "absent.ply"),
        (&["extract", "empty.xyz"], "empty.xyz"),
        (&["extract", "words.xyz"], "line 3"),
        (&["classify", "short.ply", "-o", "a.npy"], "short.ply"),
        (&["info", "short.ply"], "short.ply"),
        (&["extract", "cube.xyz", "--params", "bad.toml"], "bad.toml:1"),
        (&["extract", "cube.xyz", "--params", "absent.toml"], "absent.toml"),
        (&["render", "cube.xyz", "-o", "a.png", "--network", "bad.json"], "bad.json"),
    ];
    for (args, part) in cases {
        sandbox.run(args).expect(3).says(&[part]);
        assert_eq!(sandbox.files(), before, "{args:?}");
    }
}

#[test]
fn refused_parameters_are_4_and_name_key_and_value() {
    let sandbox = with_cube();
    sandbox.write("p.toml", "\n[penalty]\ngamma = 1.5\n");
    let cases: &[(&[&str], &[&str])] = &[
        (&["--set", "penalty.gamma=7"], &["penalty.gamma", "7", "lineament params"]),
        (&["--set", "warp.factor=1"], &["warp.factor"]),
        (&["--set", "penalty.gamma=nan"], &["penalty.gamma", "nan"]),
        (&["--method", "guess"], &["method", "guess", "penalty"]),
        (&["--params", "p.toml"], &["p.toml:3", "penalty.gamma", "1.5"]),
    ];
    for (args, parts) in cases {
        sandbox.run(&[["extract", "cube.xyz"].as_slice(), args].concat()).expect(4).says(parts);
        assert_eq!(sandbox.files(), ["cube.xyz", "p.toml"], "{args:?}");
    }
}

#[test]
fn outputs_that_cannot_be_written_are_5_before_any_work_is_done() {
    let sandbox = with_cube();
    let cases: &[&[&str]] = &[
        &["extract", "cube.xyz", "-o", "cube.xyz/a.json"],
        &["extract", "cube.xyz", "-o", "cube.xyz/"],
        &["classify", "cube.xyz", "-o", "cube.xyz/absent/a.npy"],
        &["render", "cube.xyz", "-o", "cube.xyz/a.png"],
    ];
    for args in cases {
        sandbox.run(args).expect(5);
        assert_eq!(sandbox.files(), ["cube.xyz"], "{args:?}");
    }
}

#[test]
fn an_output_that_names_an_input_is_refused_and_the_input_stays() {
    let sandbox = Sandbox::new();
    let header = "ply\nformat ascii 1.0\nelement vertex 386\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    sandbox.write("cube.ply", format!("{header}{}", table(&cube())));
    let before = sandbox.read("cube.ply");
    for output in ["cube.ply", "./cube.ply"] {
        sandbox.run(&["extract", "cube.ply", "-o", output]).expect(5).says(&["cube.ply"]);
        sandbox.run(&["classify", "cube.ply", "-o", output]).expect(5);
    }
    assert_eq!(sandbox.read("cube.ply"), before);
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_5() {
    let sandbox = with_cube();
    for args in [["extract", "cube.xyz", "-o", "-"], ["render", "cube.xyz", "-o", "-"]] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = sandbox.command(&args).stdout(Stdio::from(full)).output().unwrap();
        assert_eq!(output.status.code(), Some(5), "{args:?}");
    }
}

#[test]
#[cfg(unix)]
fn an_interrupt_is_130_and_leaves_no_file() {
    use std::io::Write;
    let sandbox = Sandbox::new();
    let mut child = sandbox.command(&["extract", "-", "-o", "a.json"]).stdin(Stdio::piped()).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    // More than a pipe holds: once it is written, the program is up and reading, and waits for the rest.
    stdin.write_all("0.5 0.5 0.5\n".repeat(100_000).as_bytes()).unwrap();
    let killed = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(killed.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert_eq!(sandbox.files(), [""; 0]);
}

#[test]
fn help_and_readme_list_the_same_exit_codes() {
    let sandbox = Sandbox::new();
    let help = sandbox.run(&["--help"]).expect(0).text();
    let readme = include_str!("../../../../README.md");
    let section = help.split("Exit codes:\n").nth(1).unwrap();
    let codes: Vec<(&str, &str)> = section.lines().filter_map(|l| l.trim().split_once(' ')).collect();
    assert_eq!(codes.len(), 7);
    for (code, meaning) in codes {
        let row = format!("| {code} | {} |", meaning.trim());
        assert!(readme.contains(&row), "{row}");
    }
}

#[test]
fn strict_refuses_points_that_are_not_finite_and_names_the_first() {
    let sandbox = with_cube();
    let mut points = cube();
    points.insert(3, [1.0, f64::NAN, 2.0]);
    sandbox.write_points("odd.xyz", &points);
    sandbox
        .run(&["extract", "odd.xyz", "--strict"])
        .expect(4)
        .says(&["odd.xyz", "point 3", "NaN", "1 in all"]);
    sandbox.run(&["extract", "cube.xyz", "--strict", "-o", "a.json"]).expect(0);
    assert_eq!(sandbox.files(), ["a.json", "cube.xyz", "odd.xyz"]);
}

#[test]
fn a_file_that_ends_early_is_3_and_salvage_reads_what_is_whole_of_it() {
    let sandbox = Sandbox::new();
    let header = "ply\nformat ascii 1.0\nelement vertex 500\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    sandbox.write("short.ply", format!("{header}{}", table(&cube())));
    sandbox.run(&["extract", "short.ply", "-o", "a.json"]).expect(3).says(&["short.ply", "--salvage"]);
    assert_eq!(sandbox.files(), ["short.ply"]);
    sandbox.run(&["extract", "short.ply", "-o", "a.json", "--salvage"]).expect(0).says(&[
        "386",
        "500",
        "12 creases",
    ]);
}

#[test]
fn every_command_counts_points_that_are_not_finite_or_repeated_and_strict_refuses_the_first() {
    let sandbox = Sandbox::new();
    let points = [cube(), cube()[..3].to_vec()].concat();
    sandbox.write("odd.xyz", crate::common::table(&points) + "nan 0 0\n0 inf 0\n");
    let commands: [&[&str]; 5] = [
        &["extract", "odd.xyz", "-o", "a.json"],
        &["classify", "odd.xyz", "-o", "a.npy"],
        &["patches", "odd.xyz", "-o", "a.json"],
        &["section", "odd.xyz", "--at=0.1", "-o", "b.json"],
        &["slices", "odd.xyz", "--count", "2", "-o", "out"],
    ];
    for args in commands {
        sandbox.run(args).expect(0).says(&["391 points read, 2 not finite, 3 duplicates"]);
        let refused = sandbox.run(&[args, &["--strict"]].concat()).expect(4);
        refused.says(&["odd.xyz", "point 389 is not finite", "2 in all"]);
    }
}
