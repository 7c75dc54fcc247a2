//! Samples that agree, thinned to the nodes a contour is linked from.

use super::carry::Sample;
use super::tree::Tree;
use super::vec2::{along, distance, dot, left, local, unit};

/// A place on the curve that several samples agree on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    /// On the line fitted to the samples around.
    pub at: [f64; 2],
    /// Unit direction of that line, of either sign.
    pub tangent: [f64; 2],
    /// Local spacing.
    pub spacing: f64,
    /// Whether the samples' tangent planes fit badly.
    pub weak: bool,
}

/// Cosine of the largest angle between samples of one piece of curve.
const ALIKE: f64 = 0.8;

/// Fits a short line to the samples around each, keeps those the surface passes through (samples from both sides of
/// the plane), and thins them to about 0.7 spacings.
pub(crate) fn nodes(samples: &[Sample]) -> Vec<Node> {
    let feet: Vec<[f64; 2]> = samples.iter().map(|s| s.foot).collect();
    let tree = Tree::new(&feet);
    let mut found = Vec::new();
    let fitted: Vec<Option<Node>> = samples.iter().map(|s| agree(samples, &tree, s, &mut found)).collect();
    let mut order: Vec<u32> = (0..samples.len() as u32).filter(|&i| fitted[i as usize].is_some()).collect();
    order.sort_by(|&a, &b| {
        let (s, t) = (&samples[a as usize], &samples[b as usize]);
        s.weak.cmp(&t.weak).then(s.lift.abs().total_cmp(&t.lift.abs())).then(a.cmp(&b))
    });
    thin(&fitted, &order)
}

fn agree(samples: &[Sample], tree: &Tree<2>, s: &Sample, found: &mut Vec<u32>) -> Option<Node> {
    tree.within(s.foot, 1.8 * s.spacing, found);
    found.sort_unstable();
    let tolerance = (0.5f64.max(2.0 * s.blur)).min(1.2) * s.spacing;
    let (mut above, mut below, mut count) = (f64::NEG_INFINITY, f64::INFINITY, 0usize);
    let (mut weight, mut sum_u, mut sum_v) = (0.0, 0.0, 0.0);
    let (mut sum_uu, mut sum_uv) = (0.0, 0.0);
    for &j in found.iter() {
        let o = &samples[j as usize];
        let (u, v) = local(s.tangent, s.foot, o.foot);
        if dot(o.tangent, s.tangent).abs() < ALIKE || v.abs() > tolerance {
            continue;
        }
        if u.abs() <= 1.2 * s.spacing {
            above = above.max(o.lift);
            below = below.min(o.lift);
        }
        count += 1;
        let w = 1.0 / (1.0 + o.lift * o.lift);
        weight += w;
        sum_u += w * u;
        sum_v += w * v;
        sum_uu += w * u * u;
        sum_uv += w * u * v;
    }
    if count < 3 || above < -0.2 || below > 0.2 {
        return None;
    }
    let (mu, mv) = (sum_u / weight, sum_v / weight);
    let spread = sum_uu / weight - mu * mu;
    let slope =
        if spread > 0.05 * s.spacing * s.spacing { (sum_uv / weight - mu * mv) / spread } else { 0.0 };
    let slope = slope.clamp(-0.5, 0.5);
    let tangent = unit(along(s.tangent, left(s.tangent), slope));
    Some(Node {
        at: along(s.foot, left(s.tangent), mv - slope * mu),
        tangent,
        spacing: s.spacing,
        weak: s.weak,
    })
}

fn thin(fitted: &[Option<Node>], order: &[u32]) -> Vec<Node> {
    let all: Vec<Node> = order.iter().filter_map(|&i| fitted[i as usize]).collect();
    let places: Vec<[f64; 2]> = all.iter().map(|n| n.at).collect();
    let tree = Tree::new(&places);
    let mut dropped = vec![false; all.len()];
    let (mut kept, mut found) = (Vec::new(), Vec::new());
    for (i, node) in all.iter().enumerate() {
        if dropped[i] {
            continue;
        }
        kept.push(*node);
        tree.within(node.at, 0.7 * node.spacing, &mut found);
        for &j in &found {
            let other = &all[j as usize];
            let (_, v) = local(node.tangent, node.at, other.at);
            let alike = dot(other.tangent, node.tangent).abs() >= ALIKE && v.abs() <= 0.4 * node.spacing;
            if alike || distance(node.at, other.at) <= 0.3 * node.spacing {
                dropped[j as usize] = true;
            }
        }
    }
    kept
}
