//! glTF, binary and JSON: nodes, sparse accessors, buffers in other files, and what is refused.

use crate::common::from_bytes;
use lineament_io::{Format, ReadOptions, Scan, read};
use serde_json::{Value, json};

/// Six points, then two sparse elements: their indices (two bytes each) and values.
fn bytes() -> Vec<u8> {
    let mut bytes: Vec<u8> = (0..18u8).flat_map(|v| f32::from(v).to_le_bytes()).collect();
    bytes.extend([1u16, 4].into_iter().flat_map(u16::to_le_bytes));
    bytes.extend([10f32, 20.0, 30.0, 40.0, 50.0, 60.0].into_iter().flat_map(f32::to_le_bytes));
    bytes
}

/// Two meshes of three points each, under a node that moves: one doubled, one turned by a quarter about z.
fn document() -> Value {
    json!({
        "asset": {"version": "2.0"},
        "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [
            {"children": [1, 2], "translation": [100, 0, 0]},
            {"mesh": 0, "scale": [2, 2, 2]},
            {"mesh": 1, "rotation": [0, 0, std::f64::consts::FRAC_1_SQRT_2, std::f64::consts::FRAC_1_SQRT_2]},
        ],
        "meshes": [
            {"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}]},
            {"primitives": [{"attributes": {"POSITION": 1, "NORMAL": 0}}]},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 3, "type": "VEC3"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 72},
            {"buffer": 0, "byteOffset": 72, "byteLength": 4},
            {"buffer": 0, "byteOffset": 76, "byteLength": 24},
        ],
        "buffers": [{"byteLength": 100}],
    })
}

const PLACES: [[f64; 3]; 6] = [
    [100.0, 2.0, 4.0],
    [106.0, 8.0, 10.0],
    [112.0, 14.0, 16.0],
    [90.0, 9.0, 11.0],
    [87.0, 12.0, 14.0],
    [84.0, 15.0, 17.0],
];

fn glb(document: &Value) -> Vec<u8> {
    let mut json = document.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let binary = bytes();
    let length = 28 + json.len() + binary.len();
    let mut glb = b"glTF".to_vec();
    for number in [2, length as u32, json.len() as u32] {
        glb.extend(number.to_le_bytes());
    }
    glb.extend(b"JSON");
    glb.extend(json);
    glb.extend((binary.len() as u32).to_le_bytes());
    glb.extend(b"BIN\0");
    glb.extend(binary);
    glb
}

fn with_uri(uri: &str) -> Vec<u8> {
    let mut document = document();
    document["buffers"][0]["uri"] = uri.into();
    document.to_string().into_bytes()
}

/// As a data URI. Six bits a letter.
fn embedded() -> Vec<u8> {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::from("data:application/octet-stream;base64,");
    for three in bytes().chunks(3) {
        let bits = three.iter().enumerate().fold(0u32, |bits, (i, &b)| bits | u32::from(b) << (16 - 8 * i));
        let letters = (0..4).map(|i| char::from(LETTERS[(bits >> (18 - 6 * i) & 63) as usize]));
        text.extend(letters.take(three.len() + 1).chain(std::iter::repeat('=')).take(4));
    }
    with_uri(&text)
}

fn check(scan: &Scan) {
    assert_eq!((scan.format, scan.cloud.len()), (Format::Gltf, 6));
    for (a, b) in scan.cloud.positions.iter().flatten().zip(PLACES.as_flattened()) {
        assert!((a - b).abs() < 1e-9, "{:?}", scan.cloud.positions);
    }
}

fn refusal(file: &[u8], name: &str) -> String {
    from_bytes(file, name, &ReadOptions::default()).unwrap_err().to_string()
}

#[test]
fn vertices_are_moved_by_their_nodes_wherever_the_bytes_are() {
    check(&from_bytes(&glb(&document()), "a.glb", &ReadOptions::default()).unwrap());
    check(&from_bytes(&embedded(), "by_content", &ReadOptions::default()).unwrap());
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("parts")).unwrap();
    std::fs::write(folder.path().join("parts/the points.bin"), bytes()).unwrap();
    let path = folder.path().join("a.gltf");
    std::fs::write(&path, with_uri("parts/the%20points.bin")).unwrap();
    check(&read(&path, &ReadOptions::default()).unwrap());
}

