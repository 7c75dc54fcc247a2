//! Gaps between chains closed where one continues the other: the ends face each other, and the faces beside them are the same.

use super::chain::Chain;
use crate::math::vec3::{add, add_scaled, distance, dot, norm, scale, sub, unit};
use crate::measure::Edgelet;
use crate::neighbors::Index;

/// Greatest gap, in spacings.
const GAP: f64 = 10.0;
/// Greatest gap over the length of the shorter of both chains.
const LONGER: f64 = 2.0;
/// Edgelets back from an end over which its direction is taken.
const BACK: usize = 3;
/// Least cosine between the direction of an end and the gap.
const AHEAD: f64 = 0.8;
/// Least cosine between the faces on both sides of a gap.
const FACES: f64 = 0.8;
/// Cost of an end that looks aside beside one that looks straight, in gaps.
const ASIDE: f64 = 2.0;

/// An end of a chain, looking outwards.
#[derive(Clone, Copy, Debug)]
struct End {
    place: [f64; 3],
    out: [f64; 3],
    arms: [[f64; 3]; 2],
    spacing: f64,
    /// Length of the chain.
    length: f64,
}

/// Joins chains that continue each other; ends are numbered `2 c` for the first of chain `c` and `2 c + 1` for its last.
pub(super) fn close(chains: Vec<Chain>) -> Vec<Chain> {
    let ends: Vec<End> = chains.iter().flat_map(|c| [true, false].map(|first| end(c, first))).collect();
    let best = best(&chains, &ends);
    let partner = |e: usize| best[e].filter(|&o| best[o] == Some(e));
    let mut used = vec![false; chains.len()];
    let mut joined = Vec::new();
    // Rows that begin at an end without a partner come first; what is left are rings.
    for ring in [false, true] {
        for c in 0..chains.len() {
            let start = [2 * c, 2 * c + 1].into_iter().find(|&e| ring || partner(e).is_none());
            if let (false, Some(start)) = (used[c], start) {
                joined.push(row(&chains, &ends, &partner, start, &mut used));
            }
        }
    }
    joined
}

fn end(chain: &Chain, first: bool) -> End {
    let n = chain.members.len();
    let back = BACK.min(n - 1);
    let [at, from] = if first { [0, back] } else { [n - 1, n - 1 - back] };
    let e = &chain.members[at];
    let out = match n {
        1 => scale(e.along, if first { -1.0 } else { 1.0 }),
        _ => unit(sub(e.place, chain.members[from].place)),
    };
    End { place: e.place, out, arms: e.arms, spacing: e.spacing, length: chain.extent() }
}

/// The best end for each end to be joined with.
fn best(chains: &[Chain], ends: &[End]) -> Vec<Option<usize>> {
    let places: Vec<[f64; 3]> = ends.iter().map(|e| e.place).collect();
    let index = Index::build(&places);
    let mut near = Vec::new();
    let mut of = |e: usize| {
        near.clear();
        if chains[e / 2].closed {
            return None;
        }
        index.around(ends[e].place, GAP * ends[e].spacing, |f| near.push(f.index as usize));
        near.sort_unstable();
        let mut best: Option<(f64, usize)> = None;
        for &o in near.iter().filter(|&&o| o != e && !chains[o / 2].closed) {
            let Some(cost) = cost(&ends[e], &ends[o]) else { continue };
            if best.is_none_or(|b| cost < b.0) {
                best = Some((cost, o));
            }
        }
        best.map(|b| b.1)
    };
    (0..ends.len()).map(&mut of).collect()
}

/// The cost of joining two ends; `None` where one does not continue the other.
fn cost(a: &End, b: &End) -> Option<f64> {
    let gap = sub(b.place, a.place);
    let length = norm(gap);
    if length == 0.0 || length > LONGER * a.length.min(b.length) {
        return None;
    }
    let ahead = [dot(gap, a.out) / length, -dot(gap, b.out) / length];
    let same = |x: usize, y: usize| dot(a.arms[x], b.arms[0]).min(dot(a.arms[y], b.arms[1]));
    let faces = same(0, 1).max(same(1, 0));
    let continues = ahead[0] >= AHEAD && ahead[1] >= AHEAD && faces >= FACES;
    continues.then(|| length * (1.0 + ASIDE * (2.0 - ahead[0] - ahead[1])))
}

/// The row of chains that begins at an end, in one.
fn row(
    chains: &[Chain],
    ends: &[End],
    partner: &impl Fn(usize) -> Option<usize>,
    start: usize,
    used: &mut [bool],
) -> Chain {
    let mut members: Vec<Edgelet> = Vec::new();
    let (mut at, mut longest) = (start, 0.0f64);
    loop {
        let chain = &chains[at / 2];
        used[at / 2] = true;
        longest = longest.max(chain.longest);
        match at % 2 {
            0 => members.extend(&chain.members),
            _ => members.extend(chain.members.iter().rev()),
        }
        let last = at ^ 1;
        let Some(next) = partner(last) else {
            return Chain { members, closed: chain.closed, longest };
        };
        bridge(&mut members, &ends[last], &ends[next]);
        if next == start {
            return Chain { members, closed: true, longest };
        }
        at = next;
    }
}

/// Appends edgelets over the gap between two ends: a cubic that leaves and arrives in their directions.
fn bridge(members: &mut Vec<Edgelet>, from: &End, to: &End) {
    let Some(&last) = members.last() else { return };
    let length = distance(from.place, to.place);
    let steps = (length / from.spacing).ceil();
    for k in 1..steps as usize {
        let t = k as f64 / steps;
        let (s, chord) = (1.0 - t, add_scaled(scale(from.place, 1.0 - t), to.place, t));
        // Hermite's basis, as an offset from the chord.
        let straight = sub(to.place, from.place);
        let leave = sub(scale(from.out, length), straight);
        let arrive = sub(scale(to.out, -length), straight);
        let offset = add_scaled(scale(leave, s * s * t), arrive, -s * t * t);
        members.push(Edgelet { place: add(chord, offset), evidence: 0.0, ..last });
    }
}
