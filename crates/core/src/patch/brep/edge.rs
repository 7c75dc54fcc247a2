//! Edges: the typed curves of a strip, moved onto the surfaces beside it.

use super::vertex::{Vertices, axis, between, meet, off, radial, rounding};
use super::{Brep, Edge, Face};
use crate::curve::pieces::{Piece, Shape};
use crate::curve::{BSpline, Round};
use crate::math::vec3::{add_scaled, cross, distance, dot, norm, scale, sub, unit};
use crate::network::Strip;
use crate::patch::fit::{FLOOR, Surface};
use crate::patch::patches::Patches;
use std::collections::BTreeSet;

/// Points of an edge that are looked at, and at most so many that a spline goes through.
const LOOKED_AT: usize = 32;
const THROUGH: usize = 96;
/// Multiple of the error of a surface's points up to which its edges and vertices may lie off it.
const ASTRAY: f64 = 4.0;
/// Multiple of the scatter of a line's points by which a circle at the end of a surface may move to stand square to its axis.
const SCATTER: f64 = 3.0;
/// Distance from an end of an edge, as a share of the mean step, within which points are left out.
const CLEAR: f64 = 0.8;
/// Sine of the angle between two surfaces from which on they say where their edge goes.
const CROSSING: f64 = 0.1;
/// Share of a radius up to which the ends of an arc are one.
const ROUNDING: f64 = 1e-9;

/// The edges of a strip in their order.
pub(super) fn edges(strip: &Strip, number: u32, vertices: &mut Vertices) -> Vec<Edge> {
    let surfaces = vertices.beside(number);
    let planes = surfaces.len() > 1 && surfaces.iter().all(|s| matches!(s, Surface::Plane { .. }));
    let first = strip.start.map(|node| vertices.of_node(node));
    let last = strip.end.map(|node| vertices.of_node(node));
    if let (true, Some(a), Some(b)) = (planes, first, last)
        && a != b
    {
        // Two planes meet in one line, whatever its pieces were.
        return vec![Edge { shape: Shape::Line, ends: [a, b], strip: number }];
    }
    let whole = |piece: &Piece| matches!(piece.shape, Shape::Circle(_)) || piece.from == piece.to;
    let begin = first.unwrap_or_else(|| vertices.add(meet(strip.curves[0].from, &surfaces)));
    let mut from = begin;
    let mut found = Vec::new();
    for (k, piece) in strip.curves.iter().enumerate() {
        let closing = k + 1 == strip.curves.len();
        let to = match last {
            _ if whole(piece) && !closing => from,
            Some(last) if closing => last,
            None if closing => begin,
            _ => vertices.add(meet(piece.to, &surfaces)),
        };
        let samples = samples(strip, piece, [vertices.at(from), vertices.at(to)], &surfaces);
        let shape = shape(piece, &samples, &surfaces, vertices.residual(number));
        if let (Shape::Circle(round), None) = (&shape, first) {
            // A loop without nodes begins where its circle does.
            vertices.positions[from as usize] = round.foot(vertices.at(from));
        }
        found.push(Edge { shape, ends: [from, to], strip: number });
        from = to;
    }
    found
}

/// Points of a piece on all of the surfaces, with its ends.
fn samples(strip: &Strip, piece: &Piece, [from, to]: [[f64; 3]; 2], surfaces: &[Surface]) -> Vec<[f64; 3]> {
    let count = strip.points.len();
    let steps =
        if piece.last > piece.first { piece.last - piece.first } else { piece.last + count - piece.first };
    let every = steps.div_ceil(THROUGH).max(1);
    let inner = (every..steps).step_by(every).map(|k| strip.points[(piece.first + k) % count]);
    let mut points = vec![from];
    points.extend(inner.map(|p| meet(p, surfaces)));
    // Where pieces meet a vertex may have passed the points beside it.
    let length: f64 = points.windows(2).map(|w| distance(w[0], w[1])).sum();
    let step = length / points.len() as f64;
    points.retain(|&p| p == from || distance(p, from).min(distance(p, to)) > CLEAR * step);
    if points.len() < 3 && distance(from, to) > 0.0 {
        points.truncate(1);
        points.extend(between(from, to, 4).map(|p| meet(p, surfaces)));
    }
    points.push(to);
    points
}

