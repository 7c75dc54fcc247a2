//! Chains led on to the corners where they meet.
//!
//! Near a corner a cross-section holds points of a third face, so that chains end one or two spacings before it. The corner lies
//! where the line of one crosses the line of another in a face that both bound. Two corners near each other on the same two faces are the
//! ends of an edge that is too short for cross-sections: the end of a narrow face.

use super::crossing::{CROSSING, Crossing, crossings, normals, same_face};
use super::graph::Graph;
use crate::math::union_find::UnionFind;
use crate::math::vec3::{add_scaled, cross, distance, dot, norm, sub};
use crate::measure::Edgelet;
use crate::neighbors::Index;

/// Distance within which corners are one, in spacings.
const ONE_CORNER: f64 = 0.9;
/// Distance before a corner up to which a chain stays, in spacings.
const BEFORE: f64 = 0.3;
/// Greatest length of an edge between two corners, in spacings, and greatest distance of its ends from each of its faces.
const SHORT_EDGE: (f64, f64) = (5.0, 0.4);
/// Vertices between two corners that a chain joins.
const JOINED: usize = 12;

/// A vertex where chains meet, and the normals of the faces there.
struct Corner {
    vertex: u32,
    normals: Vec<[f64; 3]>,
}

/// Leads loose ends on to corners, gives chains that pass there a node, and joins corners that share two faces.
pub(super) fn meet(graph: &mut Graph) {
    let crossings = crossings(graph);
    let groups = groups(graph, &crossings);
    let normals: Vec<Vec<[f64; 3]>> = groups.iter().map(|group| faces(graph, group)).collect();
    let vertices: Vec<u32> = groups.iter().map(|group| lead(graph, group)).collect();
    let corners = vertices.into_iter().zip(normals).map(|(vertex, normals)| Corner { vertex, normals });
    join(graph, &corners.collect::<Vec<_>>());
}

/// The crossings of each corner.
fn groups(graph: &Graph, crossings: &[Crossing]) -> Vec<Vec<Crossing>> {
    let places: Vec<[f64; 3]> = crossings.iter().map(|c| c.place).collect();
    let index = Index::build(&places);
    let mut sets = UnionFind::new(crossings.len());
    for (c, i) in crossings.iter().zip(0..) {
        index.around(c.place, ONE_CORNER * graph.spacing(c.end), |f| {
            sets.union(i, f.index);
        });
    }
    let mut members: Vec<(u32, usize)> = (0..crossings.len()).map(|i| (sets.find(i as u32), i)).collect();
    members.sort_unstable();
    members.chunk_by(|a, b| a.0 == b.0).map(|g| g.iter().map(|m| crossings[m.1]).collect()).collect()
}

/// The normals of the faces at a corner.
fn faces(graph: &Graph, group: &[Crossing]) -> Vec<[f64; 3]> {
    let mut faces: Vec<[f64; 3]> = Vec::new();
    let vertices = group.iter().flat_map(|c| [c.end, c.other]);
    for n in vertices.flat_map(|v| normals(&graph.edgelets[v as usize])) {
        if !faces.iter().any(|&f| same_face(f, n)) {
            faces.push(n);
        }
    }
    faces
}

/// Leads the chains of a corner on to it; returns its vertex.
fn lead(graph: &mut Graph, group: &[Crossing]) -> u32 {
    let share = 1.0 / group.len() as f64;
    let place = group.iter().fold([0.0; 3], |sum, c| add_scaled(sum, c.place, share));
    let model = graph.edgelets[group[0].end as usize];
    let node = graph.push(&Edgelet { place, ..model });
    graph.lines.corner[node as usize] = 0.0;
    graph.lines.nodes.push(node);
    group.iter().for_each(|c| end_at(graph, c.end, node));
    let passing = group.iter().map(|c| c.other).filter(|o| group.iter().all(|c| c.end != *o));
    passing.for_each(|v| pass(graph, v, node));
    node
}

/// Ends a chain at a node; what leads beyond it is cut off.
fn end_at(graph: &mut Graph, end: u32, node: u32) {
    let place = graph.place(node);
    let mut at = end;
    while let [next] = *graph.beside(at) {
        let inwards = sub(graph.place(next), graph.place(at));
        let before = dot(sub(graph.place(at), place), inwards) / norm(inwards).max(f64::MIN_POSITIVE);
        if before > BEFORE * graph.spacing(at) || next == node {
            break;
        }
        graph.lines.remove_edge(at, next);
        at = next;
    }
    if at != node && !graph.beside(at).is_empty() {
        graph.lines.add_edge(at, node);
    }
}

/// Puts a node into the chain that passes it at a vertex, or leads on to it the chain that ends there.
fn pass(graph: &mut Graph, near: u32, node: u32) {
    let (place, h) = (graph.place(node), graph.spacing(near));
    let row = graph.beside(near).to_vec();
    // The chain was cut off meanwhile, or meets the node already.
    if row.is_empty() || row.contains(&node) {
        return;
    }
    if row.len() == 1 && distance(graph.place(near), place) > h {
        graph.lines.add_edge(near, node);
        return;
    }
    let off = |w: u32| beside(place, graph.place(near), graph.place(w));
    let next = row.into_iter().min_by(|&a, &b| off(a).total_cmp(&off(b)));
    if let Some(next) = next.filter(|&w| off(w) <= h) {
        graph.lines.remove_edge(near, next);
        graph.lines.add_edge(near, node);
        graph.lines.add_edge(node, next);
    }
}

/// The distance of `p` from the segment from `a` to `b`.
fn beside(p: [f64; 3], a: [f64; 3], b: [f64; 3]) -> f64 {
    let ab = sub(b, a);
    let t = dot(sub(p, a), ab) / dot(ab, ab).max(f64::MIN_POSITIVE);
    distance(p, add_scaled(a, ab, t.clamp(0.0, 1.0)))
}

/// Joins corners near each other that share two faces and have no chain between them.
fn join(graph: &mut Graph, corners: &[Corner]) {
    let places: Vec<[f64; 3]> = corners.iter().map(|c| graph.place(c.vertex)).collect();
    let index = Index::build(&places);
    let mut near = Vec::new();
    for (i, a) in corners.iter().enumerate() {
        let h = graph.spacing(a.vertex);
        near.clear();
        index.around(places[i], SHORT_EDGE.0 * h, |f| near.push(f.index as usize));
        near.sort_unstable();
        for b in near.iter().filter(|&&j| j > i).map(|&j| &corners[j]) {
            let chord = sub(graph.place(b.vertex), graph.place(a.vertex));
            if share_two(a, b, chord, SHORT_EDGE.1 * h) && !joined(graph, a.vertex, b.vertex) {
                graph.lines.add_edge(a.vertex, b.vertex);
            }
        }
    }
}

/// Whether two faces of `a` are faces of `b` as well, and hold the chord between them within `off`.
fn share_two(a: &Corner, b: &Corner, chord: [f64; 3], off: f64) -> bool {
    let held = |n: &&[f64; 3]| dot(**n, chord).abs() <= off && b.normals.iter().any(|&m| same_face(**n, m));
    let shared: Vec<&[f64; 3]> = a.normals.iter().filter(held).collect();
    shared.iter().any(|n| shared.iter().any(|m| norm(cross(**n, **m)) >= CROSSING))
}

/// Whether a chain of a few vertices leads from one corner to the other.
fn joined(graph: &Graph, a: u32, b: u32) -> bool {
    graph.beside(a).iter().any(|&next| graph.walk(a, next, JOINED).contains(&b))
}
