//! Lesson 6: a detector of your own in the pipeline. `cargo run --example 06_custom_pipeline` writes `block.obj`.
//!
//! A detector is a function from points to a `Measure`: a score for every point, and penalties for the candidates, the points
//! that may lie on a line. `extract_with` does the rest as in lesson 1: the local frame and the neighbour graph before the
//! detector, linking and curve fitting after it.

use lineament::math::vec3::{distance, norm, scale, sub};
use lineament::shapes::{Sampling, Scan, cuboid};
use lineament::{Direction, Measure, Neighbors, Params, Penalties, Resolution, Row, StripKind, extract_with};
use lineament_io::{NetworkContext, write_network};

/// Score where two faces meet at a right angle.
const EDGE: f64 = 0.3;
/// Least score of a candidate.
const CANDIDATE: f64 = 0.15;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cloud =
        cuboid([4.0, 3.0, 2.0]).sample(&Scan::new(Sampling::BlueNoise { count: 8_000 }).seed(3)).cloud;
    let found = extract_with(&cloud, &Params::default(), umbrella)?;

    // A simple measure is enough for the twelve edges of a block.
    let creases = found.network.strips.iter().filter(|strip| strip.kind == StripKind::Crease);
    let length: f64 = creases.map(|strip| strip.length()).sum();
    println!("{} strips, {length:.2} in all; the edges of the block measure 36", found.network.strips.len());
    assert_eq!(found.network.strips.len(), 12);
    assert!((length - 36.0).abs() < 1.8);

    write_network("block.obj".as_ref(), &[], &found.network, &NetworkContext::default())?;
    Ok(())
}

/// The detector: the length of the umbrella vector (Taubin 1995), from a point to the middle of its neighbours, relative to
/// the radius of these. It is near 0 on a flat face and near 0.3 where two faces meet at a right angle.
///
/// `points` are distinct and in the local frame, where a spacing is near 1; `graph` lists the neighbours of each;
/// `resolution` has spacing and noise.
fn umbrella(points: &[[f64; 3]], graph: &Neighbors, _resolution: Resolution) -> Measure {
    // With a `share` of 1 an edge between two candidates costs the sum of their scalar penalties, and is left out from a cost
    // of 1 on (the parameter `spanning.tau`). A detector that knows the direction of the line at a point states it in
    // `vector`, and lowers the share.
    let mut crease = Penalties { share: 1.0, direction: Direction::Across, ..Penalties::default() };
    let (mut density, mut score) = (Vec::new(), Vec::new());
    for (i, &point) in points.iter().enumerate() {
        let direct = graph.of(i);
        let lengths: f64 = direct.iter().map(|&j| distance(points[j as usize], point)).sum();
        density.push((lengths / direct.len().max(1) as f64) as f32);

        // Neighbours of neighbours: more points say more.
        let mut wide: Vec<u32> = direct.iter().flat_map(|&j| graph.of(j as usize)).copied().collect();
        wide.sort_unstable();
        wide.dedup();
        let sum = wide.iter().fold([0.0; 3], |s, &j| [0, 1, 2].map(|a| s[a] + points[j as usize][a]));
        let middle = scale(sum, 1.0 / wide.len().max(1) as f64);
        let radius =
            wide.iter().map(|&j| distance(points[j as usize], point)).fold(f64::MIN_POSITIVE, f64::max);
        let length = norm(sub(middle, point)) / radius;
        score.push(length as f32);
        if length > CANDIDATE {
            let penalty = (1.0 - length / EDGE).max(0.0); // 0 where a line is certain
            let foot = point; // this detector does not look for the line beside the point
            let row = Row { scalar: penalty as f32, vector: [0.0; 3], corner: 1.0, foot, evidence: None };
            crease.push(i as u32, row);
        }
    }
    Measure { density, score, crease, ..Measure::default() }
}
