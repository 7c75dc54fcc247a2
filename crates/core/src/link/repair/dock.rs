//! Leads creases that end near a border on to it, as the folded surface ends there too.
//!
//! Both patterns get a node at the same place. Not in Gumhold 2001, whose patterns do not meet.

use crate::math::vec3::{add, distance, distance2, dot, norm, scale, sub, unit};
use crate::neighbors::Index;
use crate::pattern::{LineGraph, Pattern};
use crate::surface::Scales;

/// Greatest distance of a loose crease end from a border, spacings, and greatest angle between its direction and the border's
/// vertex, degrees; nearest first.
const DOCKING: [(f64, f64); 3] = [(2.0, 100.0), (4.0, 60.0), (6.0, 35.0)];
/// Length of the piece of crease that gives the direction of its end, spacings.
const TANGENT: f64 = 4.0;
/// Greatest length of a border's edge near a loose end, spacings.
const EDGE_STEP: f64 = 1.0;
/// Greatest number of pieces of an edge: only a cloud of two scales has edges of so many spacings.
const PIECES: f64 = 256.0;
/// A crease that would meet the border no farther than this from a node ends in that node, spacings.
const SAME_NODE: f64 = 2.0;

/// Leads loose crease ends on to borders.
pub(crate) fn dock(pattern: &mut Pattern, scales: Scales) {
    let Pattern { crease, border, .. } = pattern;
    let ends: Vec<u32> =
        (0..crease.edges.len() as u32).filter(|&v| crease.edges[v as usize].len() == 1).collect();
    refine(border, ends.iter().map(|&v| crease.positions[v as usize]).collect(), scales);
    let on: Vec<u32> =
        (0..border.edges.len() as u32).filter(|&v| !border.edges[v as usize].is_empty()).collect();
    let positions: Vec<[f64; 3]> = on.iter().map(|&v| border.positions[v as usize]).collect();
    let index = Index::build(&positions);
    let mut is_node = border.is_node();
    let mut found = Vec::new();
    for end in ends {
        let (at, h) = (crease.positions[end as usize], scales.unit(crease.points[end as usize]));
        let tangent = tangent(crease, end, h);
        let target = DOCKING.iter().find_map(|&(reach, angle)| {
            index.within(at, reach * h, &mut found);
            let vertices = found.iter().map(|f| on[f.index as usize]);
            ahead(border, vertices, at, tangent, angle)
        });
        if let Some(target) = target {
            index.within(border.positions[target as usize], SAME_NODE * h, &mut found);
            let node = found.iter().map(|f| on[f.index as usize]).find(|&v| is_node[v as usize]);
            let target = node.unwrap_or(target);
            meet(crease, border, end, target);
            is_node[target as usize] = true;
        }
    }
}

/// Divides long border edges near loose ends, so that the ends find vertices to meet.
fn refine(border: &mut LineGraph, ends: Vec<[f64; 3]>, scales: Scales) {
    let index = Index::build(&ends);
    let mut found = Vec::new();
    for a in 0..border.edges.len() as u32 {
        for b in border.edges[a as usize].clone().into_iter().filter(|&b| b > a) {
            let [from, to] = [a, b].map(|v| border.positions[v as usize]);
            let length = distance(from, to);
            let h = scales.between(border.points[a as usize], border.points[b as usize]);
            index.within(scale(add(from, to), 0.5), 0.5 * length + DOCKING[2].0 * h, &mut found);
            let pieces = (length / (EDGE_STEP * h)).ceil().min(PIECES) as u32;
            if pieces > 1 && !found.is_empty() {
                border.subdivide(a, b, pieces);
            }
        }
    }
}

/// The border vertex, among those given, that the end reaches with the least distance and turn.
fn ahead(
    border: &LineGraph,
    vertices: impl Iterator<Item = u32>,
    at: [f64; 3],
    tangent: [f64; 3],
    angle_deg: f64,
) -> Option<u32> {
    let cosine = angle_deg.to_radians().cos();
    vertices
        .filter_map(|v| {
            let gap = sub(border.positions[v as usize], at);
            let length = norm(gap);
            let straight = if length > 0.0 { dot(tangent, gap) / length } else { 1.0 };
            (straight >= cosine).then_some((length * (2.0 - straight), v))
        })
        .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
        .map(|(_, v)| v)
}

/// The direction in which a crease leaves its loose end.
fn tangent(crease: &LineGraph, end: u32, h: f64) -> [f64; 3] {
    let position = crease.positions[end as usize];
    let (mut before, mut at) = (end, crease.edges[end as usize][0]);
    while distance(crease.positions[at as usize], position) < TANGENT * h {
        let next = &crease.edges[at as usize];
        if next.len() != 2 {
            break;
        }
        (before, at) = (at, if next[0] == before { next[1] } else { next[0] });
        if at == end {
            break;
        }
    }
    unit(sub(position, crease.positions[at as usize]))
}

/// Lengthens the crease from `end` to the border's vertex `target`, which becomes a node.
fn meet(crease: &mut LineGraph, border: &mut LineGraph, end: u32, target: u32) {
    let place = border.positions[target as usize];
    if distance2(crease.positions[end as usize], place) > 0.0 {
        let vertex = crease.add_vertex(end, place);
        crease.points[vertex as usize] = border.points[target as usize];
        crease.add_edge(end, vertex);
    }
    border.nodes.push(target);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_of_any_number_of_spacings_is_cut_into_a_bounded_number_of_pieces() {
        for spacing in [1e-310, 1e-9, 0.3] {
            let mut border = LineGraph {
                points: vec![0, 1],
                positions: vec![[0.0; 3], [1.0, 0.0, 0.0]],
                penalty: vec![Some(0.0); 2],
                corner: vec![0.0; 2],
                evidence: vec![None; 2],
                radius: vec![0.0; 2],
                edges: vec![vec![1], vec![0]],
                nodes: Vec::new(),
            };
            refine(&mut border, vec![[0.5, 0.0, 0.0]], crate::Resolution { spacing, noise: 0.0 }.into());
            let pieces = (1.0 / spacing).ceil().min(PIECES) as usize;
            assert_eq!(border.edge_count(), pieces, "{spacing:e}");
        }
    }
}
