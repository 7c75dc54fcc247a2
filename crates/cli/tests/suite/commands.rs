//! Each command does what its help says.

mod apply;
mod cad;
mod drawings;
mod listing;
mod stages;
mod surveys;

use crate::common::{Sandbox, cube, json};

#[test]
fn extract_writes_every_output_in_the_format_of_its_extension() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let names = ["a.json", "b.obj", "c.ply", "d.dxf"];
    let outputs = names.map(|name| ["-o", name]).concat();
    let args = [["extract", "cube.xyz"].as_slice(), &outputs].concat();
    sandbox.run(&args).expect(0).says(&[
        "386 points read",
        "12 creases",
        "8 junctions",
        "a.json, b.obj, c.ply, d.dxf",
    ]);
    assert_eq!(json(&sandbox.path("a.json"))["schema"], "lineament-network/2");
    assert!(sandbox.read_text("b.obj").lines().any(|line| line.starts_with("l ")));
    assert!(sandbox.read("c.ply").starts_with(b"ply\n"));
    assert!(sandbox.read_text("d.dxf").contains("AcDbLine\n"));
}

#[test]
fn extract_writes_beside_the_input_when_no_output_is_named() {
    let sandbox = Sandbox::new();
    std::fs::create_dir(sandbox.path("scans")).unwrap();
    sandbox.write_points("scans/my.cube.xyz", &cube());
    sandbox
        .run(&["extract", "scans/my.cube.xyz"])
        .expect(0)
        .says(&["my.cube.lines.json", "my.cube.lines.obj"]);
    assert_eq!(json(&sandbox.path("scans/my.cube.lines.json"))["strips"].as_array().unwrap().len(), 12);
    assert!(sandbox.path("scans/my.cube.lines.obj").exists());
}

#[test]
fn json_says_where_its_lines_come_from() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox.run(&["extract", "cube.xyz", "-o", "a.json", "--set", "penalty.gamma=0.4"]).expect(0);
    let root = json(&sandbox.path("a.json"));
    assert_eq!(root["input"]["name"], "cube.xyz");
    assert_eq!(root["input"]["points"], 386);
    assert_eq!(root["input"]["sha256"].as_str().unwrap().len(), 64);
    assert_eq!(root["method"], "auto");
    assert_eq!(root["parameters"]["penalty.gamma"], 0.4);
}

#[test]
fn quiet_says_nothing_and_verbose_says_what_was_chosen() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    assert_eq!(sandbox.run(&["extract", "cube.xyz", "-q"]).expect(0).stderr, "");
    sandbox.run(&["extract", "cube.xyz", "-v"]).expect(0).says(&["chosen: "]);
}

#[test]
fn classify_gives_a_row_for_every_point_of_the_input_in_its_order() {
    let sandbox = Sandbox::new();
    let mut points = cube();
    points.insert(7, [f64::NAN; 3]);
    points.push(points[0]);
    sandbox.write_points("cube.xyz", &points);
    sandbox
        .run(&["classify", "cube.xyz", "-o", "a.npy", "-o", "a.ply"])
        .expect(0)
        .says(&["1 not finite", "1 duplicate"]);
    let npy = sandbox.read("a.npy");
    assert!(npy.starts_with(b"\x93NUMPY"));
    let classes = &npy[npy.len() - 388..];
    assert_eq!(classes[7], 0, "a dropped point is smooth");
    assert_eq!(classes[387], classes[0], "a duplicate is what its twin is");
    let furthest = points.iter().map(|p| p.map(f64::abs).iter().sum()).fold(0.0, f64::max);
    let corners =
        points[..387].iter().zip(classes).filter(|(p, _)| p.map(f64::abs).iter().sum::<f64>() == furthest);
    assert_eq!(corners.map(|(_, &class)| class).collect::<Vec<u8>>(), [3; 8]);
    let header = String::from_utf8_lossy(&sandbox.read("a.ply")[..400]).into_owned();
    assert!(
        header.contains("element vertex 388") && header.contains("class") && header.contains("score"),
        "{header}"
    );
}

