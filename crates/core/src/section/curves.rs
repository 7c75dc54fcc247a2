//! Contours as a draughtsman would draw them: lines, arcs, circles, ellipses and splines end to end.
//!
//! `data` takes the samples of the contour together and finds their error; `breaks` finds the pieces of least description length by dynamic
//! programming; `touch` makes neighbours tangent unless the data contradict, by `tangent`; `joined` lets the others cross; `bound` sees to
//! a tolerance that is given.

mod bound;
mod breaks;
mod data;
mod joined;
pub(crate) mod nest;
mod primitive;
mod tangent;
mod touch;

pub(crate) use data::Datum;

use crate::curve::circle::Circle;
use crate::curve::flat_ellipse::FlatEllipse;
use crate::curve::pieces::Noise;
use crate::curve::pieces::noise::{Kind, Span};
use crate::curve::{BSpline, Ellipse};
use crate::math::vec2::{distance, unit};
use crate::section::contour::chain::{Chain, Vertex};
use data::Blocks;
use primitive::Primitive;
use tangent::{Fitted, settled};

/// A piece of a contour in the slicing plane.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shape {
    /// Straight between its ends.
    Line,
    /// Circle about `centre`; `sweep` in radians, positive counter-clockwise.
    Arc { centre: [f64; 2], radius: f64, sweep: f64 },
    /// A whole circle.
    Circle { centre: [f64; 2], radius: f64 },
    /// An ellipse or part of one; `sweep` is the change of its parameter in radians, positive counter-clockwise.
    Ellipse { ellipse: FlatEllipse, sweep: f64 },
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

/// Fewest data that curves are fitted to: with fewer the vertices stand for them.
const FEWEST: usize = 8;
/// Description length that a circle may take beyond that of its pieces, nats.
const ROUND_COST: f64 = 2.0;
/// Fewest blocks of a circle.
const ROUND_BLOCKS: usize = 6;
/// Greatest distance of a curve from a vertex where no tolerance is given, spacings and errors.
const FREE_BOUND: (f64, f64) = (0.7, 4.0);
/// Times that a ring is begun anew.
const TURNS: usize = 4;
/// Greatest distance of a circle from a vertex where no tolerance is given, as a multiple of that of other curves.
const ASIDE: f64 = 2.0;
/// Share of a turn that the data of a circle must go round.
const ROUND: f64 = 0.9;

/// The pieces of a contour in order, given the data along it.
pub(crate) fn fit(chain: &Chain, data: &[Datum], tolerance: Option<f64>) -> Vec<Piece> {
    let vertices = &chain.vertices;
    if vertices.len() < 2 {
        return Vec::new();
    }
    let spacing = chain.spacing();
    let arcs = arcs(vertices);
    let data = if data.len() < FEWEST { of_vertices(vertices, &arcs) } else { data.to_vec() };
    let corners: Vec<f64> = vertices.iter().zip(&arcs).filter(|(v, _)| v.corner).map(|(_, &a)| a).collect();
    let blocks = Blocks::new(data, spacing, &corners);
    let mut noise = Noise::of_plane(blocks.error(spacing), blocks.data.len());
    let (mut blocks, mut spans) = searched(blocks, chain.closed, &noise, spacing, &corners);
    let found = breaks::error(&blocks, &spans);
    if found > noise.sigma {
        noise = Noise { sigma: found, ..noise };
        (blocks, spans) = searched(blocks, chain.closed, &noise, spacing, &corners);
    }
    let limit = tolerance.unwrap_or(FREE_BOUND.0 * spacing + FREE_BOUND.1 * noise.sigma);
    if chain.closed
        && let Some(piece) = whole(&blocks, &spans, &noise, vertices)
        // Where no tolerance is given, one vertex aside does not break a circle.
        && piece.worst <= tolerance.unwrap_or(ASIDE * limit)
    {
        return vec![piece];
    }
    if let ([Span { kind: Kind::Arc | Kind::Line, .. }], true) = (&spans[..], chain.closed) {
        return bound::ring(vertices, limit);
    }
    let ends = (!chain.closed).then(|| [vertices[0].at, vertices[vertices.len() - 1].at]);
    let pieces = joined::joined(&blocks, &spans, &noise, spacing, ends);
    bound::bound(pieces, &blocks, &spans, (vertices, &arcs), limit)
}

/// The pieces of the blocks, those of a ring begun anew.
fn searched(
    blocks: Blocks,
    closed: bool,
    noise: &Noise,
    spacing: f64,
    corners: &[f64],
) -> (Blocks, Vec<Span>) {
    if closed {
        return ring(blocks, noise, spacing, corners);
    }
    let spans = breaks::breaks(&blocks, noise, spacing, corners);
    (blocks, spans)
}

