//! Corners where three straight lines meet, in place of what lies around them: ours.
//!
//! Near a corner sections and neighbourhoods hold points of all three faces, so that lines bend away, stop short of it, or are
//! doubled over the last spacings, and two or three nodes stand for one corner. But some spacings farther out they are straight,
//! and three straight lines that pass through one place say where the corner is better than anything near it.

use crate::math::eigen3::eigen3;
use crate::math::least_squares::solve;
use crate::math::tensor::scatter;
use crate::math::union_find::UnionFind;
use crate::math::vec3::{add, add_scaled, distance, dot, norm, scale, sub};
use crate::pattern::{LineGraph, Path, paths};
use crate::surface::Scales;

/// Greatest length of a line between nodes of one corner, in spacings.
const SHORT: f64 = 6.0;
/// The stretch of a line by its distance from the node, in spacings, that shows where it leads.
const STRETCH: (f64, f64) = (4.0, 14.0);
/// Least number of vertices of a stretch and its least length, in spacings.
const ENOUGH: (usize, f64) = (4, 4.0);
/// Greatest deviation of a stretch from a line and of three lines from one place, in spacings, to which the noise is added.
const STRAIGHT: f64 = 0.15;
const MEET: f64 = 0.4;
/// Greatest cosine between two of the lines.
const APART: f64 = 0.9;
/// Greatest distance of the corner from the nearest of its nodes and from all of them, in spacings: where none is near, a small face
/// cuts the corner off.
const NEAR: (f64, f64) = (1.6, 5.0);

/// A line that leaves a group of nodes: its vertices from the node outwards, and the straight stretch of it.
struct Arm {
    vertices: Vec<u32>,
    /// How many vertices lie before the stretch.
    before: usize,
    place: [f64; 3],
    /// Unit direction.
    along: [f64; 3],
}

/// Nodes that short lines join, as one.
struct Groups {
    /// A node that stands for the group, and each of its nodes; ascending.
    nodes: Vec<(u32, u32)>,
    /// The same, and each line that leaves it, from its node outwards.
    leaving: Vec<(u32, Vec<u32>)>,
    /// The same, and each line between its nodes.
    within: Vec<(u32, Vec<u32>)>,
}

impl Groups {
    fn of(lines: &LineGraph, scales: Scales) -> Groups {
        let paths = paths(lines);
        let open = || paths.iter().filter_map(|path| Some((path, path.ends?)));
        let mut sets = UnionFind::new(lines.edges.len());
        for (_, [a, b]) in open().filter(|(path, _)| length(lines, &path.vertices, scales) <= SHORT) {
            sets.union(a, b);
        }
        let mut groups = Groups { nodes: Vec::new(), leaving: Vec::new(), within: Vec::new() };
        for (Path { vertices, .. }, [a, b]) in open() {
            let (s, t) = (sets.find(a), sets.find(b));
            groups.nodes.extend([(s, a), (t, b)]);
            if s == t {
                groups.within.push((s, vertices.clone()));
            } else {
                let back = vertices.iter().rev().copied().collect();
                groups.leaving.extend([(s, vertices.clone()), (t, back)]);
            }
        }
        groups.nodes.sort_unstable();
        groups.nodes.dedup();
        groups.leaving.sort_unstable();
        groups
    }

    /// The three lines that leave a group, if it is three.
    fn three(&self, set: u32) -> Option<[&Vec<u32>; 3]> {
        let from = self.leaving.partition_point(|l| l.0 < set);
        let own = &self.leaving[from..self.leaving.partition_point(|l| l.0 <= set)];
        let [a, b, c] = own else { return None };
        Some([&a.1, &b.1, &c.1])
    }
}

