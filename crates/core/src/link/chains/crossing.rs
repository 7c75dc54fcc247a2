//! Where the end of a chain meets another chain: their lines cross in a face that both bound.

use super::graph::{Graph, Straight};
use crate::math::vec3::{add, add_scaled, cross, distance, dot, norm, scale, sub, unit};
use crate::measure::Edgelet;
use crate::neighbors::Index;

/// How far an end is led on, and how far back it may be cut, in spacings.
const LED: (f64, f64) = (6.0, 2.5);
/// Greatest distance of the lines of two chains where they cross, in spacings.
const APART: f64 = 0.9;
/// Greatest distance by which a chain that is curved leaves its line up to the crossing, in spacings.
const BENT: f64 = 0.25;
/// Least sine of the angle between two chains that cross.
pub(super) const CROSSING: f64 = 0.35;
/// Least cosine between the normals of one face.
const SAME_FACE: f64 = 0.9;
/// Least cosine between the normals of both faces of a crease before and after a gap in it, also where it is curved.
const CONTINUED: f64 = 0.7;
/// Vertices of a chain from its end on with which the end cannot meet.
const OWN: usize = 12;
/// Cost of a distance between the lines, and of one along the other chain, beside one along the chain.
const COST: (f64, f64) = (2.0, 0.1);

/// The crossing of a loose end with another chain.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub(super) end: u32,
    /// A vertex of the other chain.
    pub(super) other: u32,
    pub(super) place: [f64; 3],
    cost: f64,
}

/// The best crossing of each loose end that has any.
pub(super) fn crossings(graph: &Graph) -> Vec<Crossing> {
    let index = Index::build(&graph.lines.positions);
    let mut near = Vec::new();
    let mut best = |end: u32| {
        let reach = (LED.0 + 2.0) * graph.spacing(end);
        near.clear();
        index.around(graph.place(end), reach, |f| near.push(f.index));
        near.sort_unstable();
        let own = graph.walk(end, graph.beside(end)[0], OWN);
        let line = graph.straight(end);
        let others = near.iter().filter(|o| !own.contains(o) && !graph.beside(**o).is_empty());
        others
            .filter_map(|&other| crossing(graph, end, line, other))
            .min_by(|a, b| a.cost.total_cmp(&b.cost).then(a.other.cmp(&b.other)))
    };
    graph.vertices().filter(|&v| graph.is_loose(v)).filter_map(&mut best).collect()
}

/// The crossing of the line of an end with the chain at vertex `other`.
fn crossing(graph: &Graph, end: u32, own: Straight, other: u32) -> Option<Crossing> {
    let h = graph.spacing(end);
    let line = graph.straight(other);
    let [p, q] = nearest(own, line)?;
    let ahead = dot(sub(p, graph.place(end)), own.along);
    let beyond = sub(q, graph.place(other));
    let outside = if graph.is_loose(other) { dot(beyond, line.along).max(0.0) } else { 0.0 };
    let reached =
        if outside > 0.0 { outside <= LED.0 * h } else { norm(beyond) <= h.max(graph.spacing(other)) };
    let apart = distance(p, q);
    let off = |line: Straight, led: f64| 0.5 * line.bend * led.max(0.0).powi(2);
    let straight = off(own, ahead).max(off(line, outside)) <= BENT * h;
    let near = straight && (-LED.1 * h..=LED.0 * h).contains(&ahead) && apart <= APART * h && reached;
    if !near || !turns(&graph.edgelets[end as usize], &graph.edgelets[other as usize]) {
        return None;
    }
    let cost = ahead.abs() + outside + COST.0 * apart + COST.1 * norm(beyond);
    Some(Crossing { end, other, place: scale(add(p, q), 0.5), cost })
}

/// The nearest points of two lines; `None` where they are nearly parallel.
fn nearest(a: Straight, b: Straight) -> Option<[[f64; 3]; 2]> {
    let normal = cross(a.along, b.along);
    let sine2 = dot(normal, normal);
    let gap = sub(b.place, a.place);
    let along = |direction: [f64; 3]| dot(cross(gap, direction), normal) / sine2;
    let points =
        || [add_scaled(a.place, a.along, along(b.along)), add_scaled(b.place, b.along, along(a.along))];
    (sine2 >= CROSSING * CROSSING).then(points)
}

/// The unit normals, of either sign, of the faces on both sides of an edgelet.
pub(super) fn normals(e: &Edgelet) -> [[f64; 3]; 2] {
    e.arms.map(|arm| unit(cross(e.along, arm)))
}

/// Whether two unit normals of either sign are those of one face.
pub(super) fn same_face(a: [f64; 3], b: [f64; 3]) -> bool {
    dot(a, b).abs() >= SAME_FACE
}

/// Whether two chains bound one face together but not two: those of one crease do, on both sides of a gap.
fn turns(a: &Edgelet, b: &Edgelet) -> bool {
    let (of_a, of_b) = (normals(a), normals(b));
    let shared = of_a.iter().any(|&n| of_b.iter().any(|&m| same_face(n, m)));
    let like = |n: usize, m: usize| dot(of_a[n], of_b[m]).abs() >= CONTINUED;
    shared && !(like(0, 0) && like(1, 1) || like(0, 1) && like(1, 0))
}