/// The blocks of a ring, begun at a break between two pieces, and the pieces.
fn ring(mut blocks: Blocks, noise: &Noise, spacing: f64, corners: &[f64]) -> (Blocks, Vec<Span>) {
    let mut spans = breaks::breaks(&blocks, noise, spacing, corners);
    // The first row was broken where it happened to begin.
    for turn in 0..TURNS {
        let last = spans.len() - 1;
        if last == 0 || turn > 0 && !breaks::one(&blocks, noise, &spans[last], &spans[0]) {
            break;
        }
        let start = blocks.starts.partition_point(|&s| s < spans[spans.len() / 2].first);
        blocks = blocks.turned(start % blocks.sums.len());
        spans = breaks::breaks(&blocks, noise, spacing, corners);
    }
    (blocks, spans)
}

/// A ring as one circle or ellipse, where that takes no more numbers than its pieces.
fn whole(blocks: &Blocks, spans: &[Span], noise: &Noise, vertices: &[Vertex]) -> Option<Piece> {
    let means: Vec<[f64; 2]> = blocks.sums.iter().chain(&blocks.sums[..1]).map(|s| s.mean()).collect();
    let round = circle(blocks, spans, noise, &means);
    let limit = round.map_or_else(|| breaks::costs(blocks, noise, spans), |r| r.1);
    let lifted: Vec<[f64; 3]> = means.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    let ellipse = breaks::oval(blocks, noise, 0, blocks.data.len(), limit);
    if let Some((ellipse, turned)) = ellipse.map(|(e, _)| (e, e.sweep(&lifted)))
        && turned.abs() > ROUND * std::f64::consts::TAU
    {
        let shape = Shape::of_ellipse(&ellipse, std::f64::consts::TAU.copysign(turned));
        let Shape::Ellipse { ellipse, .. } = shape else { return None };
        let off = |v: &Vertex| distance(ellipse.foot(v.at), v.at);
        let (at, worst) = (ellipse.foot(vertices[0].at), vertices.iter().map(off).fold(0.0, f64::max));
        return Some(Piece { shape, from: at, to: at, worst });
    }
    let circle = round?.0;
    let at = circle.foot(vertices[0].at);
    let worst = vertices.iter().map(|v| circle.off(v.at)).fold(0.0, f64::max);
    let shape = Shape::Circle { centre: circle.centre, radius: circle.radius };
    Some(Piece { shape, from: at, to: at, worst })
}

/// The circle that describes a ring, whose blocks have these means, in no more numbers than its pieces, and its description length.
fn circle(blocks: &Blocks, spans: &[Span], noise: &Noise, means: &[[f64; 2]]) -> Option<(Circle, f64)> {
    let points: Vec<[f64; 2]> = blocks.data.iter().map(|d| d.at).collect();
    let curve = Primitive::Arc { circle: Circle::fit(&points)?, left: true };
    let fitted = settled(Fitted { curve, data: &blocks.data }, noise.sigma);
    let Primitive::Arc { circle, .. } = fitted.curve else { return None };
    let turned = primitive::sweep(&circle, means).abs() / std::f64::consts::TAU;
    let own = noise.cost(noise.parameters(Kind::Arc), fitted.squares());
    let pieces = breaks::costs(blocks, noise, spans) + ROUND_COST;
    // One arc all the way round is the circle, whatever Taubin's squares say.
    let one = matches!(spans, [Span { kind: Kind::Arc, .. }]);
    let found = blocks.sums.len() >= ROUND_BLOCKS && turned > ROUND && (one || own <= pieces);
    found.then_some((circle, own))
}

impl Shape {
    /// An ellipse in the plane of the first two axes, gone along as its normal tells.
    fn of_ellipse(ellipse: &Ellipse, sweep: f64) -> Self {
        let [x, y, _] = ellipse.centre;
        let [u, v, _] = ellipse.major;
        let way = unit([u, v]);
        let flat = FlatEllipse { centre: [x, y], axes: [u.hypot(v), ellipse.minor], way };
        Shape::Ellipse { ellipse: flat, sweep: sweep * ellipse.normal[2].signum() }
    }
}

/// The length along the polyline to each vertex.
fn arcs(vertices: &[Vertex]) -> Vec<f64> {
    let mut arc = 0.0;
    let mut arcs = vec![0.0];
    for w in vertices.windows(2) {
        arc += distance(w[0].at, w[1].at);
        arcs.push(arc);
    }
    arcs
}

fn of_vertices(vertices: &[Vertex], arcs: &[f64]) -> Vec<Datum> {
    vertices.iter().zip(arcs).map(|(v, &arc)| Datum { at: v.at, weight: 1.0, arc }).collect()
}

#[cfg(test)]
mod tests;
