//! `--stages` writes what a method went through, and its table counts what the files hold.

use crate::common::{Sandbox, cube, json};
use serde_json::Value;

#[test]
fn the_default_method_has_no_stages_and_segments_has_every_graph() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let args = ["extract", "cube.xyz", "-o", "a.json", "--stages", "steps"];
    sandbox.run(&args).expect(2).says(&["the method `auto` has no stages"]);
    sandbox.run(&[args.as_slice(), &["--method", "segments"]].concat()).expect(0).says(&["stages.json"]);
    let graphs = ["G_all", "G_extended", "G_pruned_mst", "G_pruned_branches", "G_closed", "G_smooth"];
    let table = json(&sandbox.path("steps/stages.json"));
    assert_eq!(table["points"], 386);
    for (name, row) in graphs.iter().zip(table["graphs"].as_array().unwrap()) {
        assert_eq!(row["name"], *name);
        let file = sandbox.read(&format!("steps/{name}.ply"));
        let header = String::from_utf8_lossy(&file[..400.min(file.len())]).into_owned();
        assert!(header.starts_with("ply\n"), "{header}");
        assert!(header.contains(&format!("element edge {}\n", row["edges"])), "{header}");
    }
    let border = sandbox.read("steps/border.ply");
    let held = format!("element edge {}\n", table["border"]["edges"]);
    assert!(String::from_utf8_lossy(&border[..400.min(border.len())]).contains(&held), "{held}");
    assert_eq!(table["graphs"][4]["open_ends"], 0);
    assert!(sandbox.path("steps/segmentation.ply").exists());
}

/// Whether the header of each file tells as many vertices and edges as the table; returns the table.
fn counted(sandbox: &Sandbox, folder: &str) -> Value {
    let table = json(&sandbox.path(&format!("{folder}/stages.json")));
    for row in table["stages"].as_array().unwrap() {
        let file = sandbox.read(&format!("{folder}/{}.ply", row["name"].as_str().unwrap()));
        let header = String::from_utf8_lossy(&file[..1200.min(file.len())]).into_owned();
        for (what, element) in [("vertices", "vertex"), ("edges", "edge")] {
            if let Some(count) = row[what].as_u64() {
                assert!(header.contains(&format!("element {element} {count}\n")), "{row}: {header}");
            }
        }
    }
    table
}

fn names(table: &Value) -> Vec<&str> {
    table["stages"].as_array().unwrap().iter().map(|row| row["name"].as_str().unwrap()).collect()
}

#[test]
fn penalty_goes_from_ellipsoids_to_recovered_corners_and_leaves_the_lines_as_they_were() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let args = ["extract", "cube.xyz", "--method", "penalty", "--set", "recover.wedge=paper", "--quiet"];
    sandbox.run(&[args.as_slice(), &["-o", "a.json"]].concat()).expect(0);
    sandbox.run(&[args.as_slice(), &["-o", "b.json", "--stages", "steps"]].concat()).expect(0);
    assert_eq!(sandbox.read("a.json"), sandbox.read("b.json"));
    let table = counted(&sandbox, "steps");
    assert_eq!((&table["method"], &table["points"]), (&"penalty".into(), &386.into()));
    let lines = ["edges", "spanning", "pruned", "repaired"];
    let kinds = ["crease", "border"];
    let graphs = kinds.iter().flat_map(|kind| lines.iter().map(move |name| format!("{kind}_{name}")));
    let graphs: Vec<String> = graphs.collect();
    let mut all = vec!["ellipsoids", "penalties"];
    all.extend(graphs.iter().map(String::as_str));
    all.extend(["splines", "strip_groups", "node_groups", "recovered"]);
    assert_eq!(names(&table), all);
    let row = |name: &str| &table["stages"][all.iter().position(|n| *n == name).unwrap()];
    assert_eq!((&row("splines")["strips"], &row("recovered")["corners"]), (&12.into(), &8.into()));
    assert_eq!(row("crease_repaired")["open_ends"], 0);
    // The printed form repairs nothing, and without recovery there are no groups.
    let printed =
        [&args[..4], &["--set", "penalty.form=paper", "-o", "c.json", "--stages", "printed"]].concat();
    sandbox.run(&printed).expect(0);
    let table = counted(&sandbox, "printed");
    assert!(!names(&table).iter().any(|n| n.ends_with("repaired") || n.ends_with("groups")));
}

#[test]
fn projection_has_its_distances_scales_and_histogram() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox
        .run(&["patches", "cube.xyz", "-o", "a.json", "--method", "projection", "--stages", "steps"])
        .expect(0);
    let table = counted(&sandbox, "steps");
    assert_eq!(names(&table)[..2], ["projection", "penalties"]);
    let file = sandbox.read("steps/projection.ply");
    let header = String::from_utf8_lossy(&file[..1200]).into_owned();
    for column in ["uchar class", "float score", "float distance_8", "float radius_32", "uchar scale"] {
        assert!(header.contains(&format!("property {column}\n")), "{header}");
    }
    let sum = |key: &str| table[key].as_array().unwrap().iter().map(|n| n.as_u64().unwrap()).sum::<u64>();
    assert_eq!((sum("at_scale"), sum("histogram")), (386, 386));
    assert_eq!(table["histogram"].as_array().unwrap().len(), 256);
    // All points above the threshold are marked: the 12 edges and 8 corners of the cube.
    assert_eq!(table["marked"], 386 - 6 * 7 * 7);
    assert!(table["threshold"].as_f64().unwrap() <= table["cut_of_two"].as_f64().unwrap());
}

#[test]
fn section_has_its_slabs_and_every_round_of_hull_and_circles() {
    let sandbox = Sandbox::new();
    let scan = ["section", "--sample", "bracket", "--axis", "y", "--count", "2"];
    let args = [&scan[..], &["--no-carry", "-o"]].concat();
    for outline in ["hull", "voronoi"] {
        let plain = format!("{outline}-plain.json");
        let (drawn, folder) = (format!("{outline}.json"), format!("{outline}-steps"));
        let choice = ["--outline", outline];
        sandbox.run(&[&args, &[plain.as_str()][..], &choice].concat()).expect(0);
        let more = [drawn.as_str(), "--stages", folder.as_str()];
        sandbox.run(&[&args, &more[..], &choice].concat()).expect(0).says(&["slab.ply", "stages.json"]);
        assert_eq!(sandbox.read(&plain), sandbox.read(&drawn));
        let table = counted(&sandbox, &folder);
        assert_eq!((&table["outline"], &table["slices"]), (&outline.into(), &2.into()));
        let names = names(&table);
        assert_eq!(names[..2], ["slab", "projection"]);
        assert_eq!(names.contains(&"circles"), outline == "voronoi");
        // Every round adds feature points, and the last has those of the result.
        let rounds = table["stages"].as_array().unwrap().iter();
        let vertices = |row: &Value| row["vertices"].as_u64().unwrap();
        let rounds = rounds.filter(|row| row["name"].as_str().unwrap().starts_with(outline));
        let rounds: Vec<u64> = rounds.map(vertices).collect();
        assert!(rounds.len() > 2 && rounds.is_sorted_by(|a, b| a < b), "{rounds:?}");
        let last = &table["stages"][names.len() - 1];
        assert_eq!((&last["name"], vertices(last)), (&"outlines".into(), rounds[rounds.len() - 1]));
    }
    sandbox.run(&[&args[..], &["c.json", "--stages", "middle"]].concat()).expect(0);
    assert_eq!(names(&counted(&sandbox, "middle")), ["slab", "projection", "outlines"]);
}
