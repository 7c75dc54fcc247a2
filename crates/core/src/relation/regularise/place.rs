//! Lays a network on the curves of the joint least squares: nodes, typed curves, and the points and the spline of each strip.

use super::super::relations::Regularised;
use super::layout::triple;
use super::rows::System;
use crate::curve::pieces::{Piece, Shape};
use crate::curve::{Ellipse, FitOptions, Round, fit};
use crate::math::vec3::{add_scaled, distance, scale, sub};
use crate::network::{Network, Strip};

/// Weight of the spline's own smoothness: as little as solves it, as the points are on curves.
const CALM: f64 = 1e-4;

/// Lays the network on the unknowns `x`; says how far it moved.
pub(super) fn place(network: &mut Network, system: &System, x: &[f64]) -> Regularised {
    let mut moved = Regularised::default();
    for (node, &at) in network.nodes.iter_mut().zip(&system.layout.joint) {
        let position = triple(x, at);
        moved.nodes.push(distance(node.position, position));
        node.position = position;
    }
    for (s, strip) in network.strips.iter_mut().enumerate() {
        let laid: Vec<Piece> =
            strip.curves.iter().enumerate().map(|(c, piece)| laid(system, x, [s, c], piece)).collect();
        moved.curves.push(strip.curves.iter().zip(&laid).map(|(a, b)| shift(a, b)).collect());
        if !laid.is_empty() {
            points(strip, &laid);
        }
        strip.curves = laid;
        let ends = [strip.start, strip.end].map(|n| n.map(|n| network.nodes[n as usize].position));
        hold(strip, ends);
    }
    moved
}

/// A piece between its joints, on its curve.
fn laid(system: &System, x: &[f64], [s, c]: [usize; 2], piece: &Piece) -> Piece {
    let joints = system.found.joints.ends[s][c].map(|ends| ends.map(|j| triple(x, system.layout.joint[j])));
    let [from, to] = joints.unwrap_or([piece.from, piece.to]);
    let moved = system.found.of[s][c].and_then(|i| {
        let (centre, radius) = (system.layout.centre[i]?, system.layout.radius[i]?);
        let (direction, sign) = system.layout.direction[i]?;
        let centre = triple(x, centre);
        Some(Round { centre, normal: scale(triple(x, direction), sign), radius: x[radius] })
    });
    let turned = |round: Round, old: &Round| match crate::math::vec3::dot(round.normal, old.normal) < 0.0 {
        true => Round { normal: scale(round.normal, -1.0), ..round },
        false => round,
    };
    let (shape, ends) = match (&piece.shape, moved) {
        (Shape::Arc { round: old, .. }, Some(round)) => {
            let round = turned(round, old);
            (Shape::Arc { round, sweep: round.sweep_between(from, to) }, [from, to])
        }
        (Shape::Circle(old), Some(round)) => {
            let round = turned(round, old);
            let at = round.foot(piece.from);
            (Shape::Circle(round), [at, at])
        }
        (Shape::Arc { round, .. }, None) => {
            // Not observed: along with its ends.
            let shift = scale(add_scaled(sub(from, piece.from), sub(to, piece.to), 1.0), 0.5);
            let round = Round { centre: add_scaled(round.centre, shift, 1.0), ..*round };
            let samples = round.samples(from, round.sweep_between(from, to), 17);
            let round = round.through(from, to, &samples, 0.0).unwrap_or(round);
            (Shape::Arc { round, sweep: round.sweep_between(from, to) }, [from, to])
        }
        (Shape::Ellipse { ellipse, .. }, _) => {
            let led = ellipse.through(from, to).filter(|_| joints.is_some());
            (led.map_or(piece.shape.clone(), |e| stretch(e, from, to)), [from, to])
        }
        (Shape::Spline(curve), _) if !curve.periodic => {
            let mut curve = curve.clone();
            let last = curve.controls.len() - 1;
            let (first, end) = (sub(from, curve.controls[0]), sub(to, curve.controls[last]));
            for (k, control) in curve.controls.iter_mut().enumerate() {
                let share = k as f64 / last as f64;
                *control = add_scaled(add_scaled(*control, first, 1.0 - share), end, share);
            }
            (curve.controls[0], curve.controls[last]) = (from, to);
            (Shape::Spline(curve), [from, to])
        }
        (shape, _) => (shape.clone(), [from, to]),
    };
    Piece { shape, from: ends[0], to: ends[1], ..piece.clone() }
}

/// The stretch of an ellipse from one of its points to another.
fn stretch(ellipse: Ellipse, from: [f64; 3], to: [f64; 3]) -> Shape {
    Shape::Ellipse { ellipse, sweep: ellipse.sweep_between(from, to) }
}

/// The greatest distance of a piece's ends, and of the middle of an arc or the centre and the radius of a circle, from where they were.
/// How far the centre of an arc moves says little of the arc.
fn shift(old: &Piece, new: &Piece) -> f64 {
    let ends = distance(old.from, new.from).max(distance(old.to, new.to));
    match (&old.shape, &new.shape) {
        (Shape::Arc { round: a, sweep: s }, Shape::Arc { round: b, sweep: t }) => {
            let middle = |round: &Round, from, sweep| round.samples(from, sweep, 3)[1];
            ends.max(distance(middle(a, old.from, *s), middle(b, new.from, *t)))
        }
        (Shape::Circle(a), Shape::Circle(b)) => {
            ends.max(distance(a.centre, b.centre)).max((a.radius - b.radius).abs())
        }
        _ => ends,
    }
}

/// The points of a strip on its curves, and the spline through them.
fn points(strip: &mut Strip, laid: &[Piece]) {
    let n = strip.points.len();
    let mut at = strip.points.clone();
    for (old, new) in strip.curves.iter().zip(laid) {
        let last = if old.last <= old.first { old.last + n } else { old.last };
        let count = (last - old.first).max(1) as f64;
        for k in old.first..=last {
            let p = strip.points[k % n];
            at[k % n] = match &new.shape {
                Shape::Spline(_) => {
                    let share = (k - old.first) as f64 / count;
                    let along = add_scaled(p, sub(new.from, old.from), 1.0 - share);
                    add_scaled(along, sub(new.to, old.to), share)
                }
                _ => new.foot(p),
            };
        }
    }
    strip.points = at;
}

/// The ends of a strip on its nodes, its spline through its points, and the points on that.
fn hold(strip: &mut Strip, ends: [Option<[f64; 3]>; 2]) {
    let last = strip.points.len() - 1;
    for (at, end) in [0, last].into_iter().zip(ends) {
        if let Some(end) = end {
            strip.points[at] = end;
        }
    }
    let (from, to) = strip.curve.domain();
    let spans = (strip.curve.knots.len() as f64).max(2.0) - 1.0;
    let spans = if strip.closed { spans } else { (spans - 2.0 * strip.curve.degree as f64).max(1.0) };
    let (curve, parameters) =
        fit(&strip.points, FitOptions { span: (to - from) / spans, smoothing: CALM, closed: strip.closed });
    for (p, t) in strip.points.iter_mut().zip(&parameters) {
        *p = curve.point(*t);
    }
    for (at, end) in [0, last].into_iter().zip(ends) {
        if let Some(end) = end {
            strip.points[at] = end;
        }
    }
    strip.curve = curve;
}
