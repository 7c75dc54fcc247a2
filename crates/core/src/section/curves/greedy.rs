//! A part of a contour between corners cut into stretches, greedily: from where the last one ended, the longest line or arc that stays
//! within the tolerance of every vertex; the rest is left free.

use crate::curve::circle::Circle;
use crate::curve::line::Line;
use crate::math::vec2::{cross, dot, sub};

/// Fewest vertices that speak for an arc: three always lie on one.
pub(crate) const ARC_VERTICES: usize = 6;
/// Fewest vertices of a line within a part.
const LINE_VERTICES: usize = 4;

/// A stretch of vertices under one description, `first..=last`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch {
    pub first: usize,
    pub last: usize,
    pub kind: Kind,
}

/// The description of a stretch.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kind {
    Line(Line),
    Arc(Circle),
    Free,
}

/// Cuts the vertices from `first` to `last` into stretches end to end.
pub(crate) fn cut(
    points: &[[f64; 2]],
    first: usize,
    last: usize,
    tolerance: f64,
    stretches: &mut Vec<Stretch>,
) {
    let mut at = first;
    let mut free: Option<usize> = None;
    while at < last {
        let own = longest(points, at, last, tolerance);
        let enough = match own.kind {
            Kind::Line(_) => own.last - at + 1 >= LINE_VERTICES || (at == first && own.last == last),
            _ => own.last - at + 1 >= ARC_VERTICES,
        };
        if !enough {
            free.get_or_insert(at);
            at += 1;
            continue;
        }
        if let Some(start) = free.take() {
            stretches.push(Stretch { first: start, last: at, kind: Kind::Free });
        }
        stretches.push(own);
        at = own.last;
    }
    if let Some(start) = free {
        stretches.push(Stretch { first: start, last, kind: Kind::Free });
    }
}

/// The longest line or arc from `first`; an arc must go a quarter farther than the line to be preferred.
pub(crate) fn longest(points: &[[f64; 2]], first: usize, last: usize, tolerance: f64) -> Stretch {
    let line = reach(first, last, 2, |end| {
        Line::fit(&points[first..=end]).filter(|l| line_fits(l, &points[first..=end], tolerance))
    });
    let arc = reach(first, last, ARC_VERTICES - 1, |end| {
        Circle::fit(&points[first..=end]).filter(|r| arc_fits(r, &points[first..=end], tolerance))
    });
    match (line, arc) {
        (Some((l, line)), Some((a, _))) if 5 * (l - first) >= 4 * (a - first) => {
            Stretch { first, last: l, kind: Kind::Line(line) }
        }
        (_, Some((a, round))) => Stretch { first, last: a, kind: Kind::Arc(round) },
        (Some((l, line)), None) => Stretch { first, last: l, kind: Kind::Line(line) },
        (None, None) => match Line::fit(&points[first..=first + 1]) {
            Some(line) => Stretch { first, last: first + 1, kind: Kind::Line(line) },
            None => Stretch { first, last: first + 1, kind: Kind::Free },
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
fn arc_fits(round: &Circle, points: &[[f64; 2]], tolerance: f64) -> bool {
    let swept = sweep(round, points);
    let bend = round.radius * (1.0 - (0.5 * swept.abs().min(std::f64::consts::PI)).cos());
    bend > tolerance && swept.abs() < 6.2 && points.iter().all(|&p| round.off(p) <= tolerance)
}

/// The signed angle a row of points goes about a centre.
pub(crate) fn sweep(round: &Circle, points: &[[f64; 2]]) -> f64 {
    let turn = |w: &[[f64; 2]]| {
        let (a, b) = (sub(w[0], round.centre), sub(w[1], round.centre));
        cross(a, b).atan2(dot(a, b))
    };
    points.windows(2).map(turn).sum()
}
