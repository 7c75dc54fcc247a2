//! `G_all`: the small clusters at their centres of mass, joined where a point of one lies in the one-ring of a point of the
//! other (Demarsin et al. 2007, section 2.3).

use super::graph::Clusters;
use crate::detect::segments::Segmentation;
use crate::math::vec3::{add_scaled, distance2};
use crate::neighbors::Neighbors;
use crate::pattern::LineGraph;

/// The graph of all clusters, `G_all`. `rings` are the one-rings.
pub fn all_clusters(points: &[[f64; 3]], rings: &Neighbors, segments: &Segmentation) -> Clusters {
    let count = segments.size.len();
    let centre = centres(points, segments);
    let nearest = representatives(points, segments, &centre);
    let mut small: Vec<u32> = (0..count as u32).filter(|&c| !segments.large[c as usize]).collect();
    small.sort_unstable_by_key(|&c| nearest[c as usize]);
    let mut number = vec![None; count];
    small.iter().zip(0..).for_each(|(&c, v)| number[c as usize] = Some(v));
    let mut clusters = Clusters {
        lines: LineGraph {
            points: small.iter().map(|&c| nearest[c as usize]).collect(),
            positions: small.iter().map(|&c| centre[c as usize]).collect(),
            penalty: vec![None; small.len()],
            corner: vec![1.0; small.len()],
            evidence: vec![None; small.len()],
            radius: vec![0.0; small.len()],
            edges: vec![Vec::new(); small.len()],
            nodes: Vec::new(),
        },
        large: vec![Vec::new(); small.len()],
        weights: Vec::new(),
        large_count: count - small.len(),
        large_pairs: 0,
    };
    for (a, b) in touching(rings, segments) {
        match (number[a as usize], number[b as usize]) {
            (None, None) => clusters.large_pairs += 1,
            (None, Some(v)) => clusters.large[v as usize].push(a),
            (Some(v), None) => clusters.large[v as usize].push(b),
            (Some(v), Some(w)) => clusters.lines.add_edge(v, w),
        }
    }
    clusters.large.iter_mut().for_each(|l| l.sort_unstable());
    clusters
}

/// The centre of mass of each cluster.
fn centres(points: &[[f64; 3]], segments: &Segmentation) -> Vec<[f64; 3]> {
    let mut centre = vec![[0.0; 3]; segments.size.len()];
    for (p, &c) in points.iter().zip(&segments.label) {
        centre[c as usize] = add_scaled(centre[c as usize], *p, 1.0 / f64::from(segments.size[c as usize]));
    }
    centre
}

/// The representative point of each cluster: the member nearest to its centre, the first among equals.
fn representatives(points: &[[f64; 3]], segments: &Segmentation, centre: &[[f64; 3]]) -> Vec<u32> {
    let mut nearest = vec![(f64::INFINITY, u32::MAX); centre.len()];
    for (i, (p, &c)) in points.iter().zip(&segments.label).enumerate() {
        let d = distance2(*p, centre[c as usize]);
        if d < nearest[c as usize].0 {
            nearest[c as usize] = (d, i as u32);
        }
    }
    nearest.into_iter().map(|n| n.1).collect()
}

/// The pairs of clusters with points in each other's rings, the lesser number first; ascending, each once.
fn touching(rings: &Neighbors, segments: &Segmentation) -> Vec<(u32, u32)> {
    let mut pairs: Vec<(u32, u32)> = Vec::new();
    for (i, &a) in segments.label.iter().enumerate() {
        for b in rings.of(i).iter().map(|&j| segments.label[j as usize]).filter(|&b| b != a) {
            pairs.push((a.min(b), a.max(b)));
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}
