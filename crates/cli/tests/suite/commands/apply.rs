//! Graphs, enriched clouds and meshes.

use crate::common::{Sandbox, cube, json};

#[test]
fn graph_writes_the_edges_that_cross_no_crease_and_with_all_the_others_too() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox.run(&["graph", "cube.xyz", "-o", "g.json", "-o", "g.ply", "-o", "g.csv"]).expect(0).says(&[
        "386 points read",
        "edges along the surface",
        "edges across a line",
        "g.json, g.ply, g.csv",
    ]);
    let graph = json(&sandbox.path("g.json"));
    assert_eq!(
        (graph["schema"].as_str(), graph["input"]["points"].as_u64()),
        (Some("lineament-graph/1"), Some(386))
    );
    let edges = graph["edges"].as_array().unwrap().len();
    assert_eq!(sandbox.read_text("g.csv").lines().count(), edges + 1);
    sandbox.run(&["graph", "cube.xyz", "-o", "all.json", "--all"]).expect(0);
    let all = json(&sandbox.path("all.json"));
    assert_eq!(all["edges"], graph["edges"]);
    assert!(graph["cut"].is_null() && all["cut"].as_array().unwrap().len() > 100);
    sandbox.run(&["graph", "cube.xyz", "-o", "g.dxf"]).expect(2).says(&[".npz"]);
}

#[test]
fn enrich_adds_points_on_the_lines_and_mesh_makes_edges_of_them() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox.run(&["enrich", "cube.xyz", "-o", "e.csv"]).expect(0).says(&["8 corners", "points added"]);
    let text = sandbox.read_text("e.csv");
    let rows: Vec<&str> = text.lines().collect();
    assert_eq!(rows[0], "x,y,z,class,added");
    assert!(rows[386].ends_with(",0") && rows[387].ends_with(",3,1"), "{} {}", rows[386], rows[387]);
    sandbox.run(&["enrich", "cube.xyz", "-o", "new.csv", "--added"]).expect(0);
    assert_eq!(sandbox.read_text("new.csv").lines().count(), rows.len() - 386);
    sandbox
        .run(&["mesh", "cube.xyz", "-o", "m.off", "-o", "m.glb"])
        .expect(0)
        .says(&["triangles over", "closed"]);
    assert!(sandbox.read_text("m.off").starts_with("OFF\n"));
    sandbox.run(&["mesh", "cube.xyz", "-o", "p.off", "--no-enrich"]).expect(0);
    assert!(sandbox.read("p.off").len() < sandbox.read("m.off").len());
    sandbox.run(&["mesh", "cube.xyz", "-o", "m.3mf"]).expect(2).says(&[".stl"]);
}
