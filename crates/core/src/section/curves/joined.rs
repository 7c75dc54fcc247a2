//! Pieces that meet: where they touch, where they cross, or else half way between them.

use super::breaks::means;
use super::data::{Blocks, Datum};
use super::primitive::{Primitive, sweep};
use super::tangent::{Fitted, settled};
use super::touch::{Joint, mark, touching};
use super::{Piece, Shape};
use crate::curve::circle::Circle;
use crate::curve::pieces::ellipse;
use crate::curve::pieces::noise::{Kind, Noise, Span};
use crate::curve::round::Round;
use crate::math::vec2::{along, cross, distance, dot, sub, unit};

/// Farthest from where the data break that two curves may cross, spacings.
const REACH: f64 = 4.0;
/// Length at an end of a contour, spacings, whose data tell where it is.
const END: f64 = 3.0;
/// Difference of the angle an arc sweeps and that of its data, radians, from which on it goes the other way.
const OTHER_WAY: f64 = 1.5;
/// Weight of an arc's own radius, against one datum, where its ends are given.
const HOLD: f64 = 10.0;

/// The pieces of the spans in order; `ends` those of an open contour.
pub(super) fn joined(
    blocks: &Blocks,
    spans: &[Span],
    noise: &Noise,
    spacing: f64,
    ends: Option<[[f64; 2]; 2]>,
) -> Vec<Piece> {
    let fitted = |span: &Span| {
        let data = &blocks.data[span.first..span.last];
        settled(Fitted { curve: primitive(span.kind, data), data }, noise.sigma)
    };
    let curves: Vec<Fitted> = spans.iter().map(fitted).collect();
    let n = spans.len();
    let closed = ends.is_none();
    let count = if closed { n } else { n - 1 };
    let joint = |k: usize| {
        let (before, after) = (curves[k].data, curves[(k + 1) % n].data);
        let at = along(before[before.len() - 1].at, sub(after[0].at, before[before.len() - 1].at), 0.5);
        Joint { before: k, after: (k + 1) % n, at, smooth: false }
    };
    let mut joints: Vec<Joint> = (0..count).map(joint).collect();
    mark(&curves, &mut joints, noise);
    let curves = touching(&curves, &mut joints, noise);
    let places: Vec<[f64; 2]> = joints.iter().map(|j| place(&curves, j, spacing)).collect();
    let from = |k: usize| match (k, ends) {
        (0, Some([first, _])) => end(&curves[0], first, -1.0, spacing),
        (0, None) => places[count - 1],
        _ => places[k - 1],
    };
    let to = |k: usize| match ends {
        Some([_, last]) if k + 1 == n => end(&curves[k], last, 1.0, spacing),
        _ => places[k],
    };
    (0..n).map(|k| piece(blocks, &spans[k], &curves[k], noise, [from(k), to(k)])).collect()
}

/// The end of an open contour near its last vertex: on the curve, as far as the data lead. `side` is 1 at its end and -1 at its beginning.
fn end(fitted: &Fitted, vertex: [f64; 2], side: f64, spacing: f64) -> [f64; 2] {
    let foot = fitted.curve.foot(vertex);
    let way = fitted.curve.way(foot);
    let ahead = |d: &Datum| side * dot(sub(d.at, foot), way);
    // Not those of the other end of an arc.
    let beside = fitted.data.iter().filter(|d| distance(d.at, foot) <= END * spacing);
    let near: Vec<f64> = beside.map(ahead).collect();
    let Some(most) = near.iter().copied().max_by(f64::total_cmp) else { return foot };
    // Evenly strewn data end half a gap, or on the average a whole one, before what they lie on.
    let gap = ((most + END * spacing) / near.len() as f64).min(0.5 * spacing);
    fitted.curve.foot(along(foot, way, side * (most + gap)))
}

fn primitive(kind: Kind, data: &[Datum]) -> Primitive {
    match kind {
        Kind::Line => Primitive::line(data),
        Kind::Arc => match Primitive::arc(data) {
            // Too flat for a circle.
            Primitive::Free => Primitive::line(data),
            arc => arc,
        },
        Kind::Ellipse | Kind::Spline(_) => Primitive::Free,
    }
}

/// Where the pieces of a joint meet.
fn place(curves: &[Fitted], joint: &Joint, spacing: f64) -> [f64; 2] {
    let (a, b) = (&curves[joint.before].curve, &curves[joint.after].curve);
    if joint.smooth
        && let Some(at) = touched(a, b)
    {
        return at;
    }
    match a.meet(b, joint.at).filter(|&at| distance(at, joint.at) <= REACH * spacing) {
        Some(at) => at,
        None => {
            let (p, q) = (a.foot(joint.at), b.foot(joint.at));
            match (a, b) {
                // A line ends anywhere, an arc and a spline on themselves.
                (Primitive::Line(_), Primitive::Arc { .. }) => q,
                (Primitive::Arc { .. }, Primitive::Line(_)) => p,
                (Primitive::Free, _) => q,
                (_, Primitive::Free) => p,
                _ => along(p, sub(q, p), 0.5),
            }
        }
    }
}