#[test]
fn classify_keeps_the_attributes_of_the_input_in_ply() {
    let sandbox = Sandbox::new();
    let header = "ply\nformat ascii 1.0\nelement vertex 386\nproperty double x\nproperty double y\nproperty double z\n\
                  property uchar red\nend_header\n";
    let rows = cube().iter().map(|[x, y, z]| format!("{x:?} {y:?} {z:?} 200\n")).collect::<String>();
    sandbox.write("cube.ply", format!("{header}{rows}"));
    sandbox.run(&["classify", "cube.ply", "-o", "out.ply"]).expect(0);
    assert!(String::from_utf8_lossy(&sandbox.read("out.ply")).contains("uchar red"));
}

#[test]
fn render_draws_lines_and_points_from_every_view() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    for view in ["auto", "top", "front", "left", "iso", "1,-2,0.5", "-1,0,0"] {
        sandbox.run(&["render", "cube.xyz", "-o", "a.png", "--size", "320x240", "--view", view]).expect(0);
        let picture = decode(&sandbox.read("a.png"));
        assert_eq!((picture.0, picture.1), (320, 240));
        let reddish = picture.2.chunks(3).filter(|p| p[0] > 150 && p[1] < p[0] - 60).count();
        assert!(reddish > 200, "{view}: {reddish} pixels of crease");
        assert_eq!(picture.2[..3], [255; 3], "{view}: the margin is white");
    }
}

#[test]
fn render_draws_a_network_from_a_file_as_if_it_were_computed() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox.run(&["extract", "cube.xyz", "-o", "n.json"]).expect(0);
    sandbox.run(&["render", "cube.xyz", "-o", "a.png"]).expect(0);
    sandbox.run(&["render", "cube.xyz", "-o", "b.png", "--network", "n.json"]).expect(0);
    assert_eq!(sandbox.read("a.png"), sandbox.read("b.png"));
    sandbox.run(&["render", "cube.xyz", "-o", "c.png", "--network", "none"]).expect(0);
    assert_ne!(sandbox.read("a.png"), sandbox.read("c.png"));
}

#[test]
fn info_tells_format_counts_bounds_and_spacing() {
    let sandbox = Sandbox::new();
    let mut points = cube();
    points.push([f64::INFINITY, 0.0, 0.0]);
    points.push(points[3]);
    sandbox.write_points("cube.xyz", &points);
    let text = sandbox.run(&["info", "cube.xyz"]).expect(0).text();
    for (label, value) in [("points", "388"), ("not finite", "1"), ("duplicates", "1")] {
        assert!(text.lines().any(|l| l.starts_with(label) && l.ends_with(value)), "{label} {value}\n{text}");
    }
    for label in ["format", "x ", "y ", "z ", "spacing", "noise"] {
        assert!(text.lines().any(|l| l.starts_with(label)), "{label}\n{text}");
    }
    sandbox.write("classes.csv", "x,y,z,class,w\n0,0,0,2,1\n1,0,0,6,1\n0,1,0,5,nan\n");
    let text = sandbox.run(&["info", "classes.csv"]).expect(0).text();
    assert!(text.contains(", 2 to 6\n") && text.contains(", all 1\n"), "{text}");
    // Numbers of single precision are told as they were written.
    sandbox.write("single.xyz", format!("{} 0.1 0\n1 2.5 0\n0 1 0.3\n", f64::from(10.6_f32)));
    let text = sandbox.run(&["info", "single.xyz"]).expect(0).text();
    assert!(
        text.contains("0 to 10.6 (") && text.contains("0.1 to 2.5 (") && text.contains("0 to 0.3 ("),
        "{text}"
    );
}

