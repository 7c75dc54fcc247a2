//! Networks written, and read back.

use crate::common::network;
use lineament::Network;
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

fn json() -> Value {
    serde_json::from_slice(&written(NetworkFormat::Json)).unwrap()
}

fn floats(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

#[test]
fn json_gives_every_number_back_bit_for_bit() {
    let (json, network) = (json(), network());
    assert_eq!(json["schema"], "lineament-network/1");
    for (node, there) in network.nodes.iter().zip(json["nodes"].as_array().unwrap()) {
        assert_eq!(floats(&there["position"]), node.position);
        assert_eq!(there["kind"], node.kind.name());
    }
    for (strip, there) in network.strips.iter().zip(json["strips"].as_array().unwrap()) {
        let points: Vec<Vec<f64>> = there["points"].as_array().unwrap().iter().map(floats).collect();
        assert_eq!(points, strip.points);
        assert_eq!(there["deviation"], strip.deviation);
        assert_eq!(there["length"], strip.length());
        assert_eq!(floats(&there["curve"]["knots"]), strip.curve.knots);
        assert_eq!(there["start"].as_u64(), strip.start.map(u64::from));
        assert_eq!(there["closed"], strip.closed);
    }
}

#[test]
fn json_says_what_was_read_and_how() {
    let json = json();
    assert_eq!(json["input"]["name"], context().input_name);
    assert_eq!(json["input"]["sha256"], "00ff");
    assert_eq!(json["parameters"]["penalty.rho"], 12);
    assert_eq!(json["parameters"]["penalty.alpha"], 0.3);
    assert_eq!(json["parameters"]["penalty.robust"], true);
    assert_eq!(json["parameters"]["penalty.noise"], "auto");
    assert_eq!(json["noise"], Value::Null);
}

/// Whether `value` has what `schema` requires, by the parts of JSON Schema that the project's schema uses.
fn conforms(value: &Value, schema: &Value, root: &Value, at: &str) {
    let schema = match schema["$ref"].as_str() {
        Some(path) => root.pointer(path.trim_start_matches('#')).unwrap_or_else(|| panic!("{path}")),
        None => schema,
    };
    if let Some(constant) = schema.get("const") {
        assert_eq!(value, constant, "{at}");
    }
    if let Some(allowed) = schema.get("enum") {
        assert!(allowed.as_array().unwrap().contains(value), "{at} is {value}");
    }
    let kinds = match &schema["type"] {
        Value::String(kind) => vec![kind.as_str()],
        Value::Array(kinds) => kinds.iter().map(|kind| kind.as_str().unwrap()).collect(),
        _ => vec![],
    };
    let is = |kind: &&str| match *kind {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_u64() || value.is_i64(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        other => panic!("type {other} at {at}"),
    };
    assert!(kinds.is_empty() || kinds.iter().any(is), "{at} is {value}, not {kinds:?}");
    if let (Some(object), Some(properties)) = (value.as_object(), schema["properties"].as_object()) {
        for required in schema["required"].as_array().into_iter().flatten() {
            assert!(object.contains_key(required.as_str().unwrap()), "{at} lacks {required}");
        }
        for (key, inner) in object {
            let known = properties.get(key).unwrap_or_else(|| panic!("{at}.{key} is not in the schema"));
            conforms(inner, known, root, &format!("{at}.{key}"));
        }
    }
    if let (Some(items), Some(inner)) = (value.as_array(), schema.get("items")) {
        for (i, item) in items.iter().enumerate() {
            conforms(item, inner, root, &format!("{at}[{i}]"));
        }
        assert!(items.len() as u64 >= schema["minItems"].as_u64().unwrap_or(0), "{at}");
        assert!(items.len() as u64 <= schema["maxItems"].as_u64().unwrap_or(u64::MAX), "{at}");
    }
}

#[test]
fn json_conforms_to_the_published_schema() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/schema-network-1.json");
    let schema: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    conforms(&json(), &schema, &schema, "file");
}

#[test]
fn the_schema_page_names_every_key() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/schema-network-1.md");
    let page = std::fs::read_to_string(path).unwrap();
    fn keys(value: &Value, into: &mut Vec<String>) {
        match value {
            Value::Object(object) => object.iter().for_each(|(key, inner)| {
                into.push(key.clone());
                keys(inner, into);
            }),
            Value::Array(items) => items.iter().for_each(|item| keys(item, into)),
            _ => {}
        }
    }
    let mut all = Vec::new();
    keys(&json(), &mut all);
    for key in all.iter().filter(|key| !key.contains('.')) {
        assert!(page.contains(&format!("`{key}`")), "{key}");
    }
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
fn dxf_has_a_layer_a_kind_and_marks_closed_polylines() {
    let text = String::from_utf8(written(NetworkFormat::Dxf)).unwrap();
    let pairs: Vec<(&str, &str)> = {
        let lines: Vec<&str> = text.lines().collect();
        lines.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect()
    };
    assert_eq!(pairs.last(), Some(&("0", "EOF")));
    let count = |code, value| pairs.iter().filter(|pair| **pair == (code, value)).count();
    assert_eq!(
        (count("0", "POLYLINE"), count("0", "SEQEND"), count("0", "VERTEX"), count("0", "POINT")),
        (3, 3, 11, 2)
    );
    assert_eq!((count("70", "8"), count("70", "9")), (2, 1));
    assert_eq!((count("8", "BORDER"), count("8", "JUNCTION"), count("8", "END")), (6, 1, 1));
}

#[test]
fn the_extension_names_the_format_and_an_unknown_one_is_refused() {
    assert_eq!(network_format(Path::new("a.b/part.DXF")).unwrap(), NetworkFormat::Dxf);
    assert_eq!(network_format(Path::new("-")).unwrap(), NetworkFormat::Json);
    let error = network_format(Path::new("part.step")).unwrap_err().to_string();
    assert!(error.contains("part.step") && error.contains(".json"), "{error}");
}

#[test]
fn an_empty_network_is_written_in_every_format() {
    use NetworkFormat::{Csv, Dxf, GeoJson, Glb, Json, Obj, Ply, Svg, Vtp};
    for format in [Json, Obj, Ply, Dxf, Svg, GeoJson, Glb, Vtp, Csv] {
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

/// The JSON of a GLB file and its binary part.
fn glb_parts(bytes: &[u8]) -> (Value, &[u8]) {
    let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((&bytes[..4], number(4), number(8)), (b"glTF" as &[u8], 2, bytes.len()));
    let json = number(12);
    assert_eq!((&bytes[16..20], &bytes[20 + json + 4..20 + json + 8]), (b"JSON" as &[u8], b"BIN\0" as &[u8]));
    assert_eq!((json % 4, 20 + json + 8 + number(20 + json)), (0, bytes.len()));
    (serde_json::from_slice(&bytes[20..20 + json]).unwrap(), &bytes[20 + json + 8..])
}

#[test]
fn glb_holds_every_segment_near_its_place() {
    let bytes = written(NetworkFormat::Glb);
    let (json, binary) = glb_parts(&bytes);
    let middle = floats(&json["nodes"][2]["translation"]);
    let view = |i: usize| {
        let (at, length) =
            (json["bufferViews"][i]["byteOffset"].as_u64(), json["bufferViews"][i]["byteLength"].as_u64());
        &binary[at.unwrap() as usize..(at.unwrap() + length.unwrap()) as usize]
    };
    let float = |i: usize| f32::from_le_bytes(view(0)[4 * i..4 * i + 4].try_into().unwrap());
    let node = network().nodes[1].position;
    for axis in 0..3 {
        assert!((f64::from(float(3 + axis)) + middle[axis] - node[axis]).abs() < 1.0);
    }
    let indices = |i: usize| {
        view(i).chunks_exact(4).map(|b| u32::from_le_bytes(b.try_into().unwrap())).collect::<Vec<_>>()
    };
    assert_eq!(indices(1), [0, 2, 2, 1, 0, 3, 3, 4, 4, 0]);
    assert_eq!(indices(2), [5, 6, 6, 7, 7, 8, 8, 5]);
    assert_eq!(json["meshes"].as_array().unwrap().len(), 2);
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

#[test]
fn glb_without_lines_is_a_scene_with_an_empty_node() {
    let mut loose = network();
    loose.strips.clear();
    for network in [Network::default(), loose] {
        let mut bytes = Vec::new();
        write_network_to(&mut bytes, NetworkFormat::Glb, &network, &context()).unwrap();
        let (json, binary) = glb_parts(&bytes);
        // The format forbids empty lists, and bytes that no buffer claims.
        assert_eq!(json["scenes"][0]["nodes"], serde_json::json!([0]));
        assert_eq!((json["nodes"].as_array().unwrap().len(), binary.len()), (1, 0));
    }
}

#[test]
fn glb_reads_back_with_y_up_to_single_precision_of_the_extent() {
    let mut near = network();
    near.strips.truncate(2);
    near.nodes[1].position = [3.0, 4.0, 5.0];
    near.strips[0].points[2] = [3.0, 4.0, 5.0];
    let mut bytes = Vec::new();
    write_network_to(&mut bytes, NetworkFormat::Glb, &near, &context()).unwrap();
    let scan = crate::common::from_bytes(&bytes, "lines.glb", &Default::default()).unwrap();
    assert_eq!(scan.cloud.len(), 5);
    for (read, node) in scan.cloud.positions.iter().zip(&near.nodes) {
        let [x, y, z] = node.position;
        assert!([x, z, -y].iter().zip(read).all(|(a, b)| (a - b).abs() < 1e-6), "{read:?}");
    }
    for length in (0..bytes.len()).step_by(5) {
        assert!(crate::common::from_bytes(&bytes[..length], "cut.glb", &Default::default()).is_err());
    }
    for at in 0..bytes.len() {
        for value in [0, 0xff, b'9'] {
            let mut changed = bytes.clone();
            changed[at] = value;
            let _ = crate::common::from_pipe(&changed, "changed.glb", &Default::default());
        }
    }
}
