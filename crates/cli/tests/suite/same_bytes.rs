//! Threads and the order of the points change no byte of the lines.

use crate::common::Sandbox;
use lineament::shapes::{
    Rng, Sampling, Scan, Shape, bent_sheet, cube_386, cylinders, sheet_with_hole, wedge,
};
use serde_json::Value;

fn clouds() -> Vec<(&'static str, Vec<[f64; 3]>)> {
    let scan = |shape: Shape, count, noise| {
        shape.sample(&Scan::new(Sampling::BlueNoise { count }).noise(noise).seed(3)).cloud.positions
    };
    vec![
        ("cube", cube_386().cloud.positions),
        ("bent sheet", scan(bent_sheet(60.0), 1500, 0.1)),
        ("sheet with a hole", scan(sheet_with_hole(), 2000, 0.0)),
        ("cylinders", scan(cylinders(1.0, 0.6), 3000, 0.0)),
        ("wedge", scan(wedge(90.0), 2500, 0.25)),
        ("rows and strays", rows_and_strays()),
    ]
}

/// A folded sheet in rows 1 apart along which points lie .2 apart, and strays above it.
fn rows_and_strays() -> Vec<[f64; 3]> {
    let mut rng = Rng::new(7);
    let rows = (0..15).flat_map(|row| (0..100).map(move |i| (row, i)));
    let mut points: Vec<[f64; 3]> = rows
        .map(|(row, i)| {
            let along = 0.2 * f64::from(i % 50);
            let y = f64::from(row) + 0.1 * rng.uniform();
            if i < 50 { [along, y, 0.0] } else { [10.0, y, along] }
        })
        .collect();
    points.extend((0..9).map(|i| [3.0, 12.0 - f64::from(i % 4), 30.0 + 6.0 * f64::from(i)]));
    points
}

/// The bytes of the OBJ and the JSON file that come of these points.
fn written(points: &[[f64; 3]], threads: &str) -> [Vec<u8>; 2] {
    written_by("extract", ["a.obj", "a.json"], points, threads)
}

/// The bytes of the files that a command makes of these points.
fn written_by(command: &str, names: [&str; 2], points: &[[f64; 3]], threads: &str) -> [Vec<u8>; 2] {
    let sandbox = Sandbox::new();
    sandbox.write_points("cloud.xyz", points);
    let [a, b] = names;
    sandbox.run(&[command, "cloud.xyz", "-o", a, "-o", b, "--threads", threads]).expect(0);
    names.map(|name| sandbox.read(name))
}

/// The JSON document in the numbering of the cloud before it was put in this order; without the input's checksum.
fn unordered(bytes: &[u8], order: &[u32]) -> Value {
    let mut root: Value = serde_json::from_slice(bytes).unwrap();
    assert!(root["input"].as_object_mut().unwrap().remove("sha256").is_some());
    let renumber = |value: &mut Value| {
        *value = order[usize::try_from(value.as_u64().unwrap()).unwrap()].into();
    };
    for node in root["nodes"].as_array_mut().unwrap() {
        renumber(&mut node["source"]);
    }
    for strip in root["strips"].as_array_mut().unwrap() {
        strip["sources"].as_array_mut().unwrap().iter_mut().for_each(renumber);
    }
    root
}

fn shuffled(count: usize, seed: u64) -> Vec<u32> {
    let mut rng = Rng::new(seed);
    let mut order: Vec<u32> = (0..count as u32).collect();
    for i in (1..count).rev() {
        order.swap(i, rng.below(i as u64 + 1) as usize);
    }
    order
}

#[test]
fn obj_and_json_are_the_same_for_1_2_4_and_8_threads() {
    for (name, points) in clouds() {
        let one = written(&points, "1");
        for threads in ["2", "4", "8"] {
            assert!(one == written(&points, threads), "{name} differs with {threads} threads");
        }
    }
}

#[test]
fn order_of_the_points_changes_no_byte_of_obj_and_the_numbering_alone_in_json() {
    for (name, points) in clouds() {
        let order: Vec<u32> = (0..points.len() as u32).collect();
        let [obj, json] = written(&points, "2");
        let json = unordered(&json, &order);
        for seed in 1..=20 {
            let order = shuffled(points.len(), seed);
            let moved: Vec<[f64; 3]> = order.iter().map(|&i| points[i as usize]).collect();
            let [other_obj, other_json] = written(&moved, "2");
            assert!(obj == other_obj, "{name}: OBJ differs in order {seed}");
            assert_eq!(json, unordered(&other_json, &order), "{name}: JSON differs in order {seed}");
        }
    }
}

#[test]
fn patches_are_the_same_for_any_number_of_threads_and_any_order_of_the_points() {
    for (name, points) in clouds() {
        let written =
            |points: &[[f64; 3]], threads| written_by("patches", ["a.dxf", "a.json"], points, threads);
        let order: Vec<u32> = (0..points.len() as u32).collect();
        let one = written(&points, "1");
        for threads in ["2", "4", "8"] {
            assert!(one == written(&points, threads), "{name} differs with {threads} threads");
        }
        for seed in 1..=4 {
            let moved_order = shuffled(points.len(), seed);
            let moved: Vec<[f64; 3]> = moved_order.iter().map(|&i| points[i as usize]).collect();
            let [dxf, json] = written(&moved, "2");
            assert!(one[0] == dxf, "{name}: DXF differs in order {seed}");
            assert_eq!(unordered(&one[1], &order), unordered(&json, &moved_order), "{name}: order {seed}");
        }
    }
}
