//! Open outlines carried on to where their samples end: nodes lie where samples lie on both sides, and so end short of a border.

use crate::math::trees::packed::Packed;
use crate::math::vec2::{along, dot, local, sub, unit};
use crate::section::contour::band::Band;
use crate::section::contour::chain::{Chain, Vertex};
use crate::section::surface::carry::Sample;

/// Longest step to a next sample, and farthest across, spacings; noise adds to the latter.
const STEP: (f64, f64) = (1.5, 0.3);
/// Least cosine between an outline and the curve as a sample has it.
const ALONG_COSINE: f64 = 0.8;
/// Steps at most.
const STEPS: usize = 6;
/// Vertices of which the direction at an end is taken: one beside it may lean.
const BACK: usize = 4;

/// Carries the open lines of bands on over samples that no other band has.
pub(super) fn carried_on(samples: &[Sample], tree: &Packed, bands: &[Band], lines: &mut [Chain], noise: f64) {
    if lines.iter().all(|line| line.closed) {
        return;
    }
    let mut owner = vec![usize::MAX; samples.len()];
    for (b, band) in bands.iter().enumerate() {
        band.marks.iter().for_each(|m| owner[m.source as usize] = b);
    }
    for (b, line) in lines.iter_mut().enumerate().filter(|(_, line)| !line.closed) {
        for _ in 0..2 {
            let free = |i: u32| owner[i as usize] == b || owner[i as usize] == usize::MAX;
            carry(samples, tree, &free, line, noise);
            line.vertices.reverse();
        }
    }
}

/// Carries the last end on, a vertex a step.
fn carry(samples: &[Sample], tree: &Packed, free: &dyn Fn(u32) -> bool, line: &mut Chain, noise: f64) {
    let n = line.vertices.len();
    if n < 2 {
        return;
    }
    let (tip, back) = (line.vertices[n - 1], line.vertices[n.saturating_sub(BACK).min(n - 2)]);
    let out = unit(sub(tip.at, back.at));
    let (mut at, mut found) = (tip.at, Vec::new());
    for _ in 0..STEPS {
        tree.within(at, STEP.0 * tip.spacing, &mut found);
        let ahead = |&i: &u32| {
            let sample = &samples[i as usize];
            let (ahead, aside) = local(out, at, sample.foot);
            let along = dot(sample.tangent, out).abs() >= ALONG_COSINE;
            (free(i) && along && aside.abs() <= (STEP.1 + noise) * tip.spacing).then_some((ahead, aside))
        };
        let farthest = found.iter().filter_map(ahead).max_by(|a, b| a.0.total_cmp(&b.0));
        let Some((step, _)) = farthest.filter(|f| f.0 > 1e-6 * tip.spacing) else { break };
        at = along(at, out, step);
        line.vertices.push(Vertex { at, ..Vertex::new(at, tip.spacing) });
    }
}
