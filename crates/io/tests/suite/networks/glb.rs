//! Binary glTF.

use super::{context, floats, written};
use crate::common::network;
use lineament::Network;
use lineament_io::{NetworkFormat, write_network_to};
use serde_json::Value;

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
