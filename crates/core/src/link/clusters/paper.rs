//! Demarsin's pipeline as printed, from the segmentation to `G_smooth`.

use super::branches::prune_branches;
use super::connect::{connect, neighbors_in_reach};
use super::extend::longest;
use super::forest::by_length;
use super::include::{include, leave};
use super::open::remove_open;
use super::smooth::smooth;
use super::{Clusters, Linked, Recorder, extend, forest};
use crate::detect::segments::Segmentation;
use crate::math::vec3::{add_scaled, distance2};
use crate::neighbors::Neighbors;
use crate::params::SegmentParams;
use crate::pattern::{LineGraph, Pattern};
use crate::resolution::Resolution;

/// Steps of smoothing.
const SMOOTHING: usize = 5;

/// Closed lines of the small clusters. `rings` are the one-rings; canonical order, local frame.
pub fn link_paper(
    points: &[[f64; 3]],
    rings: &Neighbors,
    segments: &Segmentation,
    mut border: LineGraph,
    resolution: Resolution,
    params: &SegmentParams,
) -> Linked {
    let mut recorder = Recorder::new();
    let mut clusters = all_clusters(points, rings, segments);
    recorder.whole("G_all", &clusters);
    let reach = longest(&clusters);
    extend(&mut clusters, reach);
    recorder.whole("G_extended", &clusters);
    let mut lines = forest(&clusters.lines, &by_length(&clusters.lines), None);
    recorder.lines("G_pruned_mst", &lines);
    prune_branches(&mut lines, resolution, params.branch);
    recorder.lines("G_pruned_branches", &lines);
    let n = params.connect.or(|| neighbors_in_reach(&lines, reach));
    let own = include(&mut lines, &border);
    connect(&mut lines, resolution, n, params.cycle.or(|| 2 * params.branch));
    remove_open(&mut lines);
    recorder.lines("G_closed", &lines);
    smooth(&mut lines, SMOOTHING);
    recorder.lines("G_smooth", &lines);
    leave(&mut lines, &mut border, own);
    Linked { pattern: Pattern { crease: lines, border }, stages: recorder.stages }
}

/// `G_all` (section 2.3): the small clusters at their centres of mass, joined where a point of one is in the ring of a point of
/// the other.
fn all_clusters(points: &[[f64; 3]], rings: &Neighbors, segments: &Segmentation) -> Clusters {
    let count = segments.size.len();
    let mut centre = vec![[0.0; 3]; count];
    for (p, &c) in points.iter().zip(&segments.label) {
        centre[c as usize] = add_scaled(centre[c as usize], *p, 1.0 / f64::from(segments.size[c as usize]));
    }
    // The member nearest to the centre stands for the cluster in the cloud; the first among equals.
    let mut nearest = vec![(f64::INFINITY, u32::MAX); count];
    for (i, (p, &c)) in points.iter().zip(&segments.label).enumerate() {
        let d = distance2(*p, centre[c as usize]);
        if d < nearest[c as usize].0 {
            nearest[c as usize] = (d, i as u32);
        }
    }
    let mut small: Vec<u32> = (0..count as u32).filter(|&c| !segments.large[c as usize]).collect();
    small.sort_unstable_by_key(|&c| nearest[c as usize].1);
    let mut number = vec![u32::MAX; count];
    for (v, &c) in small.iter().enumerate() {
        number[c as usize] = v as u32;
    }
    let mut pairs: Vec<(u32, u32)> = Vec::new();
    for i in 0..points.len() {
        let a = segments.label[i];
        for b in rings.of(i).iter().map(|&j| segments.label[j as usize]).filter(|&b| b != a) {
            pairs.push((a.min(b), a.max(b)));
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    let mut clusters = Clusters {
        lines: LineGraph {
            points: small.iter().map(|&c| nearest[c as usize].1).collect(),
            positions: small.iter().map(|&c| centre[c as usize]).collect(),
            penalty: vec![0.0; small.len()],
            corner: vec![1.0; small.len()],
            evidence: vec![0.0; small.len()],
            expected: vec![0.0; small.len()],
            fold: vec![0.0; small.len()],
            edges: vec![Vec::new(); small.len()],
            nodes: Vec::new(),
        },
        large: vec![Vec::new(); small.len()],
        weights: Vec::new(),
        large_count: count - small.len(),
        large_pairs: 0,
    };
    for (a, b) in pairs {
        match (number[a as usize], number[b as usize]) {
            (u32::MAX, u32::MAX) => clusters.large_pairs += 1,
            (u32::MAX, v) => clusters.large[v as usize].push(a),
            (v, u32::MAX) => clusters.large[v as usize].push(b),
            (v, w) => clusters.lines.add_edge(v, w),
        }
    }
    clusters.large.iter_mut().for_each(|l| l.sort_unstable());
    clusters
}
