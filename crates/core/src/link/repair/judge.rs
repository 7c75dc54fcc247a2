//! Keeps or drops whole strips by the evidence along them.
//!
//! One point's cross-section is uncertain under noise, but along a strip the evidence adds up. The evidence of a strip is
//! compared with the evidence expected of a sharp fold of the same angle at the same places: a sharp strip reaches it, a round
//! shows almost none, and the comparison needs no threshold that grows with noise. A connected piece is dropped as well if all
//! its evidence together could be chance. Not in Gumhold 2001, which prunes by length alone.

use crate::math::union_find::UnionFind;
use crate::math::vec3::distance;
use crate::measure::Evidence;
use crate::params::RepairParams;
use crate::pattern::{LineGraph, Path, paths};
use crate::surface::Scales;

/// A strip shorter than this, in spacings, lies within the junctions at its ends and is not judged by itself.
const WITHIN_JUNCTION: f64 = 3.0;

/// Drops strips along rounds, then pieces too short or with too little evidence to be lines.
pub(crate) fn judge(lines: &mut LineGraph, scales: Scales, params: &RepairParams) {
    let share = params.sharp_share;
    loop {
        let round: Vec<Path> =
            paths(lines).into_iter().filter(|p| is_round(lines, p, scales, share)).collect();
        if round.is_empty() {
            break;
        }
        for path in &round {
            path.remove_from(lines);
        }
    }
    // Neighbouring points share their neighbours, so chance alone adds up to about twenty along the false lines of a noisy round.
    drop_pieces(lines, params.piece_spacings, params.evidence, scales);
}

/// Whether the strip shows less than a `share` of the evidence expected of a fold of its angle.
fn is_round(lines: &LineGraph, path: &Path, scales: Scales, share: f64) -> bool {
    let shown = || path.vertices.iter().map(|&v| sums_of(lines.evidence[v as usize]));
    let loose = path.ends.is_some_and(|e| e.iter().any(|&v| lines.edges[v as usize].len() == 1));
    if !loose && path.ends.is_some() && length(lines, &path.vertices, scales) < WITHIN_JUNCTION {
        return false;
    }
    let expected: f64 = shown().map(|s| s[1]).sum();
    expected > 0.0 && shown().map(|s| s[0]).sum::<f64>() < share * expected
}

/// The evidence of a vertex and the evidence expected of a sharp fold; zero without a cross-section.
fn sums_of(evidence: Option<Evidence>) -> [f64; 2] {
    evidence.map_or([0.0; 2], |e| [e.sharp, e.expected].map(f64::from))
}

/// Removes connected pieces shorter than `least` spacings in all, and those with less evidence than `sure`.
fn drop_pieces(lines: &mut LineGraph, least: f64, sure: f64, scales: Scales) {
    let count = lines.edges.len();
    let mut sets = UnionFind::new(count);
    for (a, list) in lines.edges.iter().enumerate() {
        for &b in list {
            sets.union(a as u32, b);
        }
    }
    // Length, evidence and expected evidence; the last two are zero where no cross-section was taken, as at borders.
    let mut sums = vec![[0.0; 3]; count];
    for a in 0..count {
        let sum = &mut sums[sets.find(a as u32) as usize];
        let after = lines.edges[a].iter().filter(|&&b| b as usize > a);
        sum[0] += after.map(|&b| length(lines, &[a as u32, b], scales)).sum::<f64>();
        let [evidence, expected] = sums_of(lines.evidence[a]);
        sum[1] += evidence;
        sum[2] += expected;
    }
    for v in 0..count {
        let [length, evidence, expected] = sums[sets.find(v as u32) as usize];
        if length < least || (expected > 0.0 && evidence < sure) {
            lines.edges[v].clear();
        }
    }
}

/// Length of the path through `vertices`, spacings.
fn length(lines: &LineGraph, vertices: &[u32], scales: Scales) -> f64 {
    let edge = |w: &[u32]| {
        let [a, b] = [w[0] as usize, w[1] as usize];
        distance(lines.positions[a], lines.positions[b]) / scales.between(lines.points[a], lines.points[b])
    };
    vertices.windows(2).map(edge).sum()
}