/// The curve of the piece's kind through the ends of the samples, if it lies on the surfaces as well as their points do; else a spline.
fn shape(piece: &Piece, samples: &[[f64; 3]], surfaces: &[Surface], residual: f64) -> Shape {
    let (from, to) = (samples[0], samples[samples.len() - 1]);
    let typed = match &piece.shape {
        Shape::Line => Some(Shape::Line),
        Shape::Arc { round, .. } | Shape::Circle(round) => {
            rounded(*round, samples, surfaces, SCATTER * piece.deviation + residual)
        }
        Shape::Ellipse { .. } | Shape::Spline(_) => None,
    };
    let most = residual.max(rounding(samples));
    typed
        .filter(|shape| points(shape, [from, to]).iter().all(|&p| off(p, surfaces) <= most))
        .unwrap_or_else(|| Shape::Spline(through(samples, surfaces)))
}

/// The arc or circle of samples, in the plane of a face where one is a plane, and with the turn of the one before.
fn rounded(before: Round, samples: &[[f64; 3]], surfaces: &[Surface], most: f64) -> Option<Shape> {
    let (from, to) = (samples[0], samples[samples.len() - 1]);
    let closed = distance(from, to) <= ROUNDING * before.radius;
    let row = if closed { &samples[..samples.len() - 1] } else { samples };
    let mut round = Round::fit(row).unwrap_or(before);
    let plane = surfaces.iter().find_map(|s| match s {
        Surface::Plane { normal, .. } => Some(*normal),
        _ => None,
    });
    round.normal = plane.unwrap_or(round.normal);
    if let [surface] = surfaces {
        round = about(round, row, surface, most);
    }
    if dot(round.normal, before.normal) < 0.0 {
        round.normal = scale(round.normal, -1.0);
    }
    if closed {
        // A circle says nothing of the way it is gone: that of the strip.
        if round.sweep(samples) < 0.0 {
            round.normal = scale(round.normal, -1.0);
        }
        return Some(Shape::Circle(round));
    }
    let round = round.through(from, to, samples, 0.0)?;
    Some(Shape::Arc { round, sweep: round.sweep_between(from, to) })
}

/// The circle about the axis of a surface that ends there, if it lies no farther than `most` from another circle.
fn about(round: Round, samples: &[[f64; 3]], surface: &Surface, most: f64) -> Round {
    let Some((on, axis)) = axis(surface) else { return round };
    let centre = add_scaled(on, axis, dot(sub(round.centre, on), axis));
    let reach = samples.iter().map(|&p| norm(radial((on, axis), p))).sum::<f64>() / samples.len() as f64;
    let tilt = norm(cross(axis, round.normal)) * round.radius;
    let moved = tilt + distance(centre, round.centre) + (reach - round.radius).abs();
    if moved <= most { Round { centre, normal: axis, radius: reach } } else { round }
}

/// The cubic spline through points, along both surfaces where there are two that cross, else with the slopes of parabolas through
/// three points each.
fn through(points: &[[f64; 3]], surfaces: &[Surface]) -> BSpline {
    let mut points = points.to_vec();
    points.dedup();
    let steps: Vec<f64> = points.windows(2).map(|w| distance(w[0], w[1])).collect();
    let chord = |k: usize| scale(sub(points[k + 1], points[k]), 1.0 / steps[k]);
    let last = steps.len() - 1;
    let rough = |k: usize| match (k, k > last) {
        (0, _) if last == 0 => chord(0),
        (0, _) => parabola(chord(0), chord(1), -steps[0] / (steps[0] + steps[1])),
        (_, true) if last == 0 => chord(0),
        (_, true) => {
            parabola(chord(last - 1), chord(last), 1.0 + steps[last] / (steps[last - 1] + steps[last]))
        }
        _ => parabola(chord(k - 1), chord(k), steps[k - 1] / (steps[k - 1] + steps[k])),
    };
    let slope = |k: usize| {
        let rough = rough(k);
        match surfaces {
            [a, b] => {
                let exact = cross(a.normal(points[k]), b.normal(points[k]));
                if norm(exact) > CROSSING { scale(unit(exact), dot(exact, rough).signum()) } else { rough }
            }
            _ => rough,
        }
    };
    let (mut knots, mut controls) = (vec![0.0; 4], vec![points[0]]);
    let mut at = 0.0;
    for k in 0..=last {
        at += steps[k];
        knots.extend(std::iter::repeat_n(at, if k == last { 4 } else { 2 }));
        controls.push(add_scaled(points[k], slope(k), steps[k] / 3.0));
        controls.push(add_scaled(points[k + 1], slope(k + 1), -steps[k] / 3.0));
    }
    controls.push(points[last + 1]);
    BSpline { degree: 3, knots, controls, periodic: false }
}

