//! Samples that agree, thinned to the nodes a contour is linked from.
//!
//! Nodes are taken from the samples nearest to the plane first; the samples beside a node that show the same piece
//! of curve need no node of their own.

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

/// Nodes about 0.7 spacings apart: a short line fitted to the samples around each, where the surface passes through
/// (there are samples from both sides of the plane). `tree` holds the feet of the samples.
pub(crate) fn nodes(samples: &[Sample], tree: &Tree<2>) -> Vec<Node> {
    let rank = |(s, i): (&Sample, u32)| (s.weak, s.lift.abs().to_bits(), i);
    let mut order: Vec<(bool, u64, u32)> = samples.iter().zip(0..).map(rank).collect();
    order.sort_unstable();
    let (mut nodes, mut found): (Vec<Node>, Vec<u32>) = (Vec::new(), Vec::new());
    let mut state = vec![OPEN; samples.len()];
    for (_, _, i) in order {
        let s = &samples[i as usize];
        if state[i as usize] == COVERED {
            continue;
        }
        tree.within(s.foot, 1.8 * s.spacing, &mut found);
        let Some(node) = agree(samples, s, &found) else { continue };
        let beside = |&j: &u32| nodes.get(state[j as usize] as usize).is_some_and(|o| o.repeats(&node));
        if found.iter().any(beside) {
            continue;
        }
        state[i as usize] = nodes.len() as u32;
        for &j in &found {
            if state[j as usize] == OPEN && node.covers(&samples[j as usize]) {
                state[j as usize] = COVERED;
            }
        }
        nodes.push(node);
    }
    nodes
}

/// A sample that has no node, and one that needs none; else its state is the index of its node.
const OPEN: u32 = u32::MAX;
const COVERED: u32 = u32::MAX - 1;

impl Node {
    /// Whether another node, of a sample that comes later, shows the same piece of curve.
    fn repeats(&self, other: &Node) -> bool {
        let apart = distance(self.at, other.at);
        let (_, v) = local(self.tangent, self.at, other.at);
        let alike = dot(other.tangent, self.tangent).abs() >= ALIKE && v.abs() <= 0.4 * self.spacing;
        apart <= 0.7 * self.spacing && alike || apart <= 0.3 * self.spacing
    }

    fn covers(&self, s: &Sample) -> bool {
        let (_, v) = local(self.tangent, self.at, s.foot);
        let alike = dot(s.tangent, self.tangent).abs() >= ALIKE && v.abs() <= 0.4 * self.spacing;
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
        if dot(o.tangent, s.tangent).abs() < ALIKE || v.abs() > tolerance {
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
