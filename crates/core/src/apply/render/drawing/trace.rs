//! Cracks between pixels as chains.

/// A side of a pixel, between two corners of the grid of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Crack {
    /// Where it begins, `[row, column]` of the corner.
    pub from: [i32; 2],
    /// Where it ends, likewise; one step away.
    pub to: [i32; 2],
    /// Whether the step of the depth is beyond doubt.
    pub high: bool,
}

impl Crack {
    fn step(&self) -> [i32; 2] {
        [self.to[0] - self.from[0], self.to[1] - self.from[1]]
    }

    /// Its middle as `[x, y]`.
    pub fn middle(&self) -> [f32; 2] {
        [1, 0].map(|i| 0.5 * (self.from[i] + self.to[i]) as f32)
    }
}

/// Links directed cracks end to start. Where two go on, the sharper turn to the side of the nearer surface is taken, so that outlines
/// that touch at a corner stay apart. Each chain, and whether it is closed; those that have a beginning first, in order of the rows.
pub(super) fn chains(mut cracks: Vec<Crack>) -> Vec<(Vec<Crack>, bool)> {
    cracks.sort_unstable();
    let mut ends: Vec<[i32; 2]> = cracks.iter().map(|c| c.to).collect();
    ends.sort_unstable();
    let mut used = vec![false; cracks.len()];
    let mut chains = Vec::new();
    for closed in [false, true] {
        for first in 0..cracks.len() {
            let begins = ends.binary_search(&cracks[first].from).is_err();
            if used[first] || !(closed || begins) {
                continue;
            }
            let mut chain = Vec::new();
            let mut next = Some(first);
            while let Some(i) = next {
                used[i] = true;
                chain.push(cracks[i]);
                next = following(&cracks, &used, i);
            }
            let round = chain.last().is_some_and(|last| last.to == chain[0].from);
            chains.push((chain, round));
        }
    }
    chains
}

/// The unused crack after crack `i`.
fn following(cracks: &[Crack], used: &[bool], i: usize) -> Option<usize> {
    let at = cracks[i].to;
    let from = cracks.partition_point(|c| c.from < at);
    let here = (from..cracks.len()).take_while(|&j| cracks[j].from == at);
    let [dy, dx] = cracks[i].step();
    // The nearer surface lies on the right hand, y being down.
    let order = [[dx, -dy], [dy, dx], [-dx, dy]];
    let turn = |j: usize| order.iter().position(|&step| step == cracks[j].step());
    here.filter(|&j| !used[j]).min_by_key(|&j| turn(j).unwrap_or(order.len()))
}

/// Cracks of the least chain that is joined to others, and those at an end that tell its direction.
const LEAST: usize = 3;
const REACH: usize = 8;

/// Joins open chains whose ends lie at most `gap` apart where both go on in that direction, the nearest first, and leaves out the shortest.
pub(super) fn joined(mut chains: Vec<(Vec<Crack>, bool)>, gap: f32) -> Vec<(Vec<Crack>, bool)> {
    chains.retain(|(chain, closed)| *closed || chain.len() >= LEAST);
    let (open, mut done): (Vec<_>, Vec<_>) = chains.into_iter().partition(|c| !c.1);
    let open: Vec<Vec<Crack>> = open.into_iter().map(|c| c.0).collect();
    let mut links = Vec::new();
    for (i, before) in open.iter().enumerate() {
        let end = before[before.len() - 1].middle();
        for (j, after) in open.iter().enumerate().filter(|&(j, _)| j != i) {
            let start = after[0].middle();
            let step = [0, 1].map(|c| start[c] - end[c]);
            let away = step[0].hypot(step[1]);
            let [out, on] =
                [&before[before.len() - before.len().min(REACH)..], &after[..after.len().min(REACH)]]
                    .map(way);
            if away <= gap && dot(out, on) > 0.0 && dot(step, out) >= 0.0 && dot(step, on) >= 0.0 {
                links.push((away, i, j));
            }
        }
    }
    links.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let (mut next, mut previous) = (vec![None; open.len()], vec![None; open.len()]);
    for (_, i, j) in links {
        if next[i].is_none() && previous[j].is_none() {
            (next[i], previous[j]) = (Some(j), Some(i));
        }
    }
    let mut used = vec![false; open.len()];
    for round in [false, true] {
        for first in 0..open.len() {
            if used[first] || !(round || previous[first].is_none()) {
                continue;
            }
            let mut chain = Vec::new();
            let mut at = Some(first);
            while let Some(i) = at.filter(|&i| !used[i]) {
                used[i] = true;
                chain.extend_from_slice(&open[i]);
                at = next[i];
            }
            done.push((chain, round));
        }
    }
    done
}

/// From the beginning of a row of cracks to its end.
fn way(cracks: &[Crack]) -> [f32; 2] {
    let [from, to] = [cracks[0].middle(), cracks[cracks.len() - 1].middle()];
    [to[0] - from[0], to[1] - from[1]]
}

fn dot(a: [f32; 2], b: [f32; 2]) -> f32 {
    a[0] * b[0] + a[1] * b[1]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sides of a pixel, itself on the right hand.
    fn pixel([y, x]: [i32; 2]) -> [Crack; 4] {
        let corners = [[y, x], [y, x + 1], [y + 1, x + 1], [y + 1, x]];
        std::array::from_fn(|k| Crack { from: corners[k], to: corners[(k + 1) % 4], high: true })
    }

    #[test]
    fn two_pixels_that_touch_at_a_corner_are_two_loops() {
        let cracks = [pixel([0, 0]), pixel([1, 1])].concat();
        let chains = chains(cracks);
        assert_eq!(chains.iter().map(|c| (c.0.len(), c.1)).collect::<Vec<_>>(), [(4, true), (4, true)]);
    }

    #[test]
    fn a_row_of_cracks_is_one_open_chain_from_its_beginning() {
        let cracks: Vec<Crack> = [2, 0, 1].map(|x| Crack { from: [0, x], to: [0, x + 1], high: true }).into();
        let chains = chains(cracks);
        assert_eq!(chains.len(), 1);
        assert!(!chains[0].1);
        assert_eq!(chains[0].0.iter().map(|c| c.from[1]).collect::<Vec<_>>(), [0, 1, 2]);
    }

    #[test]
    fn chains_are_joined_over_short_gaps_where_they_go_on() {
        let row = |from: i32| {
            (from..from + 5).map(|x| Crack { from: [0, x], to: [0, x + 1], high: true }).collect()
        };
        let rows = |starts: &[i32]| chains(starts.iter().flat_map(|&x| -> Vec<Crack> { row(x) }).collect());
        let count = |starts: &[i32]| joined(rows(starts), 3.5).iter().map(|c| c.0.len()).collect::<Vec<_>>();
        assert_eq!(count(&[0, 7, 14]), [15]);
        assert_eq!(count(&[0, 9]), [5, 5]);
    }
}
