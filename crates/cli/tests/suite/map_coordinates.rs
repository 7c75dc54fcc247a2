//! LAS at map coordinates: the lines lie where those of the same cloud at the origin lie.

use crate::common::{Sandbox, json};
use lineament::Cloud;
use lineament::shapes::{Sampling, Scan, Shape, bent_sheet, bracket, sheet_with_hole, wedge};
use lineament_io::{LasFrame, LasRecord, PointFormat, PointTable, write_points_to};

/// A corner of UTM zone 32.
const CORNER: [f64; 3] = [665_187.0, 5_648_349.0, 241.0];
/// The step of the stored integers, a tenth of a millimetre.
const STEP: f64 = 1e-4;

/// A LAS file of these points, with the name of a reference system.
fn las(points: &[[f64; 3]], offset: [f64; 3], format: PointFormat) -> Vec<u8> {
    let wkt = b"PROJCS[\"ETRS89 / UTM zone 32N\",GEOGCS[\"ETRS89\"]]\0".to_vec();
    let record = LasRecord { user: "LASF_Projection".into(), id: 2112, data: wkt };
    let frame = LasFrame {
        minor: 4,
        scale: [STEP; 3],
        offset,
        point_format: 6,
        records: vec![record],
        ..LasFrame::default()
    };
    let cloud = Cloud::new(points.iter().map(|p| std::array::from_fn(|a| p[a] + offset[a])).collect());
    let classes = vec![0; points.len()];
    let table = PointTable { cloud: &cloud, classes: &classes, scores: &[], las: Some(&frame) };
    let mut bytes = Vec::new();
    write_points_to(&mut bytes, format, &table).unwrap();
    bytes
}

/// All points of all strips, in order, and how they are divided.
fn lines(sandbox: &Sandbox, name: &str) -> (Vec<[f64; 3]>, Vec<(String, usize)>) {
    let root = json(&sandbox.path(name));
    let strips = root["strips"].as_array().unwrap();
    let point = |p: &serde_json::Value| [0, 1, 2].map(|a| p[a].as_f64().unwrap());
    let points = |s: &serde_json::Value| s["points"].as_array().unwrap().clone();
    let all = strips.iter().flat_map(points).map(|p| point(&p)).collect();
    let parts = strips.iter().map(|s| (s["kind"].to_string(), points(s).len())).collect();
    (all, parts)
}

#[test]
fn lines_at_utm_coordinates_are_those_at_the_origin_to_a_millionth_of_a_metre() {
    let shapes: [(&str, Shape); 4] = [
        ("bracket", bracket()),
        ("wedge", wedge(90.0)),
        ("bent sheet", bent_sheet(60.0)),
        ("sheet with a hole", sheet_with_hole()),
    ];
    for (index, (name, shape)) in shapes.into_iter().enumerate() {
        let scan = Scan::new(Sampling::BlueNoise { count: 3000 }).noise(0.1).seed(index as u64);
        let points = shape.sample(&scan).cloud.positions;
        let sandbox = Sandbox::new();
        let format = if index % 2 == 0 { PointFormat::Las } else { PointFormat::Laz };
        sandbox.write("origin.las", las(&points, [0.0; 3], format));
        sandbox.write("utm.las", las(&points, CORNER, format));
        for input in ["origin", "utm"] {
            let (las, out) = (format!("{input}.las"), format!("{input}.json"));
            sandbox.run(&["extract", &las, "-o", &out, "-o", &format!("{input}.geojson")]).expect(0);
        }
        let ((here, parts), (there, same)) = (lines(&sandbox, "origin.json"), lines(&sandbox, "utm.json"));
        assert!(!parts.is_empty() && parts == same, "{name}: {parts:?} became {same:?}");
        let apart = |a: &[f64; 3], b: &[f64; 3]| {
            (0..3).map(|axis| (a[axis] + CORNER[axis] - b[axis]).powi(2)).sum::<f64>().sqrt()
        };
        let worst = here.iter().zip(&there).map(|(a, b)| apart(a, b)).fold(0.0, f64::max);
        assert!(worst < 1e-6, "{name}: {worst:e} m");
        println!("{name}: {} points of lines, at most {worst:.1e} m apart", here.len());
        let geojson = json(&sandbox.path("utm.geojson"));
        assert_eq!(geojson["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::25832");
    }
}

#[test]
fn classified_las_keeps_the_grid_and_the_reference_system() {
    let sandbox = Sandbox::new();
    let points = wedge(90.0).sample(&Scan::new(Sampling::BlueNoise { count: 800 })).cloud.positions;
    sandbox.write("utm.las", las(&points, CORNER, PointFormat::Las));
    sandbox.run(&["classify", "utm.las", "-o", "marked.laz", "-o", "marked.las"]).expect(0);
    let options = lineament_io::ReadOptions::default();
    let read = |name: &str| lineament_io::read(&sandbox.path(name), &options).unwrap();
    let input = read("utm.las");
    for name in ["marked.laz", "marked.las"] {
        let output = read(name);
        assert_eq!(output.cloud.positions, input.cloud.positions, "{name}");
        assert_eq!(output.crs.as_deref(), Some("ETRS89 / UTM zone 32N"), "{name}");
        let (was, is) = (input.las.as_ref().unwrap(), output.las.unwrap());
        assert_eq!(
            (was.scale, was.offset, was.point_format),
            (is.scale, is.offset, is.point_format),
            "{name}"
        );
    }
}
