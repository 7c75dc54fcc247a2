//! Contours as lines, arcs, circles and splines within a tolerance, corners kept.
//!
//! Each stretch between corners is cut into lines and arcs (`greedy`); splines follow the rest.

pub(crate) mod greedy;
pub(crate) mod nest;

use crate::curve::circle::Circle;
use crate::curve::{BSpline, fit_within};
use crate::math::vec2::{along, distance, meet, onto, sub};
use crate::section::contour::chain::Vertex;
use greedy::{ARC_VERTICES, Kind, Stretch, cut, longest, sweep};

/// A piece of a contour in the slicing plane.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shape {
    /// Straight between its ends.
    Line,
    /// Circle about `centre`; `sweep` in radians, positive counter-clockwise.
    Arc { centre: [f64; 2], radius: f64, sweep: f64 },
    /// A whole circle.
    Circle { centre: [f64; 2], radius: f64 },
    /// A curve of neither kind.
    Free(BSpline<2>),
}

/// A fitted piece.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Piece {
    /// Its kind with its parameters.
    pub shape: Shape,
    /// Where it begins; the next piece begins where it ends.
    pub from: [f64; 2],
    /// Where it ends.
    pub to: [f64; 2],
    /// Greatest distance from a vertex.
    pub worst: f64,
}

/// The pieces of a contour in order.
pub(crate) fn fit(vertices: &[Vertex], closed: bool, tolerance: f64) -> Vec<Piece> {
    let points: Vec<[f64; 2]> = vertices.iter().map(|v| v.at).collect();
    if points.len() < 2 {
        return Vec::new();
    }
    if let Some(piece) = whole_circle(&points, closed, tolerance) {
        return vec![piece];
    }
    let (points, corners) = opened(vertices, &points, closed, tolerance);
    let mut stretches = Vec::new();
    for w in corners.windows(2) {
        cut(&points, w[0], w[1], tolerance, &mut stretches);
    }
    pieces(&points, &stretches, closed, tolerance)
}

fn whole_circle(points: &[[f64; 2]], closed: bool, tolerance: f64) -> Option<Piece> {
    if !closed || points.len() < ARC_VERTICES {
        return None;
    }
    let round = Circle::fit(points)?;
    let worst = points.iter().map(|&p| round.off(p)).fold(0.0, f64::max);
    let shape = Shape::Circle { centre: round.centre, radius: round.radius };
    // Twice the tolerance: one vertex aside should not break a circle into arcs.
    let mean = points.iter().map(|&p| round.off(p)).sum::<f64>() / points.len() as f64;
    let fits = worst <= 2.0 * tolerance && mean <= 0.7 * tolerance && worst < 0.3 * round.radius;
    let at = round.foot(points[0]);
    fits.then_some(Piece { shape, from: at, to: at, worst })
}

/// A contour as an open row of points with the places of its corners, both ends included. A closed one begins, and
/// ends again, at a corner, or else where a first greedy piece ends.
fn opened(
    vertices: &[Vertex],
    points: &[[f64; 2]],
    closed: bool,
    tolerance: f64,
) -> (Vec<[f64; 2]>, Vec<usize>) {
    let n = points.len();
    let start = match (closed, vertices.iter().position(|v| v.corner)) {
        (false, _) => 0,
        (true, Some(corner)) => corner,
        (true, None) => longest(points, 0, n - 1, tolerance).last % n,
    };
    let count = if closed { n + 1 } else { n };
    let turned: Vec<[f64; 2]> = (0..count).map(|k| points[(start + k) % n]).collect();
    let inner = (1..count - 1).filter(|k| vertices[(start + k) % n].corner);
    (turned, std::iter::once(0).chain(inner).chain([count - 1]).collect())
}

fn pieces(points: &[[f64; 2]], stretches: &[Stretch], closed: bool, tolerance: f64) -> Vec<Piece> {
    let n = stretches.len();
    let inner = |k: usize| joint(points, &stretches[k], &stretches[(k + 1) % n], tolerance);
    let mut joints: Vec<[f64; 2]> = Vec::with_capacity(n + 1);
    let closing = (closed && n > 1).then(|| inner(n - 1));
    joints.push(closing.unwrap_or(points[0]));
    (0..n.saturating_sub(1)).for_each(|k| joints.push(inner(k)));
    joints.push(closing.unwrap_or(points[points.len() - 1]));
    let piece = |(k, own): (usize, &Stretch)| shape(points, own, joints[k], joints[k + 1], tolerance);
    stretches.iter().enumerate().map(piece).collect()
}

/// Where two stretches meet: where their lines cross, if that is near the vertex they share, else between its feet.
fn joint(points: &[[f64; 2]], a: &Stretch, b: &Stretch, tolerance: f64) -> [f64; 2] {
    let vertex = points[a.last];
    if let (Kind::Line(l), Kind::Line(m)) = (a.kind, b.kind) {
        let crossing = meet(l.at, l.direction, m.at, m.direction).map(|(s, _)| along(l.at, l.direction, s));
        if let Some(at) = crossing.filter(|&at| distance(at, vertex) <= 3.0 * tolerance) {
            return at;
        }
    }
    let foot = |s: &Stretch| match s.kind {
        Kind::Line(line) => line.foot(vertex),
        Kind::Arc(round) => round.foot(vertex),
        Kind::Free => vertex,
    };
    let (p, q) = (foot(a), foot(b));
    along(p, sub(q, p), 0.5)
}

fn shape(points: &[[f64; 2]], own: &Stretch, from: [f64; 2], to: [f64; 2], tolerance: f64) -> Piece {
    let points = &points[own.first..=own.last];
    let piece = |shape, off: &dyn Fn([f64; 2]) -> f64| Piece {
        shape,
        from,
        to,
        worst: points.iter().map(|&p| off(p)).fold(0.0, f64::max),
    };
    match own.kind {
        Kind::Line(line) => piece(Shape::Line, &|p| line.off(p)),
        Kind::Arc(round) => {
            let round = round.through(from, to);
            let mut ends = points.to_vec();
            (ends[0], ends[points.len() - 1]) = (from, to);
            let shape =
                Shape::Arc { centre: round.centre, radius: round.radius, sweep: sweep(&round, &ends) };
            piece(shape, &|p| round.off(p))
        }
        Kind::Free => {
            let mut ends = points.to_vec();
            (ends[0], ends[points.len() - 1]) = (from, to);
            match fit_within(&ends, tolerance) {
                Some((spline, worst)) => Piece { shape: Shape::Free(spline), from, to, worst },
                None => piece(Shape::Line, &|p| onto(from, to, p).1),
            }
        }
    }
}
