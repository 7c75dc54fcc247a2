//! What surveyors feed it: reference systems, units of drawings, point numbers, noise, heights.

use crate::common::{Sandbox, cube};

/// The cube at map coordinates, a metre a side or so.
fn placed() -> Vec<[f64; 3]> {
    cube().into_iter().map(|[x, y, z]| [500_000.0 + x, 5_400_000.0 + y, 310.0 + z]).collect()
}

/// The number behind `$INSUNITS` of a drawing.
fn unit(drawing: &str) -> &str {
    drawing.split("$INSUNITS\n70\n").nth(1).unwrap().lines().next().unwrap().trim()
}

#[test]
fn a_system_that_is_asked_for_is_in_every_output_that_can_hold_it() {
    let sandbox = Sandbox::new();
    sandbox.write_points("a.xyz", &placed());
    let outputs = ["-o", "a.dxf", "-o", "a.geojson", "-o", "a.json"];
    let run = sandbox.run(&[&["extract", "a.xyz", "--crs", "EPSG:31467"], &outputs[..]].concat()).expect(0);
    assert!(!run.stderr.contains("warning"), "{}", run.stderr);
    assert_eq!(unit(&sandbox.read_text("a.dxf")), "6");
    assert!(sandbox.read_text("a.geojson").contains("urn:ogc:def:crs:EPSG::31467"));
    sandbox
        .run(&["section", "a.xyz", "--crs", "2056", "--count", "3", "-o", "b.geojson", "-o", "b.dxf"])
        .expect(0);
    assert_eq!(unit(&sandbox.read_text("b.dxf")), "6");
    assert!(sandbox.read_text("b.geojson").contains("EPSG::2056"));
    sandbox.run(&["clean", "a.xyz", "--crs", "EPSG:25832", "-o", "c.las"]).expect(0);
    let told = sandbox.run(&["info", "c.las"]).expect(0).text();
    assert!(told.contains("EPSG:25832"), "{told}");
    sandbox
        .run(&["extract", "c.las", "--crs", "EPSG:2056", "-o", "d.json"])
        .expect(0)
        .says(&["EPSG:25832", "EPSG:2056"]);
    sandbox.run(&["extract", "a.xyz", "--crs", "EPSG:99999"]).expect(2).says(&["99999", "EPSG:25832"]);
}

#[test]
fn drawings_without_a_unit_are_a_warning_with_the_remedy() {
    let sandbox = Sandbox::new();
    sandbox.write_points("a.xyz", &placed());
    let run = sandbox.run(&["extract", "a.xyz", "-o", "a.dxf", "-o", "b.dxf"]).expect(0);
    assert_eq!(run.stderr.matches("states no unit").count(), 1, "{}", run.stderr);
    run.says(&["warning: a.dxf states no unit", "--unit"]);
    sandbox
        .run(&["section", "a.xyz", "--count", "3", "-o", "c.dxf"])
        .expect(0)
        .says(&["c.dxf states no unit"]);
    let run = sandbox.run(&["extract", "a.xyz", "-o", "a.dxf", "--unit", "us-ft"]).expect(0);
    assert!(!run.stderr.contains("states no unit"), "{}", run.stderr);
    assert_eq!(unit(&sandbox.read_text("a.dxf")), "21");
}

#[test]
fn point_numbers_are_told_and_columns_can_be_named() {
    let sandbox = Sandbox::new();
    let rows: Vec<String> =
        placed().iter().enumerate().map(|(i, [x, y, z])| format!("{} {x} {y} {z}\n", i + 1)).collect();
    sandbox.write("numbered.txt", rows.concat());
    sandbox.run(&["info", "numbered.txt"]).expect(0);
    assert!(sandbox.run(&["info", "numbered.txt"]).text().contains("--columns 2,3,4"));
    sandbox.write("named.txt", format!("Nr R-Wert H-Wert Kote\n{}", rows.concat()));
    for (name, columns) in [("numbered.txt", "2,3,4"), ("named.txt", "R-Wert,H-Wert,Kote")] {
        let run = sandbox.run(&["extract", name, "--columns", columns, "-o", "a.json"]).expect(0);
        assert!(!run.stderr.contains("warning"), "{}", run.stderr);
        run.says(&["386 points read", "8 junctions"]);
    }
    sandbox.run(&["extract", "named.txt"]).expect(3).says(&["R-Wert", "--columns"]);
    sandbox.run(&["extract", "named.txt", "--columns", "2,3"]).expect(2).says(&["2,3,4"]);
}

#[test]
fn sections_beside_the_scan_say_where_it_lies() {
    let sandbox = Sandbox::new();
    sandbox.write_points("a.xyz", &placed());
    let run = sandbox.run(&["section", "a.xyz", "--at=-50", "--unit", "m", "-o", "a.dxf"]).expect(0);
    run.says(&["warning: no contour: the slices lie at -50", "from 309.50 to 310.50", "along the axis"]);
    let run = sandbox
        .run(&["section", "a.xyz", "--at=0.5", "--from", "lowest", "--unit", "m", "-o", "a.dxf"])
        .expect(0);
    assert!(!run.stderr.contains("warning"), "{}", run.stderr);
    run.says(&["lowest point at 309.50"]);
}

#[test]
fn noise_in_a_las_file_is_left_out_of_lines_and_kept_where_points_are_labelled() {
    use lineament::{Attribute, Cloud, Column};
    use lineament_io::{PointFormat, PointTable, write_points_to};
    let sandbox = Sandbox::new();
    let mut points = placed();
    let real = points.len();
    points.extend((0..40).map(|i| [500_000.5, 5_400_000.5, 320.0 + f64::from(i)]));
    let classes = (0..points.len()).map(|i| if i < real { 2 } else { 7 }).collect();
    let mut cloud = Cloud::new(points);
    cloud.attributes.push(Attribute { name: "classification".into(), values: Column::U8(classes) });
    let mut bytes = Vec::new();
    let table = PointTable { cloud: &cloud, classes: &[], scores: &[], las: None };
    write_points_to(&mut bytes, PointFormat::Las, &table).unwrap();
    sandbox.write("a.las", bytes);
    let run = sandbox.run(&["extract", "a.las", "-o", "a.json"]).expect(0);
    run.says(&["386 points read", "left out: 40 points", "--all-points"]);
    for keep in [&["--all-points"][..], &["--class", "2,7"]] {
        let run = sandbox.run(&[&["extract", "a.las", "-o", "a.json"], keep].concat()).expect(0);
        run.says(&["426 points read"]);
    }
    sandbox
        .run(&["section", "a.las", "--count", "3", "-o", "a.json"])
        .expect(0)
        .says(&["left out: 40 points"]);
    sandbox.run(&["clean", "a.las", "--label", "-o", "b.las"]).expect(0).says(&["426 points read"]);
    sandbox.run(&["extract", "a.las", "--bounds", "0,0,319,1e7,1e7,1e3", "-o", "a.json"]).expect(3);
}
