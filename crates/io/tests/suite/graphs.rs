//! Neighbour graphs as files.

use crate::common::from_bytes;
use lineament::apply::CutGraph;
use lineament::{Attribute, Cloud, Column};
use lineament_io::{GraphFormat, GraphTable, NetworkContext, ReadOptions, write_graph, write_graph_to};

fn cloud() -> Cloud {
    let mut cloud = Cloud::new(vec![[0.0; 3], [3.0, 4.0, 0.0], [0.0, 0.0, 2.0]]);
    cloud.attributes.push(Attribute { name: "intensity".into(), values: Column::U16(vec![7, 8, 9]) });
    cloud
}

/// The bytes of the graph, with the edge that crosses a line or without.
fn bytes(format: GraphFormat, all: bool) -> Vec<u8> {
    let graph = CutGraph { edges: vec![[0, 1], [1, 2]], cut: vec![[0, 2]] };
    let (cloud, context) = (cloud(), NetworkContext::default());
    let mut bytes = Vec::new();
    write_graph_to(&mut bytes, format, &GraphTable { cloud: &cloud, graph: &graph, all, context: &context })
        .unwrap();
    bytes
}

#[test]
fn csv_has_a_row_for_each_edge_with_its_length() {
    let text = |all| String::from_utf8(bytes(GraphFormat::Csv, all)).unwrap();
    assert_eq!(text(false), format!("first,second,length\n0,1,5.0\n1,2,{:?}\n", 29f64.sqrt()));
    assert_eq!(
        text(true),
        format!("first,second,length,cut\n0,1,5.0,0\n1,2,{:?},0\n0,2,2.0,1\n", 29f64.sqrt())
    );
}

#[test]
fn ply_has_the_points_with_their_attributes_and_the_edges() {
    for (all, edges, row) in [(false, 2, 8), (true, 3, 9)] {
        let bytes = bytes(GraphFormat::Ply, all);
        let scan =
            from_bytes(&bytes, "g.ply", &ReadOptions { attributes: true, ..Default::default() }).unwrap();
        assert_eq!(scan.cloud, cloud());
        let head = String::from_utf8_lossy(&bytes);
        assert!(head.contains(&format!("element edge {edges}\n")), "{head}");
        let end = head.find("end_header\n").unwrap() + "end_header\n".len();
        assert_eq!(bytes.len(), end + 3 * (24 + 2) + edges * row);
        assert_eq!(bytes[bytes.len() - row..][..4], if all { 0i32 } else { 1 }.to_le_bytes());
    }
}

#[test]
fn json_and_npz_hold_the_edges_that_cross_a_line_where_they_are_asked_for() {
    let text = |all| String::from_utf8(bytes(GraphFormat::Json, all)).unwrap();
    assert!(text(false).contains("\"edges\": [[0, 1], [1, 2]]]".trim_end_matches(']')));
    assert!(!text(false).contains("cut") && text(true).contains("\"cut\": [[0, 2]]\n"));
    let scan = from_bytes(&bytes(GraphFormat::Npz, true), "g.npz", &ReadOptions::default()).unwrap();
    assert_eq!(scan.cloud.positions, cloud().positions);
    let has = |all, name: &str| {
        bytes(GraphFormat::Npz, all).windows(name.len()).any(|window| window == name.as_bytes())
    };
    assert!(
        has(false, "edges.npy") && has(false, "length.npy") && !has(false, "cut.npy") && has(true, "cut.npy")
    );
}

#[test]
fn an_edge_to_a_point_that_is_not_there_is_refused_with_its_number() {
    let (cloud, context) = (cloud(), NetworkContext::default());
    let graph = CutGraph { edges: vec![[1, 3]], cut: Vec::new() };
    let table = GraphTable { cloud: &cloud, graph: &graph, all: false, context: &context };
    let path = std::env::temp_dir().join(format!("lineament-graph-{}.csv", std::process::id()));
    let message = write_graph(&path, &[], &table).unwrap_err().to_string();
    assert!(message.contains("1 and 3 of 3"), "{message}");
    assert!(!path.exists());
}
