//! Corners of a band: places where the direction turns at once and hardly on either side.
//!
//! Straight lines are fitted to the samples before and after a place. The sharpest turns are taken first; the lines of
//! the others then end at those, so that one corner is not found again from its flanks.

use std::collections::BTreeMap;

use super::regression::{Local, regress, spacing_at, width};
use crate::math::vec2::{along, distance, dot, meet, onto, sub, unit};
use crate::section::contour::band::{Band, segment, segments};
use crate::section::contour::chain::Vertex;

/// Rise of the least turn at a corner, degrees, for each spacing of noise.
const NOISE_TURN_DEG: f64 = 60.0;
/// A chain that turns by less than ten degrees over the steps of two spacings to either side holds no corner; the
/// squared cosine.
const STRAIGHT_COSINE2: f64 = 0.969_846_310_392_954_2;
/// Least distance of corners, in spacings.
const CORNER_DISTANCE: f64 = 1.5;
/// Vertices to either side of one between which a corner shows, in a chain of nodes: two spacings.
const VERTICES_BESIDE: usize = 3;

/// Corners as (arc, vertex), ascending.
pub(crate) fn corners(band: &Band, noise: f64, turn_deg: f64) -> Vec<(f64, Vertex)> {
    let least = turn_deg + NOISE_TURN_DEG * noise;
    let free = (f64::NEG_INFINITY, f64::INFINITY);
    let turn = |arc: f64| (arc, turn_at(band, arc, noise, free));
    let mut turns: Vec<(f64, f64)> = probes(band).into_iter().map(turn).filter(|t| t.1 >= least).collect();
    turns.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.total_cmp(&b.0)));
    let mut found = Found { corners: BTreeMap::new(), length: band.chain.closed.then_some(band.length) };
    for (arc, turn) in turns {
        let h = spacing_at(band, arc);
        let room = found.room(arc);
        let apart = (arc - room.0).min(room.1 - arc);
        if apart < CORNER_DISTANCE * h || !sudden(band, arc, turn, noise) {
            continue;
        }
        // Far from all others nothing is cut off, and the turn is the one known.
        let own = if apart > 8.0 * h { turn } else { turn_at(band, arc, noise, room) };
        if own < least {
            continue;
        }
        if let Some(vertex) = corner_vertex(band, arc, noise, room) {
            found.corners.insert(arc_of(band, vertex.at, arc).to_bits(), vertex);
        }
    }
    found.corners.into_iter().map(|(bits, vertex)| (f64::from_bits(bits), vertex)).collect()
}

/// The arc of a corner found about `near`: a probe is off by up to half a step, and samples of the one side would be
/// taken for some of the other.
fn arc_of(band: &Band, at: [f64; 2], near: f64) -> f64 {
    let (n, middle) = (segments(band), band.vertex(near));
    let mut best = (f64::INFINITY, near);
    for step in 0..2 * VERTICES_BESIDE {
        let v = (middle + n + step)
            .checked_sub(VERTICES_BESIDE)
            .filter(|&v| band.chain.closed || (n..2 * n).contains(&v));
        let Some(v) = v.map(|v| v % n) else { continue };
        let (from, to) = segment(band, v);
        let (share, off) = onto(from, to, at);
        if off < best.0 {
            best = (off, band.arcs[v] + share * distance(from, to));
        }
    }
    best.1
}

/// Corners found so far, by the bits of their arcs, which order as the arcs do; the length of a closed band.
struct Found {
    corners: BTreeMap<u64, Vertex>,
    length: Option<f64>,
}

impl Found {
    /// The arcs of the nearest corners before and after a place, over the seam of a closed band.
    fn room(&self, arc: f64) -> (f64, f64) {
        let bits = arc.to_bits();
        let arc_of = |entry: Option<(&u64, &Vertex)>| entry.map(|(&bits, _)| f64::from_bits(bits));
        let before = arc_of(self.corners.range(..=bits).next_back());
        let after = arc_of(self.corners.range(bits..).next());
        let wrapped = |entry: Option<f64>, shift: f64| Some(entry? + self.length? * shift);
        (
            before
                .or_else(|| wrapped(arc_of(self.corners.last_key_value()), -1.0))
                .unwrap_or(f64::NEG_INFINITY),
            after.or_else(|| wrapped(arc_of(self.corners.first_key_value()), 1.0)).unwrap_or(f64::INFINITY),
        )
    }
}

