//! Many inputs with one command.

use crate::common::{Sandbox, cube, json};

fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    std::fs::create_dir(sandbox.path("in")).unwrap();
    sandbox.write_points("in/a.xyz", &cube());
    sandbox.write_points("in/c.txt", &cube());
    sandbox
}

#[test]
fn a_folder_gets_the_results_of_every_input() {
    let sandbox = sandbox();
    sandbox.run(&["extract", "in/a.xyz", "in/c.txt", "-o", "out/"]).expect(0);
    sandbox.run(&["classify", "in/a.xyz", "in/c.txt", "-o", "out"]).expect(0);
    sandbox.run(&["render", "in/a.xyz", "in/c.txt", "-o", "out"]).expect(0);
    for name in ["lines.json", "lines.obj", "classes.npy", "png"] {
        for stem in ["a", "c"] {
            assert!(sandbox.path(&format!("out/{stem}.{name}")).exists(), "{stem}.{name}");
        }
    }
    assert_eq!(json(&sandbox.path("out/c.lines.json"))["input"]["name"], "c.txt");
}

#[test]
fn one_bad_file_leaves_the_others_results_and_exit_code_1() {
    let sandbox = sandbox();
    sandbox.write("in/b.ply", "ply\nnonsense\n");
    sandbox.write_points("in/d.xyz", &[[1.0; 3]; 9]);
    let inputs = ["in/a.xyz", "in/b.ply", "in/c.txt", "in/d.xyz", "in/absent.ply"];
    let args = [["extract"].as_slice(), &inputs, &["-o", "{stem}.obj"]].concat();
    let outcome = sandbox.run(&args).expect(1).says(&["3 of 5 inputs failed"]);
    assert_eq!(sandbox.files(), ["a.obj", "c.obj", "in"]);
    let row = |name: &str| {
        let mut rows = outcome.stderr.lines().filter(|line| line.starts_with(name));
        rows.next().unwrap_or_else(|| panic!("no row of {name} in\n{}", outcome.stderr)).to_string()
    };
    assert_eq!(row("in/a.xyz").split_whitespace().nth(1), Some("386"));
    assert_eq!(row("in/a.xyz").split_whitespace().nth(2), Some("12"));
    assert!(row("in/b.ply").ends_with("failed (input)"));
    assert!(row("in/d.xyz").ends_with("failed (refused)"));
    assert!(row("in/absent.ply").ends_with("failed (input)"));
}

#[test]
fn one_bad_file_among_a_hundred_leaves_99_right_outputs() {
    let sandbox = sandbox();
    let names: Vec<String> = (0..100).map(|i| format!("in/{i:02}.xyz")).collect();
    names.iter().for_each(|name| sandbox.write_points(name, &cube()));
    sandbox.write(&names[41], "1 2 3\n4 5\n");
    let mut args = vec!["extract"];
    args.extend(names.iter().map(String::as_str));
    args.extend(["-o", "{stem}.obj"]);
    sandbox.run(&["extract", "in/a.xyz", "-o", "right.obj"]).expect(0);
    sandbox.run(&args).expect(1).says(&["1 of 100 inputs failed", "in/41.xyz", "failed (input)"]);
    let right = sandbox.read("right.obj");
    for i in 0..100 {
        let path = sandbox.path(&format!("{i:02}.obj"));
        assert_eq!(std::fs::read(path).ok(), (i != 41).then(|| right.clone()), "{i}");
    }
}

#[test]
fn results_of_many_are_those_of_each() {
    let sandbox = sandbox();
    sandbox.run(&["extract", "in/a.xyz", "in/c.txt", "-o", "{stem}.json"]).expect(0);
    sandbox.run(&["extract", "in/c.txt", "-o", "single.json"]).expect(0);
    assert_eq!(sandbox.read("c.json"), sandbox.read("single.json"));
}

#[test]
fn outputs_that_would_overwrite_each_other_are_refused_before_any_work() {
    let sandbox = sandbox();
    for output in ["all.obj", "-"] {
        sandbox.run(&["extract", "in/a.xyz", "in/c.txt", "-o", output]).expect(2).says(&["{stem}"]);
    }
    sandbox.run(&["extract", "-", "-", "-o", "{stem}.obj"]).expect(2);
    assert_eq!(sandbox.files(), ["in"]);
}

#[test]
fn inputs_of_one_name_go_into_one_folder() {
    let sandbox = sandbox();
    for folder in ["p", "q"] {
        std::fs::create_dir(sandbox.path(folder)).unwrap();
        sandbox.write_points(&format!("{folder}/t.csv"), &cube());
    }
    let args = ["extract", "p/t.csv", "q/t.csv", "in/a.xyz", "-o", "coll/", "--report", "list/{stem}.txt"];
    sandbox.run(&args).expect(0);
    for name in ["coll/p_t.lines.json", "coll/q_t.lines.obj", "coll/a.lines.json", "list/q_t.txt"] {
        assert!(sandbox.path(name).exists(), "{name}");
    }
    sandbox.write_points("in/a.csv", &cube());
    let both = ["both in/a.xyz and in/a.csv"];
    sandbox.run(&["extract", "in/a.xyz", "in/a.csv", "-o", "out/"]).expect(2).says(&both);
    assert!(!sandbox.path("out").exists());
}

#[test]
fn folders_of_outputs_are_made_where_there_is_a_result() {
    let sandbox = sandbox();
    for (command, output) in [
        ("extract", "one/two/a.dxf"),
        ("classify", "marks/a.npy"),
        ("section", "cuts/{stem}.json"),
        ("clean", "kept/"),
    ] {
        sandbox.run(&[command, "in/a.xyz", "-o", output]).expect(0);
    }
    for name in ["one/two/a.dxf", "marks/a.npy", "cuts/a.json", "kept/a.clean.ply"] {
        assert!(sandbox.path(name).exists(), "{name}");
    }
    sandbox.write("in/b.ply", "ply\nnonsense\n");
    for output in ["new/b.dxf", "new/{stem}.dxf", "new/"] {
        sandbox.run(&["extract", "in/b.ply", "-o", output]).expect(3);
        assert!(!sandbox.path("new").exists(), "{output}");
    }
    sandbox.run(&["extract", "in/a.xyz", "-o", "in/a.xyz/b.dxf"]).expect(5).says(&["in/a.xyz"]);
}

#[test]
fn an_output_that_names_any_of_the_inputs_is_refused() {
    let sandbox = Sandbox::new();
    let vertices: String = cube().iter().map(|[x, y, z]| format!("v {x:?} {y:?} {z:?}\n")).collect();
    sandbox.write("a.obj", &vertices);
    sandbox.write("b.obj", &vertices);
    sandbox.run(&["extract", "a.obj", "b.obj", "-o", "{stem}.obj"]).expect(5);
    assert_eq!(sandbox.read_text("a.obj"), vertices);
}

#[test]
fn networks_of_many_are_read_by_pattern() {
    let sandbox = sandbox();
    sandbox.run(&["extract", "in/a.xyz", "in/c.txt", "-o", "{stem}.json"]).expect(0);
    sandbox
        .run(&["render", "in/a.xyz", "in/c.txt", "-o", "{stem}.png", "--network", "{stem}.json"])
        .expect(0)
        .says(&["12"]);
    assert_eq!(sandbox.read("a.png"), sandbox.read("c.png"));
}

#[test]
fn info_describes_every_readable_input() {
    let sandbox = sandbox();
    let outcome = sandbox.run(&["info", "in/a.xyz", "absent.ply", "in/c.txt"]).expect(1);
    assert_eq!(outcome.text().matches("386").count(), 2);
}
