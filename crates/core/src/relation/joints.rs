//! The places where the curves of a network meet: its nodes, and between these the ends of neighbouring curves of one strip.

use crate::network::Network;

/// The joints of a network.
#[derive(Clone, Debug)]
pub(super) struct Joints {
    /// Where they lie; the first are the nodes.
    pub places: Vec<[f64; 3]>,
    /// For each strip and curve the joints at its ends; `None` where it closes on itself.
    pub ends: Vec<Vec<Option<[usize; 2]>>>,
}

impl Joints {
    pub(super) fn of(network: &Network) -> Self {
        let mut places: Vec<[f64; 3]> = network.nodes.iter().map(|n| n.position).collect();
        let mut ends = Vec::with_capacity(network.strips.len());
        for strip in &network.strips {
            let count = strip.curves.len();
            if strip.closed && count < 2 {
                ends.push(vec![None; count]);
                continue;
            }
            let first = places.len();
            places.extend(strip.curves.iter().skip(usize::from(!strip.closed)).map(|p| p.from));
            // The joint before a curve.
            let before = |k: usize| match (strip.start, strip.end) {
                (Some(start), _) if k == 0 => start as usize,
                (_, Some(end)) if k == count => end as usize,
                (Some(_), _) => first + k - 1,
                _ => first + k % count,
            };
            ends.push((0..count).map(|k| Some([before(k), before(k + 1)])).collect());
        }
        Self { places, ends }
    }
}
