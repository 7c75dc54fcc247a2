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
fn a_step_is_a_distance_and_every_reads_every_nth_point_in_all_commands() {
    let sandbox = Sandbox::new();
    sandbox.run(&["section", "--sample", "cube-15206", "--step", "0.3", "-o", "a.json"]).expect(0);
    let strips = json(&sandbox.path("a.json"))["strips"].clone();
    assert!(strips.as_array().unwrap().len() >= 3);
    sandbox.write_points("cube.xyz", &cube());
    sandbox.run(&["section", "cube.xyz", "--every", "2", "-o", "b.json"]).expect(0);
    sandbox.run(&["extract", "cube.xyz", "--every", "2", "-o", "c.json"]).expect(0);
    let points = ["b.json", "c.json"].map(|name| json(&sandbox.path(name))["input"]["points"].clone());
    assert_eq!(points, [193, 193]);
}

/// A gabled house, its ridge along x: walls to z 3 on a ground of 20 by 20, the ridge at z 5.
fn house() -> Vec<[f64; 3]> {
    let grid = |n: i32, step: f64| (0..=n).map(move |i| f64::from(i) * step);
    let mut points = Vec::new();
    for (x, y) in grid(100, 0.2).flat_map(|x| grid(100, 0.2).map(move |y| (x, y))) {
        if !(5.0..=15.0).contains(&x) || !(7.0..=13.0).contains(&y) {
            points.push([x, y, 100.0]);
        }
    }
    for x in grid(50, 0.2).map(|x| x + 5.0) {
        points.extend(grid(15, 0.2).flat_map(|z| [[x, 7.0, 100.0 + z], [x, 13.0, 100.0 + z]]));
        points.extend(grid(15, 0.2).flat_map(|y| {
            let z = 103.0 + 2.0 * y / 3.0;
            [[x, 7.0 + y, z], [x, 13.0 - y, z]]
        }));
    }
    points
}

#[test]
fn positions_count_from_the_floor_where_that_is_asked_for() {
    let sandbox = Sandbox::new();
    sandbox.write_points("house.xyz", &house());
    for (from, zero) in [("origin", 0.0), ("lowest", 100.0), ("floor", 100.0)] {
        let at = format!("--at={}", 101.2 - zero);
        sandbox.run(&["section", "house.xyz", &at, "--from", from, "-o", "a.json"]).expect(0);
        let root = json(&sandbox.path("a.json"));
        assert_eq!(root["from"], from);
        assert!((root["zero"].as_f64().unwrap() - zero).abs() < 0.05, "{}", root["zero"]);
        assert!((root["planes"][0]["height"].as_f64().unwrap() - 101.2).abs() < 0.05);
    }
}

#[test]
fn walls_without_a_floor_are_counted_from_their_lowest_point_and_that_is_said() {
    let sandbox = Sandbox::new();
    let walls: Vec<[f64; 3]> = house().into_iter().filter(|p| (100.3..102.7).contains(&p[2])).collect();
    sandbox.write_points("walls.xyz", &walls);
    let ran = sandbox.run(&["section", "walls.xyz", "--at=1", "--from", "floor", "-o", "a.json"]).expect(0);
    ran.says(&["no floor", "from the lowest point"]);
    assert_eq!(json(&sandbox.path("a.json"))["from"], "lowest");
}

#[test]
fn the_ridge_is_drawn_above_the_eaves_and_to_scale() {
    let sandbox = Sandbox::new();
    sandbox.write_points("house.xyz", &house());
    for axis in ["1,0,0", "-1,0,0"] {
        let args = [
            "section",
            "house.xyz",
            "--at=10",
            "--millimetres",
            "10",
            "-o",
            "a.svg",
            "-o",
            "a.json",
            "-o",
            "a.gpkg",
        ];
        let at = if axis == "1,0,0" { "--at=10" } else { "--at=-10" };
        let args: Vec<&str> = args.iter().map(|&a| if a == "--at=10" { at } else { a }).collect();
        sandbox.run(&[args.as_slice(), &[&format!("--axis={axis}")]].concat()).expect(0);
        let up = json(&sandbox.path("a.json"))["axes"][1].clone();
        assert_eq!([&up[0], &up[1], &up[2]].map(|x| x.as_f64().unwrap()), [0.0, 0.0, 1.0]);
        let svg = sandbox.read_text("a.svg");
        assert!(svg.contains("one unit of the input is 10.0 mm"), "{svg}");
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for path in svg.split(" d=\"").skip(1).map(|rest| rest.split('"').next().unwrap()) {
            for place in path.split(['M', 'L', 'Z']).filter(|place| !place.is_empty()) {
                let y: f64 = place.split(' ').nth(1).unwrap().parse().unwrap();
                (low, high) = (low.min(y), high.max(y));
            }
        }
        // From the ground to the ridge: 5 m, y downwards.
        assert!((high - low - 50.0).abs() < 3.0, "{low} {high}");
        assert!(sandbox.read("a.gpkg").starts_with(b"SQLite format 3"));
    }
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
        (&["section", "a.xyz", "-o", "a.json", "--step", "1", "--count", "3"], 2),
        (&["section", "absent.xyz", "-o", "a.json"], 3),
        (&["section", "a.xyz", "-o", "a.json", "--step", "0"], 4),
        (&["section", "a.xyz", "-o", "a.json", "--every", "0.5"], 2),
        (&["section", "a.xyz", "-o", "a.xyz/a.json"], 5),
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
        (&["--step", "0.3"], &["planes=step:0.3"]),
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

#[test]
fn sections_as_step_are_read_back_as_the_lines_that_they_are() {
    let sandbox = Sandbox::new();
    let outputs = ["-o", "a.step", "-o", "a.json"];
    for fit in [&["--fit"][..], &[]] {
        let args = [&["section", "--sample", "cube-15206", "--at=0.1,-0.2"], fit, &outputs[..]].concat();
        sandbox.run(&args).expect(0).says(&["a.step states millimetres", "wrote a.step, a.json"]);
        let args = ["evaluate", "a.step", "--truth", "a.json", "--spacing", "0.01", "--tolerance", "0.5"];
        let table = sandbox.run(&args).expect(0).text();
        assert!(table.contains("1.0000     1.0000     1.0000"), "{table}");
    }
}
