//! Contours as lines, arcs, circles and splines within a tolerance, corners kept.
//!
//! Each stretch between corners is cut greedily: from where the last piece ended, the longest line or arc that stays
//! within the tolerance of every vertex; what neither describes is left to splines.

use super::chain::Vertex;
use super::primitive::{Line, Round};
use super::spline::{self, Spline};
use super::vec2::{along, cross, distance, dot, meet, sub};

/// A piece of a contour in the slicing plane.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shape {
    /// Straight between its ends.
    Line,
    /// Round about `centre`; `sweep` in radians, positive counter-clockwise.
    Arc { centre: [f64; 2], radius: f64, sweep: f64 },
    /// A whole circle.
    Circle { centre: [f64; 2], radius: f64 },
    /// Anything else.
    Free(Spline),
}

/// A fitted piece.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Piece {
    /// What it is.
    pub shape: Shape,
    /// Where it begins; the next piece begins where it ends.
    pub from: [f64; 2],
    /// Where it ends.
    pub to: [f64; 2],
    /// Greatest distance from a vertex.
    pub worst: f64,
}

/// Fewest vertices that speak for an arc: three always lie on one.
const ARC_VERTICES: usize = 6;
/// Fewest vertices of a line inside a stretch.
const LINE_VERTICES: usize = 4;

/// A run of vertices under one description, `first..=last`.
#[derive(Clone, Copy, Debug)]
struct Run {
    first: usize,
    last: usize,
    kind: Kind,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Line(Line),
    Arc(Round),
    Free,
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
    let mut runs = Vec::new();
    for w in corners.windows(2) {
        stretch(&points, w[0], w[1], tolerance, &mut runs);
    }
    pieces(&points, &runs, closed, tolerance)
}

fn whole_circle(points: &[[f64; 2]], closed: bool, tolerance: f64) -> Option<Piece> {
    if !closed || points.len() < ARC_VERTICES {
        return None;
    }
    let round = Round::fit(points)?;
    let worst = points.iter().map(|&p| round.off(p)).fold(0.0, f64::max);
    let shape = Shape::Circle { centre: round.centre, radius: round.radius };
    // Twice the tolerance: one vertex aside should not break a circle into arcs.
    let mean = points.iter().map(|&p| round.off(p)).sum::<f64>() / points.len() as f64;
    let fits = worst <= 2.0 * tolerance && mean <= 0.7 * tolerance && worst < 0.3 * round.radius;
    let at = round.foot(points[0]);
    fits.then_some(Piece { shape, from: at, to: at, worst })
}

/// A contour as an open run of points with the places of its corners, both ends included. A closed one begins, and
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

fn stretch(points: &[[f64; 2]], first: usize, last: usize, tolerance: f64, runs: &mut Vec<Run>) {
    let mut at = first;
    let mut free: Option<usize> = None;
    while at < last {
        let run = longest(points, at, last, tolerance);
        let enough = match run.kind {
            Kind::Line(_) => run.last - at + 1 >= LINE_VERTICES || (at == first && run.last == last),
            _ => run.last - at + 1 >= ARC_VERTICES,
        };
        if !enough {
            free.get_or_insert(at);
            at += 1;
            continue;
        }
        if let Some(start) = free.take() {
            runs.push(Run { first: start, last: at, kind: Kind::Free });
        }
        runs.push(run);
        at = run.last;
    }
    if let Some(start) = free {
        runs.push(Run { first: start, last, kind: Kind::Free });
    }
}

/// The longest line or arc from `first`; an arc must go a quarter farther than the line to be preferred.
fn longest(points: &[[f64; 2]], first: usize, last: usize, tolerance: f64) -> Run {
    let line = reach(first, last, 2, |end| {
        Line::fit(&points[first..=end]).filter(|l| line_fits(l, &points[first..=end], tolerance))
    });
    let arc = reach(first, last, ARC_VERTICES - 1, |end| {
        Round::fit(&points[first..=end]).filter(|r| arc_fits(r, &points[first..=end], tolerance))
    });
    match (line, arc) {
        (Some((l, line)), Some((a, _))) if 5 * (l - first) >= 4 * (a - first) => {
            Run { first, last: l, kind: Kind::Line(line) }
        }
        (_, Some((a, round))) => Run { first, last: a, kind: Kind::Arc(round) },
        (Some((l, line)), None) => Run { first, last: l, kind: Kind::Line(line) },
        (None, None) => match Line::fit(&points[first..=first + 1]) {
            Some(line) => Run { first, last: first + 1, kind: Kind::Line(line) },
            None => Run { first, last: first + 1, kind: Kind::Free },
        },
    }
}

