//! GeoPackage: a database that SQLite finds whole, with every coordinate.

use crate::common::network;
use lineament::curve::BSpline;
use lineament::{Network, Strip, StripKind};
use lineament_io::{NetworkContext, NetworkFormat, write_network_to};
use std::process::Command;

fn written(network: &Network, context: &NetworkContext) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_network_to(&mut bytes, NetworkFormat::GeoPackage, network, context).unwrap();
    bytes
}

/// What Python's SQLite says to a statement of a database; `None`, with a note, where there is no Python.
fn sqlite(bytes: &[u8], statement: &str) -> Option<String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.gpkg");
    std::fs::write(&path, bytes).unwrap();
    let script = "import sqlite3, sys; print(sqlite3.connect(sys.argv[1]).execute(sys.argv[2]).fetchall())";
    let run = Command::new("python3").args(["-c", script]).arg(&path).arg(statement).output();
    let Ok(run) = run else {
        println!("skipped: there is no python3, whose SQLite would look at the file");
        return None;
    };
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    Some(String::from_utf8(run.stdout).unwrap().trim().into())
}

/// Strips of so many points each.
fn strips(counts: impl Iterator<Item = usize>) -> Network {
    let point = |i: usize| [665_187.0 + i as f64 / 3.0, 5_648_349.0, -(i as f64)];
    let strip = |count: usize| Strip {
        kind: StripKind::Border,
        closed: true,
        start: None,
        end: None,
        points: (0..count).map(point).collect(),
        curve: BSpline::default(),
        sources: vec![0],
        fold_deg: Some(90.0),
        evidence: None,
        curves: Vec::new(),
        deviation: 0.0,
        confidence: 1.0,
        sigma: Vec::new(),
        blend: None,
    };
    Network { nodes: Vec::new(), strips: counts.map(strip).collect() }
}

#[test]
fn the_header_is_that_of_a_geopackage() {
    let bytes = written(&network(), &NetworkContext::default());
    assert!(bytes.starts_with(b"SQLite format 3\0") && bytes.len().is_multiple_of(4096));
    assert_eq!(&bytes[68..72], b"GPKG");
    assert_eq!(u32::from_be_bytes(bytes[28..32].try_into().unwrap()) as usize, bytes.len() / 4096);
    assert_eq!(bytes, written(&network(), &NetworkContext::default()));
}

#[test]
fn strips_nodes_and_the_reference_system_are_in_their_tables() {
    let context = NetworkContext {
        crs: Some("EPSG:25832".into()),
        crs_wkt: Some("PROJCS[\"ETRS89 / UTM zone 32N\"]".into()),
        ..NetworkContext::default()
    };
    let bytes = written(&network(), &context);
    for (statement, expected) in [
        ("PRAGMA integrity_check", "[('ok',)]"),
        ("PRAGMA foreign_key_check", "[]"),
        (
            "SELECT fid, kind, closed, start_node, end_node FROM lines",
            "[(1, 'crease', 0, 1, 2), (2, 'crease', 0, 1, 1), (3, 'border', 1, None, None)]",
        ),
        ("SELECT fid, kind, degree FROM nodes", "[(1, 'junction', 3), (2, 'end', 1)]"),
        ("SELECT srs_id FROM gpkg_spatial_ref_sys ORDER BY srs_id", "[(-1,), (0,), (4326,), (25832,)]"),
        (
            "SELECT definition FROM gpkg_spatial_ref_sys WHERE srs_id = 25832",
            "[('PROJCS[\"ETRS89 / UTM zone 32N\"]',)]",
        ),
        (
            "SELECT table_name, srs_id, max_y FROM gpkg_contents WHERE identifier = 'lines'",
            "[('lines', 25832, 5648349.895035)]",
        ),
        (
            "SELECT geometry_type_name, z FROM gpkg_geometry_columns WHERE table_name = 'lines'",
            "[('LINESTRING', 1)]",
        ),
    ] {
        let Some(said) = sqlite(&bytes, statement) else { return };
        assert_eq!(said, expected, "{statement}");
    }
}

#[test]
fn rows_of_every_length_and_tables_of_every_depth_are_whole() {
    // Around the lengths at which a row no longer fits its page, and enough rows for three levels.
    let lengths = strips((2..400).chain([5_000, 100_000]));
    let many = strips((0..60_000).map(|i| 2 + i % 3));
    for (network, points) in [(lengths, 399 * 400 / 2 - 1 + 398 + 105_002), (many, 60_000 * 4)] {
        let bytes = written(&network, &NetworkContext::default());
        let Some(said) = sqlite(&bytes, "PRAGMA integrity_check") else { return };
        assert_eq!(said, "[('ok',)]");
        let sums = "SELECT count(*), sum((length(geom) - 65) / 24), max(fid) FROM lines";
        let count = network.strips.len();
        assert_eq!(sqlite(&bytes, sums).unwrap(), format!("[({count}, {points}, {count})]"));
    }
}

#[test]
fn an_empty_network_is_a_valid_file() {
    let bytes = written(&Network::default(), &NetworkContext::default());
    let Some(said) = sqlite(&bytes, "PRAGMA integrity_check") else { return };
    assert_eq!(said, "[('ok',)]");
    assert_eq!(sqlite(&bytes, "SELECT count(*) FROM lines, nodes").unwrap(), "[(0,)]");
}
