//! Networks written, and read back.

mod glb;
mod json;

use crate::common::network;
use lineament_io::{
    Error, NetworkContext, NetworkFormat, Parameter, network_format, write_network, write_network_to,
};
use serde_json::Value;
use std::path::Path;

fn context() -> NetworkContext {
    let parameter = |key: &str, value: &str| Parameter { key: key.into(), value: value.into() };
    NetworkContext {
        program_version: "0.1.0".into(),
        input_name: "a \"part\"\\\n\u{e9}.ply".into(),
        input_sha256: Some("00ff".into()),
        input_points: 5,
        method: "penalty".into(),
        parameters: vec![
            parameter("penalty.rho", "12"),
            parameter("penalty.alpha", "0.3"),
            parameter("penalty.robust", "true"),
            parameter("penalty.noise", "auto"),
        ],
        spacing: 0.1,
        noise: None,
        ..NetworkContext::default()
    }
}

fn written(format: NetworkFormat) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_network_to(&mut bytes, format, &network(), &context()).unwrap();
    bytes
}

fn floats(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

#[test]
fn obj_strips_share_the_vertices_of_their_nodes_and_loops_close() {
    let text = String::from_utf8(written(NetworkFormat::Obj)).unwrap();
    let vertices: Vec<[f64; 3]> = text
        .lines()
        .filter_map(|line| line.strip_prefix("v "))
        .map(|line| {
            let numbers: Vec<f64> = line.split(' ').map(|n| n.parse().unwrap()).collect();
            [numbers[0], numbers[1], numbers[2]]
        })
        .collect();
    let lines: Vec<Vec<usize>> = text
        .lines()
        .filter_map(|line| line.strip_prefix("l "))
        .map(|line| line.split(' ').map(|n| n.parse().unwrap()).collect())
        .collect();
    assert_eq!(lines, [vec![1, 3, 2], vec![1, 4, 5, 1], vec![6, 7, 8, 9, 6]]);
    for (strip, line) in network().strips.iter().zip(&lines) {
        for (point, &vertex) in strip.points.iter().zip(line) {
            assert_eq!(vertices[vertex - 1], *point);
        }
    }
}

#[test]
fn ply_edges_follow_the_strips() {
    let bytes = written(NetworkFormat::Ply);
    let scan = crate::common::from_bytes(&bytes, "network.ply", &Default::default()).unwrap();
    assert_eq!(scan.cloud.len(), 9);
    assert_eq!(scan.cloud.positions[1], network().nodes[1].position);
    assert_eq!(scan.ignored, ["element `edge`, 9 rows: not points"]);
    let edge = |i: usize| {
        let row = &bytes[bytes.len() - (9 - i) * 13..];
        let int = |at: usize| i32::from_le_bytes(row[at..at + 4].try_into().unwrap());
        (int(0), int(4), row[8], int(9))
    };
    assert_eq!(edge(0), (0, 2, 0, 0));
    assert_eq!(edge(1), (2, 1, 0, 0));
    assert_eq!(edge(8), (8, 5, 1, 2));
}

#[test]
fn the_extension_names_the_format_and_an_unknown_one_is_refused() {
    assert_eq!(network_format(Path::new("a.b/part.DXF")).unwrap(), NetworkFormat::Dxf);
    assert_eq!(network_format(Path::new("-")).unwrap(), NetworkFormat::Json);
    let error = network_format(Path::new("part.igs")).unwrap_err().to_string();
    assert!(error.contains("part.igs") && error.contains(".json"), "{error}");
}

#[test]
fn an_empty_network_is_written_in_every_format() {
    use NetworkFormat::{Csv, Dxf, GeoJson, Glb, Json, Obj, Ply, Step, Svg, Vtp};
    for format in [Json, Obj, Ply, Dxf, Step, Svg, GeoJson, Glb, Vtp, Csv] {
        let mut bytes = Vec::new();
        write_network_to(&mut bytes, format, &Default::default(), &Default::default()).unwrap();
        assert!(!bytes.is_empty());
    }
}

#[test]
fn a_network_that_dangles_is_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out.json");
    let mut broken = network();
    broken.strips[0].end = Some(9);
    let error = write_network(&path, &[], &broken, &context()).unwrap_err();
    assert!(
        matches!(&error, Error::Inconsistent { .. }) && error.to_string().contains("node 9 of 2"),
        "{error}"
    );
    broken = network();
    broken.strips[2].points[1][0] = f64::NAN;
    assert!(write_network(&path, &[], &broken, &context()).is_err());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn geojson_keeps_coordinates_and_names_the_reference_system() {
    let mut bytes = Vec::new();
    let context = NetworkContext { crs: Some("EPSG:25832".into()), ..context() };
    write_network_to(&mut bytes, NetworkFormat::GeoJson, &network(), &context).unwrap();
    let json: Value = serde_json::from_slice(&bytes).unwrap();
    assert_eq!(json["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::25832");
    let features = json["features"].as_array().unwrap();
    assert_eq!(features.len(), 5);
    assert_eq!(floats(&features[0]["geometry"]["coordinates"][2]), network().nodes[1].position);
    let loops = features[2]["geometry"]["coordinates"].as_array().unwrap();
    assert_eq!((loops.len(), &loops[0]), (5, &loops[4]));
    assert_eq!(features[3]["geometry"]["type"], "Point");
}

#[test]
fn svg_is_in_millimetres_and_closes_loops() {
    let text = String::from_utf8(written(NetworkFormat::Svg)).unwrap();
    assert!(text.contains("mm\" height=\"") && text.contains("viewBox"));
    assert_eq!(
        (text.matches("<path").count(), text.matches(" Z\"").count(), text.matches("<circle").count()),
        (3, 1, 2)
    );
    let context = NetworkContext { view: Some([0.0, 0.0, -1.0]), millimetres: Some(10.0), ..context() };
    let mut flat = network();
    flat.strips = vec![flat.strips[2].clone()];
    flat.nodes.clear();
    let mut bytes = Vec::new();
    write_network_to(&mut bytes, NetworkFormat::Svg, &flat, &context).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    assert!(text.contains("width=\"20.000mm\" height=\"20.000mm\""), "{text}");
    assert!(text.contains("M5.0000,15.0000 L15.0000,15.0000 L15.0000,5.0000 L5.0000,5.0000 Z"), "{text}");
}

#[test]
fn vtp_and_csv_have_every_point() {
    let vtp = String::from_utf8(written(NetworkFormat::Vtp)).unwrap();
    assert!(
        vtp.contains("NumberOfPoints=\"9\" NumberOfVerts=\"2\"") && vtp.contains("0 2 1 0 3 4 0 5 6 7 8 5"),
        "{vtp}"
    );
    assert!(vtp.contains("5648349.895035"));
    let csv = String::from_utf8(written(NetworkFormat::Csv)).unwrap();
    assert_eq!(csv.lines().count(), 12);
    let scan = crate::common::from_bytes(csv.as_bytes(), "lines.csv", &Default::default()).unwrap();
    let points: Vec<[f64; 3]> = network().strips.iter().flat_map(|s| s.points.clone()).collect();
    assert_eq!(scan.cloud.positions, points);
}