/// The last vertex a fit reaches: doubling steps, then halving.
fn reach<T>(first: usize, last: usize, least: usize, fit: impl Fn(usize) -> Option<T>) -> Option<(usize, T)> {
    let mut good = None;
    let mut step = least;
    let mut bad = last + 1;
    while first + step < bad {
        match fit(first + step) {
            Some(found) => good = Some((first + step, found)),
            None => bad = first + step,
        }
        let next = (2 * step).min(last - first);
        if good.is_none() || next == step {
            break;
        }
        step = next;
    }
    let (mut low, mut found) = good?;
    while bad - low > 1 {
        let middle = low + (bad - low) / 2;
        match fit(middle) {
            Some(better) => (low, found) = (middle, better),
            None => bad = middle,
        }
    }
    Some((low, found))
}

fn line_fits(line: &Line, points: &[[f64; 2]], tolerance: f64) -> bool {
    points.iter().all(|&p| line.off(p) <= tolerance)
}

/// An arc must bend by more than the tolerance, run one way round and less than once.
fn arc_fits(round: &Round, points: &[[f64; 2]], tolerance: f64) -> bool {
    let swept = sweep(round, points);
    let bend = round.radius * (1.0 - (0.5 * swept.abs().min(std::f64::consts::PI)).cos());
    bend > tolerance && swept.abs() < 6.2 && points.iter().all(|&p| round.off(p) <= tolerance)
}

/// The signed angle a run of points goes about a centre.
fn sweep(round: &Round, points: &[[f64; 2]]) -> f64 {
    let turn = |w: &[[f64; 2]]| {
        let (a, b) = (sub(w[0], round.centre), sub(w[1], round.centre));
        cross(a, b).atan2(dot(a, b))
    };
    points.windows(2).map(turn).sum()
}

fn pieces(points: &[[f64; 2]], runs: &[Run], closed: bool, tolerance: f64) -> Vec<Piece> {
    let n = runs.len();
    let inner = |k: usize| joint(points, &runs[k], &runs[(k + 1) % n], tolerance);
    let mut joints: Vec<[f64; 2]> = Vec::with_capacity(n + 1);
    let closing = (closed && n > 1).then(|| inner(n - 1));
    joints.push(closing.unwrap_or(points[0]));
    (0..n.saturating_sub(1)).for_each(|k| joints.push(inner(k)));
    joints.push(closing.unwrap_or(points[points.len() - 1]));
    let piece = |(k, run): (usize, &Run)| shape(points, run, joints[k], joints[k + 1], tolerance);
    runs.iter().enumerate().map(piece).collect()
}

/// Where two runs meet: where their lines cross, if that is near the vertex they share, else between its feet.
fn joint(points: &[[f64; 2]], a: &Run, b: &Run, tolerance: f64) -> [f64; 2] {
    let vertex = points[a.last];
    if let (Kind::Line(l), Kind::Line(m)) = (a.kind, b.kind) {
        let crossing = meet(l.at, l.direction, m.at, m.direction).map(|(s, _)| along(l.at, l.direction, s));
        if let Some(at) = crossing.filter(|&at| distance(at, vertex) <= 3.0 * tolerance) {
            return at;
        }
    }
    let foot = |run: &Run| match run.kind {
        Kind::Line(line) => line.foot(vertex),
        Kind::Arc(round) => round.foot(vertex),
        Kind::Free => vertex,
    };
    let (p, q) = (foot(a), foot(b));
    along(p, sub(q, p), 0.5)
}

fn shape(points: &[[f64; 2]], run: &Run, from: [f64; 2], to: [f64; 2], tolerance: f64) -> Piece {
    let own = &points[run.first..=run.last];
    let piece = |shape, off: &dyn Fn([f64; 2]) -> f64| Piece {
        shape,
        from,
        to,
        worst: own.iter().map(|&p| off(p)).fold(0.0, f64::max),
    };
    match run.kind {
        Kind::Line(line) => piece(Shape::Line, &|p| line.off(p)),
        Kind::Arc(round) => {
            let round = round.through(from, to);
            let mut ends = own.to_vec();
            (ends[0], ends[own.len() - 1]) = (from, to);
            let shape =
                Shape::Arc { centre: round.centre, radius: round.radius, sweep: sweep(&round, &ends) };
            piece(shape, &|p| round.off(p))
        }
        Kind::Free => {
            let mut ends = own.to_vec();
            (ends[0], ends[own.len() - 1]) = (from, to);
            match spline::fit(&ends, tolerance) {
                Some((spline, worst)) => Piece { shape: Shape::Free(spline), from, to, worst },
                None => piece(Shape::Line, &|p| super::vec2::onto(from, to, p).1),
            }
        }
    }
}