#[test]
fn params_prints_a_file_that_params_reads_back() {
    let sandbox = Sandbox::new();
    let defaults = sandbox.run(&["params"]).expect(0).text();
    sandbox.write("p.toml", &defaults);
    assert_eq!(sandbox.run(&["params", "--params", "p.toml"]).expect(0).text(), defaults);
    let changed = sandbox.run(&["params", "--set", "penalty.gamma=0.25"]).expect(0).text();
    assert!(changed.contains("gamma = 0.25"));
    sandbox.write("p.toml", &changed);
    assert_eq!(sandbox.run(&["params", "--params", "p.toml"]).expect(0).text(), changed);
}

#[test]
fn set_goes_over_the_file_and_the_file_over_the_defaults() {
    let sandbox = Sandbox::new();
    sandbox.write("p.toml", "[penalty]\ngamma = 0.3\nfold_deg = 20\n");
    let text = sandbox.run(&["params", "--params", "p.toml", "--set", "penalty.gamma=0.1"]).expect(0).text();
    assert!(text.contains("\ngamma = 0.1\n") && text.contains("\nfold_deg = 20"), "{text}");
}

#[test]
fn completions_exist_for_every_shell() {
    let sandbox = Sandbox::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        assert!(sandbox.run(&["completions", shell]).expect(0).text().contains("lineament"));
    }
}

#[test]
fn samples_are_listed_and_depend_on_the_seed_alone() {
    let sandbox = Sandbox::new();
    let list = sandbox.run(&["extract", "--sample", "list"]).expect(0).text();
    assert!(list.lines().any(|line| line.starts_with("bracket ")));
    for (name, seed) in [("a.json", "1"), ("b.json", "1"), ("c.json", "2")] {
        sandbox.run(&["extract", "--sample", "random-cube", "--seed", seed, "-o", name]).expect(0);
    }
    assert_eq!(sandbox.read("a.json"), sandbox.read("b.json"));
    assert_ne!(sandbox.read("a.json"), sandbox.read("c.json"));
}

#[test]
fn help_lists_every_command_and_every_exit_code() {
    let sandbox = Sandbox::new();
    let text = sandbox.run(&["--help"]).expect(0).text();
    for word in ["extract", "classify", "render", "info", "params", "completions", "Exit codes", "130"] {
        assert!(text.contains(word), "{word}");
    }
}

#[test]
fn the_help_of_each_command_begins_with_examples_of_it() {
    let sandbox = Sandbox::new();
    let commands = [
        "extract",
        "classify",
        "patches",
        "render",
        "evaluate",
        "section",
        "slices",
        "info",
        "params",
        "completions",
    ];
    for command in commands {
        let text = sandbox.run(&[command, "--help"]).expect(0).text();
        let head = text.split("Usage:").next().unwrap();
        assert!(head.contains(&format!("\n  lineament {command} ")), "{head}");
        assert!(head.contains("write") || head.contains("output"), "{head}");
    }
}

/// Width, height and RGB bytes of a PNG file.
fn decode(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    (info.width, info.height, pixels)
}

#[test]
fn every_format_that_the_help_lists_is_written() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    for command in ["extract", "classify", "patches", "section"] {
        let help = sandbox.run(&[command, "--help"]).expect(0).text();
        let listed = help.split("Formats by extension:\n").nth(1).unwrap().split("\n\n").next().unwrap();
        let extensions: Vec<&str> = listed
            .lines()
            .flat_map(|line| line.split_whitespace().map_while(|word| word.strip_prefix('.')))
            .collect();
        assert!(extensions.len() >= 6, "{listed}");
        for extension in extensions {
            let output = format!("{command}.{extension}");
            sandbox.run(&[command, "cube.xyz", "-o", &output]).expect(0);
            assert!(!sandbox.read(&output).is_empty());
        }
    }
}

