//! The middle of a band: corners where two straight continuations meet, local lines between them.

use super::band::Band;
use super::link::{Chain, Vertex};
use super::vec2::{along, distance, dot, meet, sub, unit};

/// A line fitted to the samples of a stretch of a band: position and direction as functions of the arc.
#[derive(Clone, Copy, Debug)]
struct Local {
    at: [f64; 2],
    slope: [f64; 2],
}

/// Weighted regression of position on arc, evaluated at `centre`, over samples from `from` to `to` with a kernel of
/// half-width `width`; `None` with fewer than three samples.
fn regress(band: &Band, centre: f64, width: f64, from: f64, to: f64) -> Option<Local> {
    let mut sums = [0.0f64; 7];
    let mut count = 0;
    band.visit(from.max(centre - width), to.min(centre + width), |arc, sample| {
        let u = (arc - centre) / width;
        let kernel = (1.0 - u * u).max(0.0).powi(2) / (1.0 + sample.lift * sample.lift);
        count += 1;
        let values = [1.0, u, u * u, sample.raw[0], sample.raw[1], u * sample.raw[0], u * sample.raw[1]];
        for (sum, value) in sums.iter_mut().zip(values) {
            *sum += kernel * value;
        }
    });
    let [w, su, suu, sx, sy, sux, suy] = sums;
    if count < 3 || w <= 0.0 {
        return None;
    }
    let determinant = w * suu - su * su;
    if determinant <= 1e-4 * w * w {
        return None;
    }
    let fit = |s: f64, t: f64| ((suu * s - su * t) / determinant, (w * t - su * s) / determinant / width);
    let ((x, dx), (y, dy)) = (fit(sx, sux), fit(sy, suy));
    Some(Local { at: [x, y], slope: [dx, dy] })
}

/// Like [`regress`] with a parabola, so that a bend of few spacings is not cut short; where samples lie to one side
/// or are few, a parabola runs wild and the line is taken.
fn parabola(band: &Band, centre: f64, width: f64, from: f64, to: f64) -> Option<Local> {
    let wide = PARABOLA * width;
    if from > centre - 0.7 * wide || to < centre + 0.7 * wide {
        return regress(band, centre, width, from, to);
    }
    let mut moments = [0.0f64; 5];
    let mut right = [[0.0f64; 2]; 3];
    let mut count = 0;
    band.visit(from.max(centre - wide), to.min(centre + wide), |arc, sample| {
        let u = (arc - centre) / wide;
        let kernel = (1.0 - u * u).max(0.0).powi(2) / (1.0 + sample.lift * sample.lift);
        let powers = [1.0, u, u * u, u * u * u, u * u * u * u];
        count += 1;
        for (moment, power) in moments.iter_mut().zip(powers) {
            *moment += kernel * power;
        }
        for (row, power) in right.iter_mut().zip(powers) {
            row[0] += kernel * power * sample.raw[0];
            row[1] += kernel * power * sample.raw[1];
        }
    });
    let [a, b, c, d, e] = moments;
    let determinant = a * (c * e - d * d) - b * (b * e - c * d) + c * (b * d - c * c);
    if count < 8 || determinant <= 1e-3 * a * c * e {
        return regress(band, centre, width, from, to);
    }
    let at = |k: usize| {
        let [r, s, t] = [right[0][k], right[1][k], right[2][k]];
        (r * (c * e - d * d) - b * (s * e - d * t) + c * (s * d - c * t)) / determinant
    };
    let slope = |k: usize| {
        let [r, s, t] = [right[0][k], right[1][k], right[2][k]];
        (a * (s * e - d * t) - r * (b * e - c * d) + c * (b * t - c * s)) / determinant / wide
    };
    Some(Local { at: [at(0), at(1)], slope: [slope(0), slope(1)] })
}

/// How much wider a parabola's kernel is than a line's, for about the same scatter.
const PARABOLA: f64 = 1.5;

