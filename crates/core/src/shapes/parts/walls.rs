//! Upright walls over outlines in the plane, without floor or lid.

use crate::math::vec3::norm;
use crate::shapes::face::{Face, Trim};
use crate::shapes::outline::{Edge, Outline};
use crate::shapes::shape::Shape;
use crate::shapes::surface::{Axes, FaceSurface};
use crate::shapes::truth::{CIRCLE, Fold, Truth, TruthCurve, fold_between};
use crate::shapes::turns::sin_cos;

/// Least turn between two edges that is a corner, degrees.
const CORNER_DEG: f64 = 1e-6;

/// The walls from z = 0 to `height` over outlines, the solid to the left of each. They end in borders at their foot and rim, and at
/// the ends of outlines that are open; where an outline has a corner there is a crease.
pub fn walls(name: &'static str, outlines: &[Outline], height: f64) -> Shape {
    let (mut nodes, mut curves) = (Vec::new(), Vec::new());
    for outline in outlines.iter().filter(|o| !o.is_empty()) {
        let first = nodes.len() as u32;
        let closed = distance(outline[0].at(0.0), outline[outline.len() - 1].at(1.0)) < 1e-9;
        let stretches = stretches(outline, closed);
        if let [whole] = stretches[..]
            && closed
        {
            for z in [0.0, height] {
                let points = path(outline, whole, z);
                curves.push(TruthCurve::border(points[1..points.len() - 1].to_vec(), None));
            }
            continue;
        }
        // Each corner, or end, is an edge between two nodes.
        let count = stretches.len() as u32 + u32::from(!closed);
        let node = |k: u32, side: u32| first + 2 * (k % count) + side;
        for (k, &stretch) in (0..).zip(&stretches) {
            for (side, z) in [(0, 0.0), (1, height)] {
                let ends = [node(k, side), node(k + 1, side)];
                curves.push(TruthCurve::border(path(outline, stretch, z), Some(ends)));
            }
            curves.push(upright(outline, stretch.0, closed || k > 0, height, [node(k, 0), node(k, 1)]));
            nodes.extend([0.0, height].map(|z| lift(outline[stretch.0].at(0.0), z)));
        }
        if !closed {
            let last = lift(outline[outline.len() - 1].at(1.0), 0.0);
            let ends = [last, [last[0], last[1], height]];
            nodes.extend(ends);
            let k = stretches.len() as u32;
            curves.push(TruthCurve::border(ends.to_vec(), Some([node(k, 0), node(k, 1)])));
        }
    }
    let faces = outlines.iter().flatten().map(|edge| wall(edge, height)).collect();
    Shape { name, faces, network: Truth::with_nodes(&nodes, curves) }
}

/// The first edge and the number of edges of each stretch without a corner; one in all for an outline without any.
fn stretches(outline: &Outline, closed: bool) -> Vec<(usize, usize)> {
    let n = outline.len();
    let turns = |k: &usize| turn_deg(&outline[(k + n - 1) % n], &outline[*k]) > CORNER_DEG;
    let mut starts: Vec<usize> = (0..n).filter(|k| (*k > 0 || closed) && turns(k)).collect();
    if !closed {
        starts.insert(0, 0);
    }
    if starts.is_empty() {
        return vec![(0, n)];
    }
    let next = |i: usize| starts.get(i + 1).copied().unwrap_or(if closed { starts[0] + n } else { n });
    starts.iter().enumerate().map(|(i, &start)| (start, next(i) - start)).collect()
}

/// The edge over the beginning of a stretch: a crease, or the border where an open outline begins.
fn upright(outline: &Outline, start: usize, corner: bool, height: f64, ends: [u32; 2]) -> TruthCurve {
    let at = outline[start].at(0.0);
    let points = vec![lift(at, 0.0), lift(at, height)];
    if !corner {
        return TruthCurve::border(points, Some(ends));
    }
    let n = outline.len();
    let (before, after) = (&outline[(start + n - 1) % n], &outline[start]);
    let (a, b) = (before.way(1.0), after.way(0.0));
    let fold = if a[0] * b[1] - a[1] * b[0] > 0.0 { Fold::Convex } else { Fold::Concave };
    TruthCurve::crease(points, turn_deg(before, after), fold, Some(ends))
}

fn turn_deg(before: &Edge, after: &Edge) -> f64 {
    fold_between(lift(before.way(1.0), 0.0), lift(after.way(0.0), 0.0))
}

/// The points of a stretch at one height; arcs have as many as circles have in proportion. Where edges join smoothly there is none, as
/// two faces would hold it.
fn path(outline: &Outline, (start, count): (usize, usize), z: f64) -> Vec<[f64; 3]> {
    let edges: Vec<&Edge> = outline.iter().cycle().skip(start).take(count).collect();
    let mut points = vec![edges[0].at(0.0)];
    for edge in &edges {
        if let Edge::Arc { sweep, .. } = edge {
            let steps = (sweep.abs() * f64::from(CIRCLE)).ceil().max(1.0) as u32;
            points.extend((0..steps).map(|i| edge.at((f64::from(i) + 0.5) / f64::from(steps))));
        }
    }
    points.push(edges[count - 1].at(1.0));
    points.into_iter().map(|p| lift(p, z)).collect()
}

/// The face over an edge, its normal to the right of the way along it.
fn wall(edge: &Edge, height: f64) -> Face {
    match *edge {
        Edge::Line([a, b]) => {
            let way = edge.way(0.0);
            let axes = Axes {
                origin: lift(a, 0.0),
                x: lift(way, 0.0),
                y: [0.0, 0.0, 1.0],
                z: [way[1], -way[0], 0.0],
            };
            Face::new(FaceSurface::Plane { axes, low: [0.0; 2], high: [distance(a, b), height] })
        }
        Edge::Arc { centre, radius, from, sweep } => {
            // Upwards the normal points away from the axis.
            let (low, high) = if sweep > 0.0 { (0.0, height) } else { (height, 0.0) };
            let surface = FaceSurface::Cone {
                axes: Axes::at(lift(centre, 0.0)),
                from: [radius, low],
                to: [radius, high],
            };
            let mut face = Face::new(surface);
            if sweep.abs() < 1.0 {
                face.trims.push(Trim::Polygon(sector(radius, from, sweep)));
            }
            face
        }
    }
}

/// A polygon about the origin that holds the arc of a radius and nothing else of its circle.
fn sector(radius: f64, from: f64, sweep: f64) -> Vec<[f64; 2]> {
    let steps = (8.0 * sweep.abs()).ceil().max(1.0) as u32;
    // Its outer corners lie so far out that the sides between them keep clear of the circle.
    let corner = |i: u32| sin_cos(from + sweep * f64::from(i) / f64::from(steps)).map(|x| 2.0 * radius * x);
    std::iter::once([0.0; 2]).chain((0..=steps).map(corner)).collect()
}

fn lift(p: [f64; 2], z: f64) -> [f64; 3] {
    [p[0], p[1], z]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    norm([b[0] - a[0], b[1] - a[1], 0.0])
}