#[test]
fn a_file_without_scenes_is_read_from_the_nodes_that_no_other_holds_and_without_nodes_mesh_by_mesh() {
    let mut document = document();
    document.as_object_mut().unwrap().remove("scenes");
    document.as_object_mut().unwrap().remove("scene");
    check(&from_bytes(&glb(&document), "a.glb", &ReadOptions::default()).unwrap());
    document["nodes"] = json!([]);
    let scan = from_bytes(&glb(&document), "a.glb", &ReadOptions::default()).unwrap();
    assert_eq!((scan.cloud.len(), scan.cloud.positions[5]), (6, [15.0, 16.0, 17.0]));
}

#[test]
fn sparse_elements_replace_those_of_the_view_or_zeros() {
    let mut document = document();
    document["nodes"] = json!([{"mesh": 0}]);
    document["accessors"][0] = json!({
        "bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3",
        "sparse": {"count": 2, "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 2}},
    });
    let scan = from_bytes(&glb(&document), "a.glb", &ReadOptions::default()).unwrap();
    let expected = [[0, 1, 2], [10, 20, 30], [6, 7, 8], [9, 10, 11], [40, 50, 60], [15, 16, 17]];
    assert_eq!(scan.cloud.positions, expected.map(|p| p.map(f64::from)));
    document["accessors"][0].as_object_mut().unwrap().remove("bufferView");
    let scan = from_bytes(&glb(&document), "a.glb", &ReadOptions::default()).unwrap();
    assert_eq!(scan.cloud.positions[..2], [[0.0; 3], [10.0, 20.0, 30.0]]);
    document["accessors"][0]["count"] = 4.into();
    assert!(refusal(&glb(&document), "a.glb").contains("accessor 0 has a sparse element 4 of 4"));
}

#[test]
fn packed_meshes_and_bytes_that_are_elsewhere_are_refused_by_name() {
    for name in ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"] {
        let mut document = document();
        document["extensionsRequired"] = json!(["KHR_materials_unlit", name]);
        assert!(refusal(&glb(&document), "a.glb").contains(&format!("the extension `{name}`")));
    }
    let mut document = document();
    document["accessors"][1].as_object_mut().unwrap().remove("bufferView");
    assert!(refusal(&glb(&document), "a.glb").contains("accessor 1 has no bytes"));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.gltf");
    for (uri, expected) in [
        ("gone.bin", "byte 0: the buffer in `gone.bin`, which cannot be read"),
        ("../up.bin", "not below the folder"),
        ("/etc/hostname", "not below the folder"),
        ("https://example.org/a.bin", "not below the folder"),
        ("", "not below the folder"),
        (".", "no regular file"),
        ("data:;base64,QUJD%", "base64 has an"),
        ("data:text/plain,abc", "not in base64"),
        ("data:;base64,QUJD", "needs 36 bytes"),
    ] {
        std::fs::write(&path, with_uri(uri)).unwrap();
        let error = read(&path, &ReadOptions::default()).unwrap_err().to_string();
        assert!(error.contains(expected), "{uri}: {error}");
    }
    let stream = crate::common::from_pipe(&with_uri("a.bin"), "a.gltf", &ReadOptions::default()).unwrap_err();
    assert!(stream.to_string().contains("a stream has no folder"), "{stream}");
}

#[test]
fn json_of_millions_of_objects_and_claims_of_billions_of_vertices_take_no_memory() {
    let objects = format!("{{\"asset\": {{}}, \"nodes\": [{}{{}}]}}", "{},".repeat(200_000));
    let error = refusal(objects.as_bytes(), "a.gltf");
    assert!(error.contains("JSON of 200003 objects") && error.contains("--memory"), "{error}");
    for count in [1u64 << 31, 1 << 32, 1 << 63] {
        for remove in ["sparse", "bufferView"] {
            let mut document = document();
            let sparse = json!({"count": count, "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 2}});
            document["accessors"][0]["sparse"] = sparse;
            document["accessors"][0]["count"] = count.into();
            document["accessors"][0].as_object_mut().unwrap().remove(remove);
            assert!(refusal(&glb(&document), "a.glb").contains(&count.to_string()));
        }
    }
}

#[test]
fn json_that_is_no_gltf_is_not_taken_for_a_table() {
    let error = refusal(b"{\"type\": \"FeatureCollection\", \"features\": [1, 2, 3]}\n", "a.json");
    assert!(error.contains("format not recognised"), "{error}");
}
