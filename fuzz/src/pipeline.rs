//! Read, extract, write, read: a readable input gives a valid network or a named refusal, and every output reads
//! back the same.

use lineament::{Cloud, Extraction, Method, Params, check, extract};
use lineament_io::{
    Format, NetworkContext, NetworkFormat, PointFormat, PointTable, ReadOptions, Scan, read_from,
    write_network_to, write_points_to,
};
use std::io::Cursor;

/// Points that are taken of an input: enough for lines, few enough for many runs a second.
const MOST: usize = 400;

const NETWORKS: [NetworkFormat; 11] = [
    NetworkFormat::Json,
    NetworkFormat::Obj,
    NetworkFormat::Ply,
    NetworkFormat::Dxf,
    NetworkFormat::Step,
    NetworkFormat::Svg,
    NetworkFormat::GeoJson,
    NetworkFormat::GeoPackage,
    NetworkFormat::Glb,
    NetworkFormat::Vtp,
    NetworkFormat::Csv,
];

/// How exactly a format keeps coordinates.
#[derive(Clone, Copy, PartialEq)]
enum Keeps {
    Bits,
    /// To a step of its grid, and finite ones only.
    Grid,
}

const POINTS: [(PointFormat, Format, Keeps); 8] = [
    (PointFormat::Npz, Format::Npz, Keeps::Bits),
    (PointFormat::Parquet, Format::Parquet, Keeps::Bits),
    (PointFormat::Ply, Format::Ply, Keeps::Bits),
    (PointFormat::Pcd, Format::Pcd, Keeps::Bits),
    (PointFormat::Xyz, Format::Table, Keeps::Bits),
    (PointFormat::Csv, Format::Table, Keeps::Bits),
    (PointFormat::Las, Format::Las, Keeps::Grid),
    (PointFormat::Laz, Format::Las, Keeps::Grid),
];

/// The whole way of one input.
pub fn round_trip(data: &[u8]) {
    let Ok(mut scan) = again(data.to_vec(), None) else { return };
    cut(&mut scan.cloud);
    let method = [Method::Penalty, Method::Projection, Method::Segments][data.len() % 3];
    let params = Params { method, ..Params::default() };
    let Ok(found) = extract(&scan.cloud, &params) else { return };
    networks(&scan, &found);
    points(&scan, &found);
}

fn again(bytes: Vec<u8>, format: Option<Format>) -> Result<Scan, lineament_io::Error> {
    read_from(Box::new(Cursor::new(bytes)), "input", &ReadOptions { format, ..ReadOptions::default() })
}

fn cut(cloud: &mut Cloud) {
    let every = cloud.len().div_ceil(MOST).max(1);
    if every > 1 {
        cloud.positions = cloud.positions.iter().copied().step_by(every).collect();
        cloud.attributes.clear();
    }
}

/// A network keeps its invariants, every format takes it, and those that are read too give its vertices back.
fn networks(scan: &Scan, found: &Extraction) {
    check::network(&found.network).unwrap_or_else(|faults| panic!("{faults:?}"));
    check::sources(&found.network, scan.cloud.len()).unwrap_or_else(|faults| panic!("{faults:?}"));
    let context = NetworkContext { crs: scan.crs.clone(), ..NetworkContext::default() };
    for format in NETWORKS {
        let mut bytes = Vec::new();
        write_network_to(&mut bytes, format, &found.network, &context).expect("memory takes every byte");
        assert!(!bytes.is_empty());
        let format = match format {
            NetworkFormat::Ply => Format::Ply,
            NetworkFormat::Obj if !found.network.strips.is_empty() => Format::Obj,
            _ => continue,
        };
        let back = again(bytes, Some(format)).unwrap_or_else(|error| panic!("{error}"));
        let nodes = found.network.nodes.iter().map(|node| node.position);
        assert!(nodes.eq(back.cloud.positions.iter().take(found.network.nodes.len()).copied()));
    }
}

/// Classified points read back with their coordinates and classes.
fn points(scan: &Scan, found: &Extraction) {
    let classes: Vec<u8> = found.classes().into_iter().map(|class| class as u8).collect();
    let scores = found.scores();
    let table = PointTable { cloud: &scan.cloud, classes: &classes, scores: &scores, las: None };
    let finite = scan.cloud.positions.iter().flatten().all(|c| c.is_finite());
    for (written, read, keeps) in POINTS {
        let mut bytes = Vec::new();
        match write_points_to(&mut bytes, written, &table) {
            Err(_) if keeps == Keeps::Grid => continue,
            result => result.expect("memory takes every byte"),
        }
        if scan.cloud.is_empty() {
            continue;
        }
        let back = again(bytes, Some(read)).unwrap_or_else(|error| panic!("{written}: {error}"));
        assert_eq!(back.cloud.len(), scan.cloud.len(), "{written}");
        for (a, b) in scan.cloud.positions.iter().flatten().zip(back.cloud.positions.iter().flatten()) {
            let same = match keeps {
                Keeps::Bits => a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan(),
                Keeps::Grid => finite,
            };
            assert!(same, "{written}: {a:?} became {b:?}");
        }
        let class = back.cloud.attributes.iter().find(|a| a.name == "class");
        assert!(class.is_some_and(|a| a.values.len() == classes.len()), "{written}: the classes are gone");
    }
}