/// Where two curves touch that do.
fn touched(a: &Primitive, b: &Primitive) -> Option<[f64; 2]> {
    match (a, b) {
        (Primitive::Line(line), Primitive::Arc { circle, .. })
        | (Primitive::Arc { circle, .. }, Primitive::Line(line)) => {
            Some(circle.foot(line.foot(circle.centre)))
        }
        (Primitive::Arc { circle: a, left: l }, Primitive::Arc { circle: b, left: m }) => {
            // From the greater centre through the other one, or between both.
            let (large, small) = if a.radius >= b.radius { (a, b) } else { (b, a) };
            let way = unit(sub(small.centre, large.centre));
            Some(along(small.centre, way, if l == m { small.radius } else { -small.radius }))
        }
        _ => None,
    }
}

fn piece(blocks: &Blocks, span: &Span, fitted: &Fitted, noise: &Noise, [from, to]: [[f64; 2]; 2]) -> Piece {
    let shape = match fitted.curve {
        Primitive::Line(_) => Shape::Line,
        Primitive::Arc { circle, left } => arc(&circle, left, fitted.data, [from, to]),
        Primitive::Free if span.kind == Kind::Ellipse => oval(blocks, span, noise, [from, to]),
        Primitive::Free => spline(blocks, span, noise, [from, to]),
    };
    Piece { shape, from, to, worst: 0.0 }
}

/// The arc between two points, moved to lead through both; a line where it would go the other way.
fn arc(circle: &Circle, left: bool, data: &[Datum], [from, to]: [[f64; 2]; 2]) -> Shape {
    let mut points: Vec<[f64; 2]> = data.iter().map(|d| d.at).collect();
    let circle = if circle.off(from).max(circle.off(to)) <= 1e-9 * circle.radius {
        *circle
    } else {
        let lift = |p: [f64; 2]| [p[0], p[1], 0.0];
        let round = Round { centre: lift(circle.centre), normal: [0.0, 0.0, 1.0], radius: circle.radius };
        let lifted: Vec<[f64; 3]> = points.iter().map(|&p| lift(p)).collect();
        match round.through(lift(from), lift(to), &lifted, HOLD) {
            Some(Round { centre: [x, y, _], radius, .. }) => Circle { centre: [x, y], radius },
            None => return Shape::Line,
        }
    };
    let (a, b) = (sub(from, circle.centre), sub(to, circle.centre));
    let turn = cross(a, b).atan2(dot(a, b));
    let turn = if left {
        turn.rem_euclid(std::f64::consts::TAU)
    } else {
        -(-turn).rem_euclid(std::f64::consts::TAU)
    };
    points.insert(0, from);
    points.push(to);
    if (turn - sweep(&circle, &points)).abs() > OTHER_WAY {
        return Shape::Line;
    }
    Shape::Arc { centre: circle.centre, radius: circle.radius, sweep: turn }
}

/// The ellipse of a span between two points; a spline where it does not lead through both.
fn oval(blocks: &Blocks, span: &Span, noise: &Noise, [from, to]: [[f64; 2]; 2]) -> Shape {
    let lift = |[x, y]: [f64; 2]| [x, y, 0.0];
    let mut row = vec![lift(from)];
    row.extend(means(blocks, noise, span.first, span.last).0);
    row.push(lift(to));
    match ellipse(&row) {
        Some(crate::curve::pieces::Shape::Ellipse { ellipse, sweep }) => Shape::of_ellipse(&ellipse, sweep),
        _ => spline(blocks, span, noise, [from, to]),
    }
}

/// The spline of a span between two points; a line where that would be as good.
fn spline(blocks: &Blocks, span: &Span, noise: &Noise, [from, to]: [[f64; 2]; 2]) -> Shape {
    let lift = |[x, y]: [f64; 2]| [x, y, 0.0];
    let mut points = vec![lift(from)];
    let mut weights = vec![1.0];
    for sum in blocks.within(span.first, span.last) {
        points.push(lift(sum.mean()));
        weights.push(sum.weight);
    }
    points.push(lift(to));
    weights.push(1.0);
    if points.len() < 4 {
        return Shape::Line;
    }
    let (curve, ..) = crate::curve::pieces::spline(&points, &weights, noise, false);
    if curve.degree < 3 { Shape::Line } else { Shape::Free(curve.mapped(|[x, y, _]| [x, y], 1.0)) }
}