fn probes(band: &Band) -> Vec<f64> {
    let mut probes = Vec::new();
    let mut bent = bends(band, 0);
    for (v, &arc) in band.arcs.iter().enumerate() {
        let own = std::mem::replace(&mut bent, bends(band, v + 1));
        if own {
            probes.push(arc);
        }
        let next = band.arcs.get(v + 1).copied().unwrap_or(if band.chain.closed { band.length } else { arc });
        if next > arc && (own || bent) {
            probes.push(0.5 * (arc + next));
        }
    }
    probes
}

/// Whether the chain turns by ten degrees or more at a vertex, or one over the seam of a closed chain.
fn bends(band: &Band, v: usize) -> bool {
    let vertices = &band.chain.vertices;
    let n = vertices.len();
    let at = |k: usize| vertices[k].at;
    let (before, own, after) = if band.chain.closed {
        ((v + n - VERTICES_BESIDE % n) % n, v % n, (v + VERTICES_BESIDE) % n)
    } else {
        (v.saturating_sub(VERTICES_BESIDE), v.min(n - 1), (v + VERTICES_BESIDE).min(n - 1))
    };
    !straight(sub(at(own), at(before)), sub(at(after), at(own)))
}

/// The lines that come into and go out of a place, from samples between two arcs.
fn sides(band: &Band, arc: f64, noise: f64, (low, high): (f64, f64)) -> Option<(Local, Local, f64)> {
    let h = spacing_at(band, band.wrapped(arc));
    let (near, far) = (0.5 * h, (1.2 + width(band, arc, h, noise)) * h);
    if !band.chain.closed && (arc < 1.2 * h || arc > band.length - 1.2 * h) {
        return None;
    }
    // The arc of a corner is known to half a step: samples beside it may still belong to its other side.
    let (low, high) = ((low + 0.75 * h).max(arc - far), (high - 0.75 * h).min(arc + far));
    if arc - near - low < 0.8 * h || high - near - arc < 0.8 * h {
        return None;
    }
    let before = regress(band, arc, far, low, arc - near)?;
    let after = regress(band, arc, far, arc + near, high)?;
    Some((before, after, h))
}

fn turn_at(band: &Band, arc: f64, noise: f64, room: (f64, f64)) -> f64 {
    let step = 2.0 * spacing_at(band, band.wrapped(arc));
    let (before, at, after) = (band.at(arc - step), band.at(arc), band.at(arc + step));
    if straight(sub(at, before), sub(after, at)) {
        return 0.0;
    }
    sides(band, arc, noise, room).map_or(0.0, |(a, b, _)| angle(a.slope, b.slope))
}

fn straight(a: [f64; 2], b: [f64; 2]) -> bool {
    let along = dot(a, b);
    along > 0.0 && along * along > STRAIGHT_COSINE2 * dot(a, a) * dot(b, b)
}

fn angle(a: [f64; 2], b: [f64; 2]) -> f64 {
    dot(unit(a), unit(b)).clamp(-1.0, 1.0).acos().to_degrees()
}

/// Whether the direction turns here and not evenly along the curve, as on a small circle.
fn sudden(band: &Band, arc: f64, turn: f64, noise: f64) -> bool {
    let h = spacing_at(band, arc);
    let step = (2.6 + 3.0 * noise) * h;
    let aside = |s: f64| turn_at(band, arc + s, noise, (f64::NEG_INFINITY, f64::INFINITY));
    let (before, after) = (aside(-step), aside(step));
    0.5 * (before + after) < 0.5 * turn || before.min(after) < 0.2 * turn
}

fn corner_vertex(band: &Band, arc: f64, noise: f64, room: (f64, f64)) -> Option<Vertex> {
    let (before, after, h) = sides(band, arc, noise, room)?;
    let (a, b) = (unit(before.slope), unit(after.slope));
    let middle = along(before.at, sub(after.at, before.at), 0.5);
    let (ahead, _) = meet(before.at, a, after.at, b)?;
    let at = along(before.at, a, ahead);
    let close = distance(at, middle) <= 1.5 * h && distance(at, band.at(arc)) <= 2.0 * h;
    // A corner has samples beside it; a bend of a few spacings, continued straight, has none at its tip.
    let reach = (0.7 + noise) * h;
    let mut held = false;
    band.visit(arc - 2.0 * h, arc + 2.0 * h, |_, s| held |= distance(s.raw, at) <= reach);
    (close && held).then_some(Vertex::corner(at, h))
}
