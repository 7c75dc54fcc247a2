//! A line or circle with a direction of travel, as a contour runs along it.

use super::data::Datum;
use crate::curve::circle::Circle;
use crate::curve::line::Line;
use crate::math::vec2::{along, cross, distance, dot, left, sub, unit};

/// Fewest data that are left when those beside the breaks, or far off, are not counted.
const FEWEST: usize = 6;
/// Distance from a curve, in errors, from which on a datum is not counted.
const FAR: f64 = 4.0;
/// Rounds in which data far off are left out.
const ROUNDS: usize = 2;

/// An endless curve in the plane.
#[derive(Clone, Copy, Debug)]
pub(super) enum Primitive {
    /// In its direction of travel.
    Line(Line),
    /// Counter-clockwise if `left`.
    Arc { circle: Circle, left: bool },
    /// Neither.
    Free,
}

impl Primitive {
    /// The line of least squares through data, in their order.
    pub(super) fn line(data: &[Datum]) -> Self {
        robust(data, |points| Some(Primitive::Line(Line::fit(points)?))).unwrap_or(Primitive::Free)
    }

    /// The circle of least squares, in their order.
    pub(super) fn arc(data: &[Datum]) -> Self {
        let fit = |points: &[[f64; 2]]| {
            let circle = Circle::fit(points)?;
            Some(Primitive::Arc { circle, left: sweep(&circle, points) > 0.0 })
        };
        robust(data, fit).unwrap_or(Primitive::Free)
    }

    /// The point nearest to `p`.
    pub(super) fn foot(&self, p: [f64; 2]) -> [f64; 2] {
        match self {
            Primitive::Line(line) => line.foot(p),
            Primitive::Arc { circle, .. } => circle.foot(p),
            Primitive::Free => p,
        }
    }

    /// Distance of a point; 0 if there is no curve.
    pub(super) fn off(&self, p: [f64; 2]) -> f64 {
        match self {
            Primitive::Line(line) => line.off(p),
            Primitive::Arc { circle, .. } => circle.off(p),
            Primitive::Free => 0.0,
        }
    }

    /// The direction of travel at the point nearest to `p`.
    pub(super) fn way(&self, p: [f64; 2]) -> [f64; 2] {
        match self {
            Primitive::Line(line) => line.direction,
            Primitive::Arc { circle, left: turns_left } => {
                let way = left(unit(sub(p, circle.centre)));
                if *turns_left { way } else { way.map(|x| -x) }
            }
            Primitive::Free => [0.0; 2],
        }
    }

    /// Where two of them meet nearest to `p`; `None` where they do not.
    pub(super) fn meet(&self, other: &Primitive, p: [f64; 2]) -> Option<[f64; 2]> {
        let found = match (self, other) {
            (Primitive::Line(a), Primitive::Line(b)) => {
                let (s, _) = crate::math::vec2::meet(a.at, a.direction, b.at, b.direction)?;
                [along(a.at, a.direction, s); 2]
            }
            (Primitive::Line(line), Primitive::Arc { circle, .. })
            | (Primitive::Arc { circle, .. }, Primitive::Line(line)) => line_circle(line, circle)?,
            (Primitive::Arc { circle: a, .. }, Primitive::Arc { circle: b, .. }) => circles(a, b)?,
            _ => return None,
        };
        let [a, b] = found;
        Some(if distance(a, p) <= distance(b, p) { a } else { b })
    }
}

/// A fit in which data far from it do not count.
fn robust(data: &[Datum], fit: impl Fn(&[[f64; 2]]) -> Option<Primitive>) -> Option<Primitive> {
    let mut points: Vec<[f64; 2]> = data.iter().map(|d| d.at).collect();
    let mut found = fit(&points)?;
    for _ in 0..ROUNDS {
        let squares: f64 = points.iter().map(|&p| found.off(p).powi(2)).sum();
        let far = FAR * (squares / points.len() as f64).sqrt();
        let kept: Vec<[f64; 2]> = points.iter().copied().filter(|&p| found.off(p) <= far).collect();
        if kept.len() == points.len() || kept.len() < FEWEST {
            break;
        }
        points = kept;
        found = fit(&points)?;
    }
    Some(found)
}

fn line_circle(line: &Line, circle: &Circle) -> Option<[[f64; 2]; 2]> {
    let foot = line.foot(circle.centre);
    let square = circle.radius * circle.radius - dot(sub(foot, circle.centre), sub(foot, circle.centre));
    (square >= 0.0).then(|| [1.0, -1.0].map(|s| along(foot, line.direction, s * square.sqrt())))
}

fn circles(a: &Circle, b: &Circle) -> Option<[[f64; 2]; 2]> {
    let between = sub(b.centre, a.centre);
    let apart = dot(between, between).sqrt();
    // The chord through both points lies this far from the first centre.
    let ahead = 0.5 * (apart + (a.radius - b.radius) * (a.radius + b.radius) / apart);
    let square = a.radius * a.radius - ahead * ahead;
    let way = unit(between);
    let foot = along(a.centre, way, ahead);
    (apart > 0.0 && square >= 0.0).then(|| [1.0, -1.0].map(|s| along(foot, left(way), s * square.sqrt())))
}

/// The signed angle a row of points goes about a circle's centre.
pub(super) fn sweep(circle: &Circle, points: &[[f64; 2]]) -> f64 {
    let turn = |w: &[[f64; 2]]| {
        let (a, b) = (sub(w[0], circle.centre), sub(w[1], circle.centre));
        cross(a, b).atan2(dot(a, b))
    };
    points.windows(2).map(turn).sum()
}