/// Gives groups of nodes that three straight lines leave one node, where these lines meet.
pub(super) fn gather(lines: &mut LineGraph, scales: Scales) {
    let groups = Groups::of(lines, scales);
    let mut corners = Vec::new();
    for group in groups.nodes.chunk_by(|a, b| a.0 == b.0).filter(|g| g.len() > 1) {
        let arms = groups.three(group[0].0).map(|three| three.map(|vertices| arm(lines, vertices, scales)));
        let Some([Some(a), Some(b), Some(c)]) = arms else { continue };
        let Some(corner) = meet([&a, &b, &c], scales) else { continue };
        let far = |v: u32| distance(lines.positions[v as usize], corner) / spacing(lines, v, scales);
        if group.iter().any(|&(_, v)| far(v) <= NEAR.0) && group.iter().all(|&(_, v)| far(v) <= NEAR.1) {
            corners.push((group[0].0, [a, b, c], corner));
        }
    }
    for (set, arms, corner) in corners {
        groups.within.iter().filter(|w| w.0 == set).for_each(|(_, path)| cut(lines, path));
        join(lines, arms, corner, scales);
    }
}

fn spacing(lines: &LineGraph, v: u32, scales: Scales) -> f64 {
    scales.at(lines.points[v as usize] as usize).spacing
}

/// The length of a path in spacings.
fn length(lines: &LineGraph, vertices: &[u32], scales: Scales) -> f64 {
    let step = |pair: &[u32]| {
        let [a, b] = [pair[0], pair[1]].map(|v| lines.positions[v as usize]);
        distance(a, b) / spacing(lines, pair[0], scales)
    };
    vertices.windows(2).map(step).sum()
}

/// The line that leaves a node along `vertices`, if it is straight some spacings farther out.
fn arm(lines: &LineGraph, vertices: &[u32], scales: Scales) -> Option<Arm> {
    let place = |v: u32| lines.positions[v as usize];
    let resolution = scales.at(lines.points[vertices[0] as usize] as usize);
    let h = resolution.spacing;
    let far = |v: u32| distance(place(v), place(vertices[0])) / h;
    let before = vertices.iter().position(|&v| far(v) >= STRETCH.0)?;
    let rest = &vertices[before..];
    // The other end of the line may have a corner of its own.
    let last = place(*vertices.last()?);
    let ends = |&v: &u32| far(v) > STRETCH.1 || distance(place(v), last) < STRETCH.0 * h;
    let count = rest.iter().position(ends).unwrap_or(rest.len());
    let stretch: Vec<[f64; 3]> = rest[..count].iter().map(|&v| place(v)).collect();
    let (few, short) = ENOUGH;
    if count < few || distance(stretch[0], stretch[count - 1]) < short * h {
        return None;
    }
    let (middle, along) = line(&stretch);
    let off = |p: &[f64; 3]| {
        let d = sub(*p, middle);
        norm(add_scaled(d, along, -dot(d, along)))
    };
    let straight = stretch.iter().all(|p| off(p) <= STRAIGHT * h + resolution.noise);
    straight.then(|| Arm { vertices: vertices.to_vec(), before, place: middle, along })
}

/// The middle of some places and the unit direction of the line through them of least squares.
fn line(places: &[[f64; 3]]) -> ([f64; 3], [f64; 3]) {
    let sum = places.iter().copied().fold([0.0; 3], add);
    let middle = scale(sum, 1.0 / places.len() as f64);
    (middle, eigen3(&scatter(places.iter().map(|&p| sub(p, middle)))).vectors[2])
}

/// The place nearest to three lines, if they pass it.
fn meet(arms: [&Arm; 3], scales: Scales) -> Option<[f64; 3]> {
    let mut matrix = [[0.0; 3]; 3];
    let mut right = [0.0; 3];
    let origin = arms[0].place;
    for arm in arms {
        let place = sub(arm.place, origin);
        let foot = add_scaled(place, arm.along, -dot(place, arm.along));
        for i in 0..3 {
            right[i] += foot[i];
            for j in 0..3 {
                matrix[i][j] += f64::from(u8::from(i == j)) - arm.along[i] * arm.along[j];
            }
        }
    }
    let apart = (0..3).all(|k| dot(arms[k].along, arms[(k + 1) % 3].along).abs() <= APART);
    let corner = add(origin, solve(matrix, right)?);
    let limit = MEET * scales.mean.spacing + scales.mean.noise;
    let off = |arm: &Arm| {
        let d = sub(corner, arm.place);
        norm(add_scaled(d, arm.along, -dot(d, arm.along)))
    };
    (apart && arms.iter().all(|arm| off(arm) <= limit)).then_some(corner)
}