/// The slope between two chords by a share of the way from the first to the second, or beyond them.
fn parabola(a: [f64; 3], b: [f64; 3], share: f64) -> [f64; 3] {
    add_scaled(scale(a, 1.0 - share), b, share)
}

/// Points along a curve, from end to end.
pub(super) fn points(shape: &Shape, [from, to]: [[f64; 3]; 2]) -> Vec<[f64; 3]> {
    match shape {
        Shape::Line => [from].into_iter().chain(between(from, to, LOOKED_AT)).chain([to]).collect(),
        Shape::Arc { round, sweep } => round.samples(from, *sweep, LOOKED_AT + 1),
        Shape::Circle(round) => round.samples(from, std::f64::consts::TAU, LOOKED_AT + 1),
        Shape::Ellipse { ellipse, sweep } => {
            let first = ellipse.angle(from);
            (0..=LOOKED_AT).map(|k| ellipse.at(first + sweep * k as f64 / LOOKED_AT as f64)).collect()
        }
        Shape::Spline(curve) => {
            let (first, last) = curve.domain();
            let count = LOOKED_AT.max(2 * curve.controls.len());
            (0..=count).map(|k| curve.point(first + (last - first) * k as f64 / count as f64)).collect()
        }
    }
}

/// Distance of an edge from a surface, and of its vertices from it and from its ends.
fn apart(found: &Brep, edge: &Edge, surface: &Surface) -> f64 {
    let ends = edge.ends.map(|v| found.vertices[v as usize]);
    let points = points(&edge.shape, ends);
    let on = points.iter().chain(&ends).map(|&p| surface.distance(p).abs()).fold(0.0, f64::max);
    let met = match &edge.shape {
        Shape::Line => 0.0,
        _ => distance(points[0], ends[0]).max(distance(points[points.len() - 1], ends[1])),
    };
    f64::max(on, met)
}

/// The greatest distance of the edges of a face from it.
pub(super) fn gap_of(found: &Brep, face: &Face) -> f64 {
    let edges = face.loops.iter().flatten().map(|e| &found.edges[e.0 as usize]);
    edges.map(|edge| apart(found, edge, &face.surface)).fold(0.0, f64::max)
}

/// Each face with the greatest distance of its edges from it.
fn gaps(found: &Brep) -> impl Iterator<Item = (u32, f64)> {
    found.faces.iter().map(|face| (face.patch, gap_of(found, face)))
}

/// The greatest gap of all faces.
pub(super) fn gap(found: &Brep) -> f64 {
    gaps(found).map(|(_, gap)| gap).fold(0.0, f64::max)
}

/// The patches whose edges lie off their surface by more than its points explain.
pub(super) fn astray(found: &Brep, patches: &Patches) -> BTreeSet<u32> {
    let rounding = rounding(&found.vertices);
    let most = |p: u32| {
        let patch = &patches.patches[p as usize];
        let spacing = (patch.area / patch.points.max(1) as f64).sqrt();
        ASTRAY * patch.fit.residual.max(FLOOR * spacing) + rounding
    };
    gaps(found).filter(|&(p, gap)| !gap.is_finite() || gap > most(p)).map(|(p, _)| p).collect()
}
