//! The sides of each strip: the patches to its left and right, and the fold between them.

use super::beside::Beside;
use super::fit::Fit;
use super::orient::{Side, in_space, sums};
use super::stations::{Station, Stations};
use crate::math::vec3::{add, cross, dot, norm, scale};
use crate::network::{Network, StripKind};

/// The patches beside a strip and how they meet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sides {
    /// The patch on the left when walking along the strip on the outside of the surface; `None` if the surface ends there.
    pub left: Option<u32>,
    /// The patch on the right.
    pub right: Option<u32>,
    /// Mean angle between the outward normals of both patches along the strip, degrees; `None` at a border.
    pub fold_deg: Option<f64>,
    /// Whether the solid fills less than half of the space around the strip; `None` at a border.
    pub convex: Option<bool>,
}

/// `(S)` the sides of every strip. `normals` point outwards.
pub fn sides(
    network: &Network,
    label: &[u32],
    normals: &[[f64; 3]],
    stations: &Stations,
    beside: &Beside,
    fits: &[Fit],
) -> Vec<Sides> {
    let sums = sums(label, normals, stations, beside);
    (0..network.strips.len())
        .map(|s| {
            let range = stations.first[s]..stations.first[s + 1];
            let border = network.strips[s].kind == StripKind::Border;
            of(stations.of(s), &sums[range], border, fits)
        })
        .collect()
}

fn of(stations: &[Station], sums: &[[Side; 2]], border: bool, fits: &[Fit]) -> Sides {
    let patch = [0, 1].map(|side| most(sums.iter().filter_map(|s| s[side].0)));
    // Positive where side 0 is the left one, and where the fold is convex.
    let (mut turn, mut bulge, mut fold, mut count) = (0.0, 0.0, 0.0, 0.0);
    for (at, sum) in stations.iter().zip(sums) {
        let [a, b] = at.leaves.map(|l| l.map(|l| in_space(at, l)));
        let [(p, n), (q, m)] = *sum;
        let seen = [p.is_some() && p == patch[0], q.is_some() && q == patch[1]];
        let up = if seen[0] { n } else { [0.0; 3] };
        let up = if seen[1] { add(up, m) } else { up };
        let left = cross(up, at.tangent);
        turn += a.map_or(0.0, |a| dot(a, left)) - b.map_or(0.0, |b| dot(b, left));
        if let (Some(a), Some(b), [true, true]) = (a, b, seen) {
            bulge -= dot(n, b) + dot(m, a);
            let [n, m] = [(p, n), (q, m)].map(|(patch, normal)| on_surface(fits, patch, normal, at.position));
            fold += norm(cross(n, m)).atan2(dot(n, m));
            count += 1.0;
        }
    }
    let [left, right] = if turn >= 0.0 { patch } else { [patch[1], patch[0]] };
    let folded = count > 0.0 && !border;
    Sides {
        left,
        right,
        fold_deg: folded.then(|| (fold / f64::max(count, 1.0)).to_degrees()),
        convex: folded.then_some(bulge > 0.0),
    }
}

/// The normal of the patch's fitted surface at a place, which leans over no fold; the measured normal if the patch is free-form.
fn on_surface(fits: &[Fit], patch: Option<u32>, measured: [f64; 3], at: [f64; 3]) -> [f64; 3] {
    let Some(fit) = patch.map(|p| &fits[p as usize]).filter(|f| !f.free) else { return measured };
    let normal = fit.surface.normal(at);
    scale(normal, dot(normal, measured).signum())
}

/// The most frequent value, the least among equals.
fn most(values: impl Iterator<Item = u32>) -> Option<u32> {
    let mut all: Vec<u32> = values.collect();
    all.sort_unstable();
    let longest = all.chunk_by(|a, b| a == b).fold(None, |best: Option<&[u32]>, c| match best {
        Some(b) if b.len() >= c.len() => best,
        _ => Some(c),
    });
    longest.map(|c| c[0])
}