/// The smooth middle of a band, given the noise in local spacings.
pub(crate) fn middle(band: &Band, noise: f64) -> Chain {
    let corners = corners(band, noise);
    let mut vertices = Vec::new();
    if corners.is_empty() {
        stretch(band, noise, 0.0, band.length, false, &mut vertices);
        if !band.chain.closed {
            vertices.extend(end_vertex(band, noise));
        }
        return Chain { vertices, closed: band.chain.closed };
    }
    if !band.chain.closed {
        stretch(band, noise, 0.0, corners[0].0, false, &mut vertices);
    }
    for (k, corner) in corners.iter().enumerate() {
        vertices.push(corner.1);
        let last = k + 1 == corners.len();
        let end = match (last, band.chain.closed) {
            (false, _) => corners[k + 1].0,
            (true, true) => corners[0].0 + band.length,
            (true, false) => band.length,
        };
        stretch(band, noise, corner.0, end, true, &mut vertices);
    }
    if !band.chain.closed {
        vertices.extend(end_vertex(band, noise));
    }
    Chain { vertices, closed: band.chain.closed }
}

/// Half-width of the kernel in local spacings: wider with noise and on slanted surfaces.
fn width(band: &Band, arc: f64, spacing: f64, noise: f64) -> f64 {
    1.8 + 3.0 * noise + 3.0 * (blur(band, arc, spacing) - 0.3 * noise).clamp(0.0, 1.0)
}

fn blur(band: &Band, arc: f64, spacing: f64) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    band.visit(arc - 1.5 * spacing, arc + 1.5 * spacing, |_, sample| {
        sum += sample.blur;
        count += 1.0;
    });
    if count > 0.0 { sum / count } else { 0.0 }
}

fn spacing_at(band: &Band, arc: f64) -> f64 {
    let v = band.arcs.partition_point(|&a| a <= arc).saturating_sub(1);
    band.chain.vertices[v.min(band.chain.vertices.len() - 1)].spacing
}

/// Vertices between two arcs, a little under a spacing apart; the samples used stay between the arcs where those
/// are corners.
fn stretch(band: &Band, noise: f64, from: f64, to: f64, corner: bool, vertices: &mut Vec<Vertex>) {
    let h = spacing_at(band, 0.5 * (from + to)).max(1e-300);
    let pieces = (((to - from) / (0.8 * h)).round().max(1.0)).min(4e6) as usize;
    let whole = !corner && band.chain.closed;
    let (low, high) = if whole { (f64::NEG_INFINITY, f64::INFINITY) } else { (from, to) };
    for k in usize::from(corner)..pieces {
        let arc = from + (to - from) * k as f64 / pieces as f64;
        let local_h = spacing_at(band, arc.rem_euclid(band.length.max(1e-300)));
        if let Some(local) = parabola(band, arc, width(band, arc, local_h, noise) * local_h, low, high) {
            // Far from the polyline the regression runs away on too few samples.
            let at = if distance(local.at, band.at(arc)) <= local_h { local.at } else { band.at(arc) };
            vertices.push(Vertex { at, spacing: local_h, corner: false, weak: false });
        }
    }
}

fn end_vertex(band: &Band, noise: f64) -> Option<Vertex> {
    let h = spacing_at(band, band.length);
    regress(band, band.length, width(band, band.length, h, noise) * h, f64::NEG_INFINITY, f64::INFINITY)
        .map(|local| Vertex { at: local.at, spacing: h, corner: false, weak: false })
}

/// Least turn at a corner in degrees, without noise and what noise adds.
const LEAST_TURN: (f64, f64) = (25.0, 60.0);

