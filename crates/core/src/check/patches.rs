//! The invariants of patches.

use super::verdict::verdict;
use crate::network::Network;
use crate::patch::{Coedge, Loop, NO_PATCH, Patches};

/// Checks every invariant of the [`Patches`] of a network.
///
/// Labels: in range, and as many of each as its patch has points. Sides: one entry for each strip, patches in range, `fold_deg`
/// and `convex` given both or neither. Loops: each side of a strip occurs in exactly one loop of its patch, each strip begins
/// where the previous one ends, a closed loop ends where it begins, the first loop of each patch and no other is the outer one.
/// Neighbours: ascending, never the patch itself, and mutual. Areas and residuals: finite, not negative.
///
/// # Errors
/// One sentence for each violation, naming the patch or strip.
pub fn patches(network: &Network, patches: &Patches) -> Result<(), Vec<String>> {
    let mut faults = labels(patches);
    faults.extend(sides(network, patches));
    for (p, patch) in patches.patches.iter().enumerate() {
        let mut say = |what: String| faults.push(format!("patch {p}: {what}"));
        if !(patch.area >= 0.0 && patch.area.is_finite()) {
            say(format!("area {}", patch.area));
        }
        if !(patch.fit.residual >= 0.0 && patch.fit.residual.is_finite()) {
            say(format!("residual {}", patch.fit.residual));
        }
        for (l, boundary) in patch.loops.iter().enumerate() {
            if boundary.outer != (l == 0) {
                say(format!("loop {l} is marked outer: {}", boundary.outer));
            }
            if let Err(fault) = connected(network, boundary) {
                say(format!("loop {l}: {fault}"));
            }
        }
        for &n in &patch.neighbors {
            let mutual = patches.patches.get(n as usize).is_some_and(|o| o.neighbors.contains(&(p as u32)));
            if n as usize == p || !mutual {
                say(format!("neighbour {n} is the patch itself, or does not list it"));
            }
        }
        if !patch.neighbors.is_sorted_by(|a, b| a < b) {
            say(format!("neighbours {:?} do not ascend", patch.neighbors));
        }
    }
    verdict(faults)
}

fn labels(patches: &Patches) -> Vec<String> {
    let mut counts = vec![0; patches.patches.len()];
    let mut faults = Vec::new();
    for (i, &label) in patches.label.iter().enumerate().filter(|(_, l)| **l != NO_PATCH) {
        match counts.get_mut(label as usize) {
            Some(count) => *count += 1,
            None => faults.push(format!("point {i}: patch {label} of {}", patches.patches.len())),
        }
    }
    for (p, (patch, &count)) in patches.patches.iter().zip(&counts).enumerate() {
        if patch.points != count || count == 0 {
            faults.push(format!("patch {p}: {} points, but {count} carry its label", patch.points));
        }
    }
    faults
}

fn sides(network: &Network, patches: &Patches) -> Vec<String> {
    let mut faults = Vec::new();
    if patches.sides.len() != network.strips.len() {
        faults.push(format!("{} sides of {} strips", patches.sides.len(), network.strips.len()));
    }
    for (s, side) in patches.sides.iter().enumerate() {
        if side.fold_deg.is_some() != side.convex.is_some() {
            faults.push(format!("strip {s}: fold {:?}, convex {:?}", side.fold_deg, side.convex));
        }
        for (patch, forward) in [(side.left, true), (side.right, false)] {
            let Some(p) = patch else { continue };
            let loops = patches.patches.get(p as usize).map_or(&[][..], |p| &p.loops);
            let own = Coedge { strip: s as u32, forward };
            let count = loops.iter().flat_map(|l| &l.coedges).filter(|c| **c == own).count();
            if count != 1 {
                faults.push(format!("strip {s}: occurs {count} times in the loops of patch {p}"));
            }
        }
    }
    faults
}

/// Whether the strips of a loop follow each other.
fn connected(network: &Network, boundary: &Loop) -> Result<(), String> {
    let ends = |c: &Coedge| {
        let strip = network.strips.get(c.strip as usize)?;
        let [a, b] = [strip.start?, strip.end?];
        Some(if c.forward { [a, b] } else { [b, a] })
    };
    for pair in boundary.coedges.windows(2) {
        match (ends(&pair[0]), ends(&pair[1])) {
            (Some([_, a]), Some([b, _])) if a == b => {}
            _ => return Err(format!("strip {} does not lead on to {}", pair[0].strip, pair[1].strip)),
        }
    }
    let (first, last) = match (boundary.coedges.first(), boundary.coedges.last()) {
        (Some(first), Some(last)) => (ends(first), ends(last)),
        _ => return Err("no strips".into()),
    };
    match (first, last, boundary.closed) {
        (None, None, true) => Ok(()),
        (Some([start, _]), Some([_, stop]), closed) if (start == stop) == closed => Ok(()),
        _ => Err(format!("closed is {}, but its strips say otherwise", boundary.closed)),
    }
}