/// Removes the edges of a path.
fn cut(lines: &mut LineGraph, vertices: &[u32]) {
    vertices.windows(2).for_each(|pair| lines.remove_edge(pair[0], pair[1]));
}

/// Leads three lines straight to their corner.
fn join(lines: &mut LineGraph, arms: [Arm; 3], corner: [f64; 3], scales: Scales) {
    let node = lines.add_vertex(arms[0].vertices[0], corner);
    lines.corner[node as usize] = 0.0;
    lines.nodes.push(node);
    for Arm { vertices, before, .. } in arms {
        cut(lines, &vertices[..=before]);
        let first = vertices[before];
        lines.add_edge(first, node);
        let steps = distance(lines.positions[first as usize], corner) / spacing(lines, first, scales);
        lines.subdivide(first, node, (steps as u32).max(1));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::resolution::Resolution;

    /// A row of vertices a spacing apart from one place to another.
    fn row(lines: &mut LineGraph, from: [f64; 3], to: [f64; 3]) -> [u32; 2] {
        let a = lines.push_vertex(0, from);
        let b = lines.push_vertex(0, to);
        lines.add_edge(a, b);
        lines.subdivide(a, b, distance(from, to) as u32);
        [a, b]
    }

    /// Three edges of a box, one of which ends too early and is led on twice to a node beside the corner.
    fn doubled(aside: f64) -> LineGraph {
        let mut lines = LineGraph::default();
        let [x, _] = row(&mut lines, [3.5, 0.0, 0.0], [30.0, 0.0, 0.0]);
        let [y, _] = row(&mut lines, [aside, 1.0 + aside, 0.0], [0.0, 30.0, 0.0]);
        let [z, _] = row(&mut lines, [aside, aside, 1.5], [0.0, 0.0, 30.0]);
        let between = lines.push_vertex(0, [2.0, 0.2, 0.0]);
        let other = lines.push_vertex(0, [2.0, 0.9, 0.0]);
        for (a, b) in [(x, between), (between, y), (x, other), (other, y), (y, z)] {
            lines.add_edge(a, b);
        }
        lines
    }

    fn scales() -> Scales<'static> {
        Resolution { spacing: 1.0, noise: 0.05 }.into()
    }

    #[test]
    fn three_straight_lines_meet_in_one_node() {
        let mut lines = doubled(0.15);
        gather(&mut lines, scales());
        let node = (0..lines.edges.len()).filter(|&v| lines.edges[v].len() > 2).collect::<Vec<_>>();
        assert_eq!(node.len(), 1);
        assert!(norm(lines.positions[node[0]]) < 0.3, "{:?}", lines.positions[node[0]]);
        let paths = paths(&lines);
        assert_eq!(paths.len(), 3);
        assert!(paths.iter().all(|path| path.ends.is_some_and(|ends| ends.contains(&(node[0] as u32)))));
        for v in paths.iter().flat_map(|path| &path.vertices) {
            let [x, y, z] = lines.positions[*v as usize];
            assert!(x.hypot(y).min(y.hypot(z)).min(x.hypot(z)) < 0.4, "{x} {y} {z}");
        }
    }

    #[test]
    fn a_small_face_that_cuts_a_corner_off_stays() {
        let mut lines = LineGraph::default();
        let nodes = [0, 1, 2].map(|k| {
            let at = |x: f64| std::array::from_fn(|i| if i == k { x } else { 0.0 });
            row(&mut lines, at(3.0), at(30.0))[0]
        });
        (0..3).for_each(|k| lines.add_edge(nodes[k], nodes[(k + 1) % 3]));
        let before = lines.clone();
        gather(&mut lines, scales());
        assert_eq!(lines, before);
    }
}
