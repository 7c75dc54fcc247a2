//! Whatever reads goes through extraction, and what comes of it is written and reads back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use lineament::{Params, extract};
use lineament_io::{NetworkContext, NetworkFormat, PointFormat, PointTable, ReadOptions, Scan};
use lineament_io::{read_from, write_network_to, write_points_to};
use std::io::Cursor;

/// Points beyond which extraction takes too long to be tried often.
const MOST: usize = 500;

fn read(data: Vec<u8>) -> Option<Scan> {
    read_from(Box::new(Cursor::new(data)), "fuzz", &ReadOptions::default()).ok()
}

fuzz_target!(|data: &[u8]| {
    let Some(scan) = read(data.to_vec()) else { return };
    let cloud = scan.cloud;
    let classes = vec![0; cloud.len()];
    let table = PointTable { cloud: &cloud, classes: &classes, scores: &[], las: scan.las.as_ref() };
    for format in [PointFormat::Ply, PointFormat::Pcd] {
        let mut bytes = Vec::new();
        write_points_to(&mut bytes, format, &table).unwrap();
        let again = read(bytes).unwrap().cloud;
        let bits = |points: &[[f64; 3]]| points.iter().map(|p| p.map(f64::to_bits)).collect::<Vec<_>>();
        let finite = cloud.positions.iter().flatten().all(|c| c.is_finite());
        assert!(!finite || bits(&again.positions) == bits(&cloud.positions));
        assert_eq!(again.len(), cloud.len());
    }
    if cloud.len() > MOST {
        return;
    }
    let Ok(found) = extract(&cloud, &Params::default()) else { return };
    for format in [NetworkFormat::Json, NetworkFormat::Ply, NetworkFormat::Obj, NetworkFormat::Dxf] {
        let mut bytes = Vec::new();
        write_network_to(&mut bytes, format, &found.network, &NetworkContext::default()).unwrap();
        if format == NetworkFormat::Ply {
            let written: usize = found.network.strips.iter().map(|strip| strip.points.len()).sum();
            assert!(read(bytes).unwrap().cloud.len() <= written + found.network.nodes.len());
        }
    }
});