#[test]
fn patches_writes_labelled_points_loops_and_surfaces() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let args = ["patches", "cube.xyz", "-o", "a.json", "-o", "b.csv", "-o", "c.dxf"];
    sandbox.run(&args).expect(0).says(&["6 patches, 6 planes", "12 of 12 creases lie between two patches"]);
    let root = json(&sandbox.path("a.json"));
    assert_eq!(root["method"], "segments");
    let patches = root["patches"].as_array().unwrap();
    assert_eq!(patches.len(), 6);
    for patch in patches {
        assert_eq!(patch["surface"]["type"], "plane");
        assert_eq!(patch["loops"][0]["strips"].as_array().unwrap().len(), 4);
        assert_eq!(patch["neighbors"].as_array().unwrap().len(), 4);
    }
    for strip in root["strips"].as_array().unwrap() {
        assert_eq!(strip["convex"], true);
        assert_ne!(strip["left"], strip["right"]);
    }
    let points = sandbox.read_text("b.csv");
    assert_eq!(points.lines().count(), 387);
    let (header, first) = (points.lines().next().unwrap(), points.lines().nth(1).unwrap());
    let column = header.split(',').position(|name| name == "patch").unwrap();
    let label: usize = first.split(',').nth(column).unwrap().parse().unwrap();
    assert!(label < 6);
    let drawing = sandbox.read_text("c.dxf");
    let lines = root["strips"].as_array().unwrap().iter().flat_map(|s| s["curves"].as_array().unwrap());
    // Every strip stands in the loops of two patches.
    assert_eq!(drawing.matches("\n8\nPATCH_").count(), 2 * lines.count());
}

#[test]
fn parameters_that_were_used_give_the_same_bytes_again() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    for method in ["auto", "penalty", "projection", "segments"] {
        for more in [&[][..], &["--set", "penalty.form=paper", "--set", "segments.form=paper"]] {
            let first = [&["extract", "cube.xyz", "-o", "a.json", "--method", method], more].concat();
            sandbox.run(&first).expect(0);
            let parameters = json(&sandbox.path("a.json"))["parameters"].clone();
            let parameters = parameters.as_object().unwrap();
            assert!(parameters.iter().all(|(k, v)| k == "method" || v != "auto"), "{parameters:?}");
            assert_eq!(parameters["method"], method);
            assert!(parameters["penalty.noise_spacings"].is_number());
            sandbox.run(&["extract", "cube.xyz", "-o", "b.json", "--params", "a.json"]).expect(0);
            assert!(sandbox.read("a.json") == sandbox.read("b.json"), "{first:?}");
        }
    }
}

#[test]
fn a_mesh_is_sampled_and_the_summary_says_so() {
    let sandbox = Sandbox::new();
    let corner = |i: usize| [0, 1, 2].map(|a| if i >> a & 1 == 1 { [30, 20, 10][a] } else { 0 });
    let vertices: String = (0..8).map(corner).map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect();
    let quads = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    sandbox.write("box.obj", format!("{vertices}{quads}"));
    let said = &["20,000 points sampled over 6 faces", "12 creases", "8 junctions"];
    sandbox.run(&["extract", "box.obj", "-o", "a.json"]).expect(0).says(said);
    sandbox
        .run(&["extract", "box.obj", "-o", "b.json", "--samples", "3000"])
        .expect(0)
        .says(&["3,000 points sampled"]);
    let none = sandbox.run(&["extract", "box.obj", "-o", "c.json", "--vertices"]).expect(0);
    none.says(&["8 points read", "no line: 8 points are too few"]);
    let told = sandbox.run(&["info", "box.obj"]).expect(0).text();
    for line in [
        "faces       6\n",
        "vertices    8\n",
        "points      20,000, sampled",
        "spacing     0.33",
        "features    6.667 and more",
    ] {
        assert!(told.contains(line), "{line}: {told}");
    }
    sandbox.run(&["extract", "box.obj", "--samples", "0"]).expect(2);
    sandbox.run(&["extract", "box.obj", "--samples", "10", "--vertices"]).expect(2);
}
