//! The edges of a part as lines and circles.

use lineament::curve::Round;
use lineament::curve::pieces::Piece;
use lineament::math::vec3::{add_scaled, cross, distance, dot, norm, scale, sub, unit};
use lineament::shapes::TruthCurve;

/// Distance within which a curve lies along an edge, and beyond which it does not reach past the end of it, spacings.
const NEAR: f64 = 1.0;
/// Share of its size by which points of a curve may leave a line or circle.
const ROUNDING: f64 = 1e-4;

/// An edge.
pub enum Edge {
    /// Between two points.
    Line([[f64; 3]; 2]),
    /// All of a circle, or part of one.
    Circle(Round),
}

/// The lines and circles among the curves of a part.
pub fn edges(curves: &[TruthCurve]) -> Vec<Edge> {
    curves.iter().filter_map(|c| edge(&c.points)).collect()
}

fn edge(points: &[[f64; 3]]) -> Option<Edge> {
    let (from, to) = (*points.first()?, *points.last()?);
    let along = unit(sub(to, from));
    let size = distance(from, to);
    let off = |p: &[f64; 3]| norm(cross(sub(*p, from), along));
    if points.iter().all(|p| off(p) <= ROUNDING * size) {
        return Some(Edge::Line([from, to]));
    }
    let n = points.len();
    let [a, b, c] = [0, n / 3, 2 * n / 3].map(|k| points[k]);
    let (u, v) = (sub(b, a), sub(c, a));
    let normal = cross(u, v);
    let square = dot(normal, normal);
    let towards = add_scaled(scale(cross(normal, u), dot(v, v)), cross(v, normal), dot(u, u));
    let centre = add_scaled(a, towards, 0.5 / square);
    let round = Round { centre, normal: unit(normal), radius: distance(centre, a) };
    let off = |p: &[f64; 3]| {
        let d = sub(*p, centre);
        (norm(d) - round.radius).abs().max(dot(d, round.normal).abs())
    };
    points.iter().all(|p| off(p) <= ROUNDING * round.radius).then_some(Edge::Circle(round))
}

/// A point and the direction of the edge that a line lies along.
pub fn line(piece: &Piece, known: &[Edge], spacing: f64) -> Option<([f64; 3], [f64; 3])> {
    let near = NEAR * spacing;
    let along = |edge: &Edge| {
        let Edge::Line([from, to]) = *edge else { return None };
        let way = unit(sub(to, from));
        let aside = |p| norm(cross(sub(p, from), way));
        let past = |p| (-dot(sub(p, from), way)).max(dot(sub(p, to), way));
        let worst = [piece.from, piece.to].map(|p| aside(p).max(past(p))).into_iter().fold(0.0, f64::max);
        let way = if dot(way, sub(piece.to, piece.from)) < 0.0 { scale(way, -1.0) } else { way };
        (worst <= near).then_some((worst, (from, way)))
    };
    known.iter().filter_map(along).min_by(|a, b| a.0.total_cmp(&b.0)).map(|f| f.1)
}

/// The circle that another lies along, its normal to the same side.
pub fn circle(round: &Round, known: &[Edge], spacing: f64) -> Option<Round> {
    let near = NEAR * spacing;
    let along = |edge: &Edge| {
        let Edge::Circle(known) = *edge else { return None };
        let side = dot(known.normal, round.normal);
        let apart = distance(known.centre, round.centre).max((known.radius - round.radius).abs());
        let same = Round { normal: scale(known.normal, side.signum()), ..known };
        (apart <= near && side.abs() > 0.9).then_some((apart, same))
    };
    known.iter().filter_map(along).min_by(|a, b| a.0.total_cmp(&b.0)).map(|f| f.1)
}
