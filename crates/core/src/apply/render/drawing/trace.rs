//! Cracks between pixels as chains.

/// A side of a pixel, between two corners of the grid of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Crack {
    /// Where it begins, `[row, column]` of the corner.
    pub from: [i32; 2],
    /// Where it ends, likewise; one step away.
    pub to: [i32; 2],
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The sides of a pixel, itself on the right hand.
    fn pixel([y, x]: [i32; 2]) -> [Crack; 4] {
        let corners = [[y, x], [y, x + 1], [y + 1, x + 1], [y + 1, x]];
        std::array::from_fn(|k| Crack { from: corners[k], to: corners[(k + 1) % 4] })
    }

    #[test]
    fn two_pixels_that_touch_at_a_corner_are_two_loops() {
        let cracks = [pixel([0, 0]), pixel([1, 1])].concat();
        let chains = chains(cracks);
        assert_eq!(chains.iter().map(|c| (c.0.len(), c.1)).collect::<Vec<_>>(), [(4, true), (4, true)]);
    }

    #[test]
    fn a_row_of_cracks_is_one_open_chain_from_its_beginning() {
        let cracks: Vec<Crack> = [2, 0, 1].map(|x| Crack { from: [0, x], to: [0, x + 1] }).into();
        let chains = chains(cracks);
        assert_eq!(chains.len(), 1);
        assert!(!chains[0].1);
        assert_eq!(chains[0].0.iter().map(|c| c.from[1]).collect::<Vec<_>>(), [0, 1, 2]);
    }
}
