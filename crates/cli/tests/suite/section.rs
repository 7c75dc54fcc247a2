//! Sections and slices.

use crate::common::{Sandbox, cube, json};

#[test]
fn sections_of_a_cube_are_closed_and_lie_where_they_were_asked_for() {
    let sandbox = Sandbox::new();
    let args = ["section", "--sample", "cube-15206", "--at=0.1,-0.2", "-o", "a.json", "-o", "a.dxf"];
    sandbox.run(&args).expect(0).says(&["2 slices", "2 contours", "2 closed", "wrote a.json, a.dxf"]);
    let strips = json(&sandbox.path("a.json"))["strips"].clone();
    let heights: Vec<f64> =
        strips.as_array().unwrap().iter().map(|s| s["points"][0][2].as_f64().unwrap()).collect();
    assert!((heights[0] - 0.1).abs() < 1e-9 && (heights[1] + 0.2).abs() < 1e-9, "{heights:?}");
}

#[test]
fn every_is_a_distance_for_sections() {
    let sandbox = Sandbox::new();
    sandbox.run(&["section", "--sample", "cube-15206", "--every", "0.3", "-o", "a.json"]).expect(0);
    let strips = json(&sandbox.path("a.json"))["strips"].clone();
    assert!(strips.as_array().unwrap().len() >= 3);
}

#[test]
fn slices_are_a_picture_each_in_a_folder_that_is_made() {
    let sandbox = Sandbox::new();
    sandbox
        .run(&["slices", "--sample", "cube-15206", "--count", "3", "-o", "out"])
        .expect(0)
        .says(&["3 pictures"]);
    for k in 0..3 {
        assert!(sandbox.read_text(&format!("out/slice_000{k}.svg")).contains("<svg"));
    }
}

#[test]
fn one_bad_file_among_many_leaves_the_sections_of_the_others() {
    let sandbox = Sandbox::new();
    sandbox.write_points("a.xyz", &cube());
    sandbox.write("b.ply", "ply\nnonsense\n");
    sandbox
        .run(&["section", "a.xyz", "b.ply", "-o", "{stem}.json"])
        .expect(1)
        .says(&["1 of 2 inputs failed"]);
    assert_eq!(sandbox.files(), ["a.json", "a.xyz", "b.ply"]);
}

#[test]
fn what_cannot_be_is_refused_with_its_exit_code() {
    let sandbox = Sandbox::new();
    sandbox.write_points("a.xyz", &cube());
    let cases: &[(&[&str], i32)] = &[
        (&["section", "a.xyz"], 2),
        (&["section", "a.xyz", "-o", "a.png"], 2),
        (&["section", "a.xyz", "-o", "a.json", "--axis", "w"], 2),
        (&["section", "a.xyz", "-o", "a.json", "--every", "1", "--count", "3"], 2),
        (&["section", "absent.xyz", "-o", "a.json"], 3),
        (&["section", "a.xyz", "-o", "a.json", "--every", "0"], 4),
        (&["section", "a.xyz", "-o", "absent/a.json"], 5),
    ];
    for (args, code) in cases {
        sandbox.run(args).expect(*code);
        assert_eq!(sandbox.files(), ["a.xyz"], "{args:?}");
    }
}

/// What a command line writes for a noisy sphere, as JSON.
fn cut(options: &[&str]) -> Vec<u8> {
    let sandbox = Sandbox::new();
    sandbox.write("hull.toml", "section.outline = \"hull\"\n");
    let mut args = vec!["section", "--sample", "sphere", "-o", "a.json"];
    args.extend(options);
    sandbox.run(&args).expect(0);
    sandbox.read("a.json")
}

#[test]
fn options_are_shorthands_for_keys_of_the_table() {
    let standard = cut(&[]);
    let pairs: &[(&[&str], &[&str])] = &[
        (&["--axis", "x"], &["axis=x"]),
        (&["--axis", "1,0,1"], &["axis=1,0,1"]),
        (&["--count", "3"], &["planes=count:3"]),
        (&["--every", "0.3"], &["planes=every:0.3"]),
        (&["--at=0.1,-0.2"], &["planes=at:0.1,-0.2"]),
        (&["--adaptive", "3"], &["planes=adaptive:3"]),
        (&["--thickness", "0.02"], &["thickness=0.02"]),
        (&["--no-carry"], &["carry=false"]),
        (&["--params", "hull.toml"], &["outline=hull"]),
        (&["--outline", "hull"], &["outline=hull"]),
        (&["--outline", "voronoi", "--circle-bound", "0.3"], &["outline=voronoi", "circle_bound=0.3"]),
        (&["--side", "out"], &["side=out"]),
        (&["--fit"], &["fit=true"]),
        (&["--tolerance", "0.05"], &["fit=true", "tolerance=0.05"]),
    ];
    for (options, keys) in pairs {
        let typed = cut(options);
        let keys: Vec<String> = keys.iter().map(|key| format!("section.{key}")).collect();
        let set: Vec<&str> = keys.iter().flat_map(|key| ["--set", key.as_str()]).collect();
        assert!(typed == cut(&set), "{options:?} and {set:?}");
        assert!(typed != standard, "{options:?} change nothing");
    }
}

#[test]
fn the_defaults_in_the_help_are_those_of_the_table() {
    let help = Sandbox::new().run(&["section", "--help"]).expect(0).text();
    let entries = lineament::Params::default().entries();
    let options = ["axis", "thickness", "outline", "circle-bound", "side", "tolerance"]
        .map(|o| (o, o.replace('-', "_"), ""));
    for (option, key, prefix) in options.into_iter().chain([("count", "planes".into(), "count:")]) {
        let key = format!("section.{key}");
        let default = &entries.iter().find(|e| e.key == key).unwrap().default;
        let about = help.split(&format!("--{option} <")).nth(1).unwrap();
        let about =
            about.split("\n      --").next().unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(about.contains(&format!("[default: {}]", default.strip_prefix(prefix).unwrap())), "{about}");
    }
}

#[test]
fn set_goes_over_the_options_and_these_over_the_file() {
    assert!(cut(&["--params", "hull.toml", "--outline", "middle"]) == cut(&[]));
    let set = cut(&["--outline", "hull", "--set", "section.outline=voronoi"]);
    assert!(set == cut(&["--outline", "voronoi"]));
}
