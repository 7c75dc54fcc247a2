//! The loose ends of chains, and how two of them may meet.

use super::chain::Chain;
use crate::math::vec2::{along, distance, meet, sub, unit};

/// A loose end: where it lies and which way it looks.
#[derive(Clone, Copy)]
pub(crate) struct End {
    pub chain: usize,
    pub last: bool,
    pub at: [f64; 2],
    pub out: [f64; 2],
    pub spacing: f64,
    pub length: f64,
    pub weak: bool,
}

/// How two ends meet.
#[derive(Clone, Copy)]
pub(crate) struct Joint {
    pub cost: f64,
    pub a: usize,
    pub b: usize,
    pub corner: Option<[f64; 2]>,
}

/// Both ends of a chain.
pub(crate) fn ends_of((index, chain): (usize, &Chain)) -> [End; 2] {
    let length = chain.length();
    let end = |last: bool| {
        let v = &chain.vertices;
        let pick = |k: usize| if last { v[v.len() - 1 - k] } else { v[k] };
        let tip = pick(0);
        // Three steps back: one node beside a corner may lean.
        let back = pick(3.min(v.len() - 1));
        End {
            chain: index,
            last,
            at: tip.at,
            out: unit(sub(tip.at, back.at)),
            spacing: tip.spacing,
            length,
            weak: tip.weak,
        }
    };
    [end(false), end(true)]
}

/// Whether two ends lie near enough to each other for the lengths of their chains.
pub(crate) fn may_join(e: &End, f: &End) -> bool {
    let (gap, spacing) = (distance(e.at, f.at), 0.5 * (e.spacing + f.spacing));
    if e.chain == f.chain {
        gap <= 0.5 * e.length
    } else {
        gap <= (e.length.min(f.length) + spacing).max(1.5 * spacing)
    }
}

/// Where two ends would meet if both went straight on.
pub(crate) fn corner(e: &End, f: &End, spacing: f64) -> Option<[f64; 2]> {
    let (ahead, behind) = meet(e.at, e.out, f.at, f.out)?;
    (ahead.min(behind) >= -1.2 * spacing).then(|| along(e.at, e.out, ahead))
}
