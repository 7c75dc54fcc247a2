//! Rounded edges led on to where their round ends.
//!
//! Near the end of an edge a section holds points of the faces across it, so that chains of edgelets end some spacings before it. The round is
//! known there, and goes on as long as points lie on it.

use super::chain::Chain;
use crate::math::vec3::{add_scaled, dot, norm, scale, sub, unit};
use crate::measure::Edgelet;
use crate::neighbors::Index;
use crate::surface::Scales;

/// Length of a step, spacings, and the greatest number of them.
const STEP: f64 = 1.0;
const STEPS: usize = 8;
/// Edgelets back from an end over which its direction is taken.
const BACK: usize = 4;
/// Least length of a chain that is led on, spacings.
const LEAST: f64 = 3.0;
/// Greatest distance of a point on the round from it, in spacings, and what a spacing of noise adds.
const OFF: (f64, f64) = (0.15, 2.5);
/// Least share of the points that an even sampling would have on the round in a step, and greatest share of those there that lie off it.
const FULL: f64 = 0.5;
const CLEAR: f64 = 0.5;

/// Leads both ends of open chains on. `index` is that of the `points`.
pub(super) fn lead(chains: &mut [Chain], points: &[[f64; 3]], index: &Index, scales: Scales) {
    for chain in chains.iter_mut().filter(|c| !c.closed) {
        for _ in 0..2 {
            if let Some(more) = beyond(&chain.members, points, index, scales) {
                chain.members.extend(more);
            }
            chain.members.reverse();
        }
    }
}

/// The edgelets beyond the last one.
fn beyond(members: &[Edgelet], points: &[[f64; 3]], index: &Index, scales: Scales) -> Option<Vec<Edgelet>> {
    let last = *members.last()?;
    let from = members[members.len().saturating_sub(BACK + 1)];
    let h = last.spacing;
    let chord = sub(last.place, from.place);
    if norm(chord) < LEAST * h {
        return None;
    }
    let out = unit(chord);
    let noise = scales.at(last.point as usize).noise / h;
    let off = (OFF.0 + OFF.1 * noise) * h;
    let mut more = Vec::new();
    for k in 1..=STEPS {
        let place = add_scaled(last.place, out, k as f64 * STEP * h);
        let next = Edgelet { place, along: out, evidence: 0.0, ..last };
        if !goes_on(&next, points, index, off) {
            break;
        }
        more.push(next);
    }
    Some(more)
}

/// Whether the points in the last step before an edgelet lie on its round.
fn goes_on(e: &Edgelet, points: &[[f64; 3]], index: &Index, off: f64) -> bool {
    let touch = e.tangent();
    let [a, b] = e.arms;
    let inwards = unit(add_scaled(a, b, 1.0));
    let centre = scale(inwards, touch.hypot(e.radius));
    let (mut on, mut all) = (0.0, 0.0);
    let middle = add_scaled(e.place, inwards, touch.hypot(e.radius) - e.radius);
    let reach = (touch + e.spacing).hypot(STEP * e.spacing);
    index.around(middle, reach, |f| {
        let d = sub(points[f.index as usize], e.place);
        let along = dot(d, e.along);
        let across = add_scaled(d, e.along, -along);
        let before = (-STEP * e.spacing..=0.0).contains(&along);
        if before && e.arms.iter().all(|&arm| dot(across, arm) <= touch) {
            all += 1.0;
            let from = norm(sub(across, centre)) - e.radius;
            on += f64::from(u8::from(from.abs() <= off));
        }
    });
    let even = e.radius * e.turn() * STEP / e.spacing;
    on >= FULL * even && on >= CLEAR * all
}
