//! Edges without length: where surfaces meet in one point that the network has as two nodes.

use super::Brep;
use super::vertex::rounding;
use crate::curve::pieces::Shape;
use crate::math::union_find::UnionFind;
use crate::math::vec3::distance;

/// Multiple of what rounding leaves up to which vertices are one: programs of CAD tell shorter edges from none no more.
const SHORT: f64 = 100.0;

/// Takes edges out whose ends are one point, and makes the ends one vertex.
pub(super) fn collapse(found: &mut Brep) {
    let most = SHORT * rounding(&found.vertices);
    let none = |e: &super::Edge| {
        let [a, b] = e.ends.map(|v| found.vertices[v as usize]);
        e.shape == Shape::Line && distance(a, b) <= most
    };
    let short: Vec<bool> = found.edges.iter().map(none).collect();
    if !short.contains(&true) {
        return;
    }
    let mut sets = UnionFind::new(found.vertices.len());
    for edge in found.edges.iter().zip(&short).filter(|(_, s)| **s).map(|(e, _)| e) {
        sets.union(edge.ends[0], edge.ends[1]);
    }
    found.edges.iter_mut().for_each(|edge| edge.ends = edge.ends.map(|v| sets.find(v)));
    for face in &mut found.faces {
        face.loops.iter_mut().for_each(|row| row.retain(|(e, _)| !short[*e as usize]));
        face.loops.retain(|row| !row.is_empty());
    }
    drop_unused(found);
}

/// Numbers the edges and vertices that are left anew.
fn drop_unused(found: &mut Brep) {
    let mut used = vec![false; found.edges.len()];
    found.faces.iter().flat_map(|f| f.loops.iter().flatten()).for_each(|(e, _)| used[*e as usize] = true);
    let number = numbers(&used);
    for (edge, _) in found.faces.iter_mut().flat_map(|f| f.loops.iter_mut().flatten()) {
        *edge = number[*edge as usize];
    }
    let mut keep = used.iter();
    found.edges.retain(|_| keep.next().is_some_and(|&k| k));
    let mut used = vec![false; found.vertices.len()];
    found.edges.iter().flat_map(|e| e.ends).for_each(|v| used[v as usize] = true);
    let number = numbers(&used);
    found.edges.iter_mut().for_each(|edge| edge.ends = edge.ends.map(|v| number[v as usize]));
    let mut keep = used.iter();
    found.vertices.retain(|_| keep.next().is_some_and(|&k| k));
}

/// The new number of each thing that is kept.
fn numbers(used: &[bool]) -> Vec<u32> {
    let mut next = 0;
    let number = |&used: &bool| {
        next += u32::from(used);
        next.saturating_sub(1)
    };
    used.iter().map(number).collect()
}
