//! Scores a network by its distances from a known truth, in spacings.
//!
//! Both are cut into pieces of a fifth of a spacing, and the distance of each piece's end from the other is measured. Stretches
//! of the truth below its `weak_below_deg` count neither for nor against.

use crate::math::vec3::distance;
use crate::network::{Network, NodeKind};
use crate::shapes::{Tree, Truth, densify};

/// The score of a network: the result of [`against`].
#[derive(Clone, Debug, PartialEq)]
pub struct Score {
    /// Shares within one spacing.
    pub at_1h: Hits,
    /// Shares within two spacings.
    pub at_2h: Hits,
    /// From the network to the truth.
    pub to_truth: Distances,
    /// From the truth to the network.
    pub from_truth: Distances,
    /// Closed strips, and closed curves of the truth.
    pub loops: [usize; 2],
    /// Curves of the truth with 90 % of their length within one spacing of the network, and all those that count: curves of at
    /// least 3 spacings.
    pub curves_found: [usize; 2],
    /// Junctions of the truth within two spacings of a strip's end, and all junctions.
    pub junctions_hit: [usize; 2],
    /// Length of all strips in spacings.
    pub length_spacings: f64,
}

/// Precision, recall and their harmonic mean at one tolerance, from 0 to 1; 0 if there is nothing to count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hits {
    /// Share of the network's length that is near the truth.
    pub precision: f64,
    /// Share of the truth's length that is near the network.
    pub recall: f64,
    /// Harmonic mean of both.
    pub f1: f64,
}

/// Distances in spacings; NaN if there is nothing to measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distances {
    /// Mean distance along the length.
    pub mean: f64,
    /// Greatest distance.
    pub max: f64,
}

/// Scores a network against the truth of a scan; `spacing` is the scan's mean spacing, above 0, in the unit of both.
pub fn against(network: &Network, truth: &Truth, spacing: f64) -> Score {
    let step = spacing / 5.0;
    let strips = network.strips.iter().filter(|s| s.points.len() > 1);
    let found: Vec<[f64; 3]> = strips.flat_map(|s| densify(&s.points, s.closed, step)).collect();
    let dense = |weak: bool| -> Vec<[f64; 3]> {
        let parts = truth.curves.iter().flat_map(|c| truth.parts(c, weak));
        parts.flat_map(|p| densify(&p.points, p.closed, step)).collect()
    };
    let (sharp, weak) = (dense(false), Tree::new(&dense(true)));
    let (found_tree, sharp_tree) = (Tree::new(&found), Tree::new(&sharp));
    let cared = |p: &[f64; 3]| {
        let d = away(&sharp_tree, p, spacing);
        (d <= 1.0 || away(&weak, p, spacing) > 2.0).then_some(d)
    };
    let to_truth: Vec<f64> = found.iter().filter_map(cared).collect();
    let from_truth: Vec<f64> = sharp.iter().map(|p| away(&found_tree, p, spacing)).collect();
    Score {
        at_1h: Hits::at(1.0, &to_truth, &from_truth),
        at_2h: Hits::at(2.0, &to_truth, &from_truth),
        to_truth: Distances::of(&to_truth),
        from_truth: Distances::of(&from_truth),
        loops: [network.loops(), truth.loops()],
        curves_found: curves_found(truth, &found_tree, spacing),
        junctions_hit: junctions_hit(network, truth, spacing),
        length_spacings: network.strips.iter().map(|s| s.length()).sum::<f64>() / spacing,
    }
}

/// Distance to the nearest point of a tree in spacings.
fn away(tree: &Tree, p: &[f64; 3], spacing: f64) -> f64 {
    tree.nearest(*p).map_or(f64::INFINITY, |(_, d2)| d2.sqrt() / spacing)
}

fn share(distances: &[f64], tolerance: f64) -> f64 {
    let near = distances.iter().filter(|&&d| d <= tolerance).count();
    near as f64 / distances.len().max(1) as f64
}

impl Hits {
    fn at(tolerance: f64, to_truth: &[f64], from_truth: &[f64]) -> Self {
        let (precision, recall) = (share(to_truth, tolerance), share(from_truth, tolerance));
        let sum = precision + recall;
        Self { precision, recall, f1: if sum > 0.0 { 2.0 * precision * recall / sum } else { 0.0 } }
    }
}

impl Distances {
    fn of(all: &[f64]) -> Self {
        let finite: Vec<f64> = all.iter().copied().filter(|d| d.is_finite()).collect();
        let mean = finite.iter().sum::<f64>() / finite.len() as f64;
        Self { mean, max: finite.iter().copied().fold(f64::NAN, f64::max) }
    }
}

fn curves_found(truth: &Truth, found: &Tree, spacing: f64) -> [usize; 2] {
    let mut counts = [0, 0];
    for part in truth.curves.iter().flat_map(|c| truth.parts(c, false)) {
        let line = densify(&part.points, part.closed, spacing / 5.0);
        if line.windows(2).map(|w| distance(w[0], w[1])).sum::<f64>() >= 3.0 * spacing {
            let near: Vec<f64> = line.iter().map(|p| away(found, p, spacing)).collect();
            counts[0] += usize::from(share(&near, 1.0) >= 0.9);
            counts[1] += 1;
        }
    }
    counts
}

fn junctions_hit(network: &Network, truth: &Truth, spacing: f64) -> [usize; 2] {
    let ends = network.strips.iter().flat_map(|s| [s.points.first(), s.points.last()]).flatten();
    let ends = Tree::new(&ends.copied().collect::<Vec<_>>());
    let junctions = truth.nodes.iter().filter(|n| n.kind == NodeKind::Junction);
    let hit = junctions.clone().filter(|n| away(&ends, &n.position, spacing) <= 2.0);
    [hit.count(), junctions.count()]
}
