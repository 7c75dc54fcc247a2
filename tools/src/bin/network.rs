//! Writes a network in the format of each extension: `cargo run -p lineament-io --example network -- [--points N] OUT...`; its
//! loop has N points [default: 64].

use lineament::curve::BSpline;
use lineament::{Network, Node, NodeKind, Strip, StripKind};
use lineament_io::{NetworkContext, write_network};
use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let context =
        NetworkContext { program_version: env!("CARGO_PKG_VERSION").into(), ..NetworkContext::default() };
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut points = 64;
    if arguments.len() > 1 && arguments[0] == "--points" {
        points = arguments[1].parse()?;
        arguments.drain(..2);
    }
    let network = network(points);
    for out in arguments {
        write_network(Path::new(&out), &[], &network, &context)?;
    }
    Ok(())
}

/// A crease between two nodes, at map coordinates, and a border loop of so many points.
fn network(points: usize) -> Network {
    let at = |x: f64, y: f64, z: f64| [665_187.25 + x, 5_648_349.875 + y, 241.5 + z];
    let circle = |i: usize| {
        let angle = i as f64 / points as f64 * std::f64::consts::TAU;
        at(angle.cos(), angle.sin(), 0.0)
    };
    let strip = |kind, ends: Option<(u32, u32)>, points: Vec<[f64; 3]>| Strip {
        sigma: Vec::new(),
        blend: None,
        kind,
        closed: ends.is_none(),
        start: ends.map(|e| e.0),
        end: ends.map(|e| e.1),
        points,
        curve: BSpline::default(),
        sources: vec![0],
        fold_deg: None,
        evidence: None,
        curves: Vec::new(),
        deviation: 0.001,
        confidence: 0.9,
    };
    let crease = vec![at(0.0, 0.0, 0.0), at(0.5, 0.1, 0.0), at(1.0 / 3.0, 1.0, 1e-7)];
    let node = |position, kind| Node { position, kind, degree: 1, source: 0, sigma: None };
    Network {
        nodes: vec![node(crease[0], NodeKind::Junction), node(crease[2], NodeKind::End)],
        strips: vec![
            strip(StripKind::Crease, Some((0, 1)), crease),
            strip(StripKind::Border, None, (0..points).map(circle).collect()),
        ],
    }
}
