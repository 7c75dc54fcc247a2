//! Samples that agree, thinned to the nodes a contour is linked from.
//!
//! Nodes are taken from the samples nearest to the plane first; the samples beside a node that show the same piece
//! of curve need no node of their own.

use super::chain::NO_NODE;
use crate::math::counting_sort::ascending;
use crate::math::trees::packed::Packed;
use crate::math::vec2::{along, distance, dot, left, local, unit};
use crate::section::surface::carry::Sample;

/// Cosine of the largest angle between samples of one piece of curve.
const SAME_PIECE_COSINE: f64 = 0.8;
/// A sample that has no node, and one that needs none; else its state is the index of its node.
const OPEN: u32 = u32::MAX;
const COVERED: u32 = u32::MAX - 1;

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

/// Nodes with those beside each other.
#[derive(Default)]
pub(crate) struct Nodes {
    /// In the order they were taken.
    pub all: Vec<Node>,
    /// Pairs of nodes whose samples lie near each other, the lower index first.
    pub pairs: Vec<(u32, u32)>,
    /// For each sample the node that shows its piece of curve; [`NO_NODE`] for none.
    pub owners: Vec<u32>,
}

/// Nodes about 0.7 spacings apart: a short line fitted to the samples around each, where the surface passes through
/// (there are samples from both sides of the plane). `tree` holds the feet of the samples.
pub(crate) fn nodes(samples: &[Sample], tree: &Packed) -> Nodes {
    let (mut nodes, mut found) = (Nodes::default(), Vec::new());
    nodes.owners = vec![NO_NODE; samples.len()];
    let mut state = vec![OPEN; samples.len()];
    for i in order(samples) {
        let s = &samples[i as usize];
        if state[i as usize] == COVERED {
            continue;
        }
        tree.within(s.foot, 1.8 * s.spacing, &mut found);
        let Some(node) = agree(samples, s, &found) else { continue };
        let beside = |&j: &u32| nodes.all.get(state[j as usize] as usize).is_some_and(|o| o.repeats(&node));
        if let Some(&j) = found.iter().find(|j| beside(j)) {
            nodes.owners[i as usize] = state[j as usize];
            continue;
        }
        let own = nodes.all.len() as u32;
        let others = found.iter().map(|&j| state[j as usize]).filter(|&o| o < own);
        nodes.pairs.extend(others.map(|other| (other, own)));
        state[i as usize] = own;
        nodes.owners[i as usize] = own;
        for &j in &found {
            if state[j as usize] == OPEN && node.covers(&samples[j as usize]) {
                state[j as usize] = COVERED;
                nodes.owners[j as usize] = own;
            }
        }
        nodes.all.push(node);
    }
    nodes
}

/// The samples in the order they are tried: sound ones first, those nearest to the plane first, ties by index.
fn order(samples: &[Sample]) -> Vec<u32> {
    let rank = |s: &Sample| s.lift.abs() / (1.0 + s.lift.abs()) + if s.weak { 1.0 } else { 0.0 };
    ascending(&samples.iter().map(rank).collect::<Vec<f64>>())
}

impl Node {
    /// Whether another node, of a sample that comes later, shows the same piece of curve.
    fn repeats(&self, other: &Node) -> bool {
        let apart = distance(self.at, other.at);
        let (_, v) = local(self.tangent, self.at, other.at);
        let alike =
            dot(other.tangent, self.tangent).abs() >= SAME_PIECE_COSINE && v.abs() <= 0.4 * self.spacing;
        apart <= 0.7 * self.spacing && alike || apart <= 0.3 * self.spacing
    }

    fn covers(&self, s: &Sample) -> bool {
        let (_, v) = local(self.tangent, self.at, s.foot);
        let alike = dot(s.tangent, self.tangent).abs() >= SAME_PIECE_COSINE && v.abs() <= 0.4 * self.spacing;
        alike && distance(self.at, s.foot) <= 0.7 * self.spacing
    }
}

/// The line through the samples found around one that show the same piece of curve.
fn agree(samples: &[Sample], s: &Sample, found: &[u32]) -> Option<Node> {
    let tolerance = (0.5f64.max(2.0 * s.blur)).min(1.2) * s.spacing;
    let (mut above, mut below, mut count) = (f64::NEG_INFINITY, f64::INFINITY, 0);
    let (mut weight, mut sum_u, mut sum_v) = (0.0, 0.0, 0.0);
    let (mut sum_uu, mut sum_uv) = (0.0, 0.0);
    for &j in found {
        let o = &samples[j as usize];
        let (u, v) = local(s.tangent, s.foot, o.foot);
        if dot(o.tangent, s.tangent).abs() < SAME_PIECE_COSINE || v.abs() > tolerance {
            continue;
        }
        if u.abs() <= 1.2 * s.spacing {
            above = above.max(o.lifts.1);
            below = below.min(o.lifts.0);
        }
        count += o.count;
        let w = o.weight;
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
