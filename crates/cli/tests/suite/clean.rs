//! `lineament clean`, and clutter in the outputs of `classify`.

use crate::common::Sandbox;
use lineament::Column;
use lineament::shapes::Rng;
use lineament_io::{ReadOptions, Scan, read};

/// A sheet of 40 by 40 points and 15 strays above it as CSV with a number for each point; every 100th point is a stray.
fn table() -> String {
    let mut rng = Rng::new(3);
    let mut text = String::from("x,y,z,number\n");
    let mut sheet = 0;
    for i in 0..1615 {
        let [x, y, z] = if stray(i) {
            [rng.between(0.0, 40.0), rng.between(0.0, 40.0), 8.0 + 5.0 * f64::from(i / 100)]
        } else {
            sheet += 1;
            let [x, y] = [(sheet - 1) % 40, (sheet - 1) / 40].map(|c| f64::from(c) + 0.2 * rng.uniform());
            [x, y, 0.0]
        };
        text += &format!("{x:?},{y:?},{z:?},{i}\n");
    }
    text
}

fn stray(i: i32) -> bool {
    i % 100 == 0 && i > 0 && i < 1600
}

fn scan(sandbox: &Sandbox, name: &str) -> Scan {
    read(&sandbox.path(name), &ReadOptions { attributes: true, ..Default::default() }).unwrap()
}

fn column(scan: &Scan, name: &str) -> Vec<f64> {
    let found = scan.cloud.attributes.iter().find(|a| a.name == name);
    match &found.unwrap_or_else(|| panic!("no `{name}`")).values {
        Column::U8(v) => v.iter().map(|&x| x.into()).collect(),
        Column::I16(v) => v.iter().map(|&x| x.into()).collect(),
        Column::U16(v) => v.iter().map(|&x| x.into()).collect(),
        Column::I32(v) => v.iter().map(|&x| x.into()).collect(),
        Column::F32(v) => v.iter().map(|&x| x.into()).collect(),
        Column::F64(v) => v.clone(),
        other => panic!("{name}: {other:?}"),
    }
}

/// The numbers of the points that the sheet has, or of all.
fn numbers(all: bool) -> Vec<f64> {
    (0..1615).filter(|&i| all || !stray(i)).map(f64::from).collect()
}

#[test]
fn clean_leaves_out_clutter_and_keeps_the_attributes_of_all_other_points_in_every_format() {
    let sandbox = Sandbox::new();
    sandbox.write("sheet.csv", table());
    let names = ["a.csv", "a.xyz", "a.ply", "a.pcd", "a.las", "a.laz", "a.npz", "a.parquet", "a.npy"];
    let outputs = names.map(|name| ["-o", name]).concat();
    sandbox
        .run(&[["clean", "sheet.csv"].as_slice(), &outputs].concat())
        .expect(0)
        .says(&["1,615 points read", "1,600 points on surfaces, 15 points of clutter left out"]);
    let first = scan(&sandbox, "a.csv").cloud.positions;
    for name in names {
        let found = scan(&sandbox, name);
        assert_eq!(found.cloud.len(), 1600, "{name}");
        let near = |(a, b): (&[f64; 3], &[f64; 3])| a.iter().zip(b).all(|(x, y)| (x - y).abs() < 1e-6);
        assert!(found.cloud.positions.iter().zip(&first).all(near), "{name}");
        if name != "a.npy" {
            assert_eq!(column(&found, "number"), numbers(false), "{name}");
        }
        assert!(!found.cloud.attributes.iter().any(|a| a.name == "class"), "{name}");
    }
}

#[test]
fn clean_labels_clutter_where_all_points_are_kept() {
    let sandbox = Sandbox::new();
    sandbox.write("sheet.csv", table());
    sandbox
        .run(&["clean", "sheet.csv", "--label", "-o", "a.ply", "-o", "a.npy", "-o", "a.las", "-o", "a.csv"])
        .expect(0)
        .says(&["15 points of clutter labelled"]);
    let expected: Vec<f64> = (0..1615).map(|i| if stray(i) { 4.0 } else { 0.0 }).collect();
    for name in ["a.ply", "a.las", "a.csv"] {
        let found = scan(&sandbox, name);
        assert_eq!(column(&found, "class"), expected, "{name}");
        assert_eq!(column(&found, "number"), numbers(true), "{name}");
    }
    let noise: Vec<f64> = expected.iter().map(|&class| if class == 4.0 { 7.0 } else { 0.0 }).collect();
    assert_eq!(column(&scan(&sandbox, "a.las"), "classification"), noise);
    let npy = sandbox.read("a.npy");
    let bytes: Vec<f64> = npy[npy.len() - 1615..].iter().map(|&b| b.into()).collect();
    assert_eq!(bytes, expected);
}

#[test]
fn clean_keeps_the_columns_of_a_classified_input() {
    let sandbox = Sandbox::new();
    sandbox.write("sheet.csv", table());
    sandbox.run(&["classify", "sheet.csv", "-o", "marked.ply", "-o", "marked.npy"]).expect(0);
    let npy = sandbox.read("marked.npy");
    let classes = &npy[npy.len() - 1615..];
    assert!((0..1615).all(|i| (classes[i as usize] == 4) == stray(i)), "clutter has class 4");
    sandbox.run(&["clean", "marked.ply", "-o", "clean.ply"]).expect(0);
    let cleaned = scan(&sandbox, "clean.ply");
    let kept: Vec<f64> = (0..1615).filter(|&i| !stray(i)).map(|i| classes[i as usize].into()).collect();
    assert_eq!(column(&cleaned, "class"), kept);
    assert_eq!(column(&cleaned, "score").len(), 1600);
    sandbox.run(&["clean", "marked.ply", "-o", "label.ply", "--label"]).expect(0);
    let labelled = scan(&sandbox, "label.ply");
    assert_eq!(column(&labelled, "input_class").len(), 1615);
    assert_eq!(column(&labelled, "class").iter().filter(|&&class| class == 4.0).count(), 15);
}

#[test]
fn clean_takes_several_inputs_and_refuses_a_method() {
    let sandbox = Sandbox::new();
    sandbox.write("a.csv", table());
    sandbox.write("b.csv", table());
    std::fs::create_dir(sandbox.path("out")).unwrap();
    sandbox.run(&["clean", "a.csv", "b.csv", "-o", "out/{stem}.laz", "-o", "out/"]).expect(0);
    for name in ["out/a.laz", "out/b.laz", "out/a.clean.ply", "out/b.clean.ply"] {
        assert_eq!(scan(&sandbox, name).cloud.len(), 1600, "{name}");
    }
    sandbox.run(&["clean", "a.csv", "-o", "c.ply", "--method", "segments"]).expect(2).says(&["no lines"]);
    sandbox.run(&["clean", "a.csv", "-o", "c.dxf"]).expect(2);
    sandbox.run(&["clean", "a.csv"]).expect(2);
}