/// Corners as (arc, vertex), ascending: places where the direction turns at once and hardly on either side.
fn corners(band: &Band, noise: f64) -> Vec<(f64, Vertex)> {
    let turns: Vec<(f64, f64)> =
        probes(band).into_iter().map(|arc| (arc, turn_at(band, arc, noise))).collect();
    let least = LEAST_TURN.0 + LEAST_TURN.1 * noise;
    let mut order: Vec<usize> = (0..turns.len()).filter(|&i| turns[i].1 >= least).collect();
    order.sort_by(|&a, &b| turns[b].1.total_cmp(&turns[a].1).then(a.cmp(&b)));
    let mut found: Vec<(f64, Vertex)> = Vec::new();
    for i in order {
        let (arc, turn) = turns[i];
        let h = spacing_at(band, arc);
        let gap = |a: f64| {
            let d = (a - arc).abs();
            if band.chain.closed { d.min(band.length - d) } else { d }
        };
        if found.iter().any(|f| gap(f.0) < 1.5 * h) || !sudden(band, arc, turn, noise) {
            continue;
        }
        if let Some(vertex) = corner_vertex(band, arc, noise) {
            found.push((arc, vertex));
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
}

fn probes(band: &Band) -> Vec<f64> {
    let mut probes = Vec::new();
    for (v, &arc) in band.arcs.iter().enumerate() {
        probes.push(arc);
        let next = band.arcs.get(v + 1).copied().unwrap_or(if band.chain.closed { band.length } else { arc });
        if next > arc {
            probes.push(0.5 * (arc + next));
        }
    }
    probes
}

/// The lines that come into and go out of a place.
fn sides(band: &Band, arc: f64, noise: f64) -> Option<(Local, Local, f64)> {
    let h = spacing_at(band, arc.rem_euclid(band.length.max(1e-300)));
    let (near, far) = (0.5 * h, (1.2 + width(band, arc, h, noise)) * h);
    if !band.chain.closed && (arc < 1.2 * h || arc > band.length - 1.2 * h) {
        return None;
    }
    let before = regress(band, arc, far, arc - far, arc - near)?;
    let after = regress(band, arc, far, arc + near, arc + far)?;
    Some((before, after, h))
}

/// A chain that turns less than this, degrees, over the steps of two spacings to either side holds no corner.
const STRAIGHT: f64 = 10.0;

fn turn_at(band: &Band, arc: f64, noise: f64) -> f64 {
    let step = 2.0 * spacing_at(band, arc.rem_euclid(band.length.max(1e-300)));
    let (before, at, after) = (band.at(arc - step), band.at(arc), band.at(arc + step));
    if angle(sub(at, before), sub(after, at)) < STRAIGHT {
        return 0.0;
    }
    sides(band, arc, noise).map_or(0.0, |(a, b, _)| angle(a.slope, b.slope))
}

fn angle(a: [f64; 2], b: [f64; 2]) -> f64 {
    dot(unit(a), unit(b)).clamp(-1.0, 1.0).acos().to_degrees()
}

/// Whether the direction turns here and not evenly along the curve, as on a small circle.
fn sudden(band: &Band, arc: f64, turn: f64, noise: f64) -> bool {
    let h = spacing_at(band, arc);
    let step = (2.6 + 3.0 * noise) * h;
    let aside = |s: f64| turn_at(band, arc + s, noise);
    let beside = 0.5 * (aside(-step) + aside(step));
    beside < 0.5 * turn || aside(-step).min(aside(step)) < 0.2 * turn
}

fn corner_vertex(band: &Band, arc: f64, noise: f64) -> Option<Vertex> {
    let (before, after, h) = sides(band, arc, noise)?;
    let (a, b) = (unit(before.slope), unit(after.slope));
    let middle = along(before.at, sub(after.at, before.at), 0.5);
    let (ahead, _) = meet(before.at, a, after.at, b)?;
    let at = along(before.at, a, ahead);
    let close = distance(at, middle) <= 1.5 * h && distance(at, band.at(arc)) <= 2.0 * h;
    // A corner has samples beside it; a bend of a few spacings, continued straight, has none at its tip.
    let reach = (0.7 + noise) * h;
    let mut held = false;
    band.visit(arc - 2.0 * h, arc + 2.0 * h, |_, s| held |= distance(s.raw, at) <= reach);
    (close && held).then_some(Vertex { at, spacing: h, corner: true, weak: false })
}
