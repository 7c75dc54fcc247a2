//! Networks of clouds in tiles: the files are those of the whole cloud.

use crate::common::shared;
use lineament::shapes::{Sampling, Scan, crossed_bores};
use lineament::tile::{Histogram, Plan, extract};
use lineament::{Method, Network, Params, Related};
use lineament_io::{NetworkContext, NetworkFormat, ReadOptions, read, write_network_to};
use sha2::{Digest, Sha256};

fn digest(network: &Network, related: &Related, spacing: f64, noise: f64) -> String {
    let mut bytes = Vec::new();
    let context = NetworkContext {
        method: "penalty".into(),
        spacing,
        noise: Some(noise),
        related: related.clone(),
        ..NetworkContext::default()
    };
    write_network_to(&mut bytes, NetworkFormat::Json, network, &context).unwrap();
    Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Compares the JSON of the whole cloud with that of tiles of at most so many points.
fn same(points: &[[f64; 3]], most: &[u64], strips: usize) {
    let params = Params { method: Method::Penalty, ..Params::default() };
    let whole = lineament::extract(points, &params).unwrap();
    assert!(whole.network.strips.len() >= strips, "{} strips", whole.network.strips.len());
    let right = digest(&whole.network, &whole.related, whole.report.spacing, whole.report.noise);
    let histogram = Histogram::of(points, 1 << 14).unwrap();
    for &most in most {
        let plan = Plan::new(&histogram, most);
        let tiled = extract(&points, &params, &plan, |_| ()).unwrap();
        let own = digest(&tiled.network, &tiled.related, tiled.resolution.spacing, tiled.resolution.noise);
        assert_eq!(own, right, "{} tiles", plan.tiles().len());
        assert!(plan.tiles().len() > 1);
    }
}

#[test]
fn json_of_bores_that_cross_is_the_same_file_from_tiles() {
    let scan = Scan::new(Sampling::Area { count: 6000 }).noise(0.1).seed(3);
    same(&crossed_bores().sample(&scan).cloud.positions, &[3500, 900], 10);
}

#[test]
fn json_of_scans_of_others_is_the_same_file_from_tiles() {
    for (name, most) in [("cad/hanger_4026", 1000), ("cad/fandisk_6475", 3500)] {
        let Some(path) = shared(&format!("{name}/cloud.ply")) else { return };
        same(&read(&path, &ReadOptions::default()).unwrap().cloud.positions, &[most], 10);
    }
}
