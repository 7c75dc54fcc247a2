//! Nodes where the lines and arcs that end on them meet (ours). The vertices of a line near its corner see more than its two faces and bend
//! away from the edge; the line through the others leads on to the corner.

use super::spline::{self, ALIKE, BENT, Place};
use crate::curve::pieces::{AT_END, Piece, Shape};
use crate::curve::round::{Round, plane};
use crate::frame::on_grid;
use crate::math::least_squares::solve;
use crate::math::vec3::{add_scaled, cross, distance, distance2, dot, norm, sub, unit};
use crate::network::{Network, Strip};
use crate::parallel;
use crate::params::SplineParams;
use crate::resolution::Resolution;
use crate::surface::Scales;

/// Longest piece that is a bend beside a node, in lengths over which rows bend there.
const HOOK: f64 = 1.5;
/// Least length that is left of a piece, spacings.
const LEAST: f64 = 3.0;
/// Standard deviation of a node as it is, spacings.
const NODE: f64 = 0.7;
/// Standard deviation of a curve of which many points are known, spacings.
const MODEL: f64 = 0.05;
/// Least way that a node moves, spacings: the strips on it are laid anew.
const NEAR: f64 = 0.3;
/// Farthest that a node moves, spacings.
const FAR: f64 = 3.0;
/// Greatest distance of a curve from the node that it leads to, spacings.
const MISSED: f64 = 1.0;

/// Moves nodes to where their curves meet, and lays the strips on to them; local frame, sources as canonical indices.
pub(crate) fn meet(network: &mut Network, scales: Scales, spline: &SplineParams) {
    let Network { nodes, strips, .. } = &*network;
    let mut leads: Vec<Vec<Lead>> = vec![Vec::new(); nodes.len()];
    for strip in strips {
        for (k, end) in [strip.start, strip.end].into_iter().enumerate() {
            if let Some(end) = end {
                leads[end as usize].extend(Lead::of(strip, k == 1, scales));
            }
        }
    }
    let mut moved: Vec<Option<[f64; 3]>> = parallel::map(nodes.len(), parallel::TASK, |n| {
        if nodes[n].degree > 1 { met(nodes[n].position, &leads[n]) } else { None }
    });
    part(network, &mut moved);
    lay(network, &moved, scales, spline);
}

/// Leaves the nodes of a strip that would shrink to a point where they are.
fn part(network: &Network, moved: &mut [Option<[f64; 3]>]) {
    let Network { nodes, strips, .. } = network;
    let ends = strips.iter().filter_map(|s| Some([s.start? as usize, s.end? as usize]));
    let met: Vec<[usize; 2]> = ends
        .filter(|&[a, b]| {
            let to = |n: usize| moved[n].unwrap_or(nodes[n].position);
            a != b && to(a) == to(b)
        })
        .collect();
    met.into_iter().flatten().for_each(|n| moved[n] = None);
}

/// A curve that leads to a node, as its tangent there.
#[derive(Clone, Copy, Debug)]
struct Lead {
    /// The point of the curve nearest to the node.
    at: [f64; 3],
    /// Its unit direction there.
    direction: [f64; 3],
    /// Its variance across the direction.
    variance: f64,
    /// The spacing along it.
    spacing: f64,
}

impl Lead {
    /// Of the first piece of an open strip, or of its last one, but for a bend beside the node; `None` if that is too short or of another
    /// type.
    fn of(strip: &Strip, last: bool, scales: Scales) -> Option<Lead> {
        let Resolution { spacing, noise } = scales.finest(&strip.sources);
        let bent = BENT * spacing;
        let mut pieces: Vec<&Piece> = strip.curves.iter().take(if last { 0 } else { 2 }).collect();
        pieces.extend(strip.curves.iter().rev().take(if last { 2 } else { 0 }));
        let along = |p: &Piece| length(&strip.points[p.first..=p.last]);
        let hooked = pieces.len() > 1 && along(pieces[0]) < HOOK * bent;
        let piece = *pieces.get(usize::from(hooked))?;
        let node = strip.points[if last { strip.points.len() - 1 } else { 0 }];
        let beside = if hooked { 0.0 } else { bent };
        let row = inner(
            &strip.points[piece.first..=piece.last],
            if last { [bent, beside] } else { [beside, bent] },
        );
        let length = length(row);
        if row.len() < 3 || length < LEAST * spacing {
            return None;
        }
        let (at, direction, error) = match piece.shape {
            Shape::Line => line(row, node),
            Shape::Arc { .. } => arc(row, node)?,
            _ => return None,
        };
        let rms = (error / row.len() as f64).sqrt().max(noise);
        let many = (length / (ALIKE * spacing)).max(1.0);
        let factor = AT_END[usize::from(!matches!(piece.shape, Shape::Line))];
        let variance = factor * rms * rms / many + (MODEL * spacing).powi(2);
        Some(Lead { at, direction, variance, spacing })
    }

    /// The vector from the curve to a point.
    fn off(&self, p: [f64; 3]) -> [f64; 3] {
        let from = sub(p, self.at);
        add_scaled(from, self.direction, -dot(from, self.direction))
    }
}

fn length(row: &[[f64; 3]]) -> f64 {
    row.windows(2).map(|w| distance(w[0], w[1])).sum()
}

/// The points of a row that lie so far along it from its first and from its last one.
fn inner(row: &[[f64; 3]], skipped: [f64; 2]) -> &[[f64; 3]] {
    let count = |points: &mut dyn Iterator<Item = &[f64; 3]>, far: f64| {
        let (mut along, mut before, mut count) = (0.0, None, 0);
        for &p in points {
            along += before.map_or(0.0, |b| distance(b, p));
            if along >= far {
                break;
            }
            (before, count) = (Some(p), count + 1);
        }
        count
    };
    let (first, last) =
        (count(&mut row.iter(), skipped[0]), row.len() - count(&mut row.iter().rev(), skipped[1]));
    if first < last { &row[first..last] } else { &[] }
}

/// The line through points at its foot of the node, and the sum of the squared distances from it.
fn line(row: &[[f64; 3]], node: [f64; 3]) -> ([f64; 3], [f64; 3], f64) {
    let (at, [direction, ..]) = plane(row).unwrap_or((row[0], [unit(sub(row[row.len() - 1], row[0])); 3]));
    let foot = |p: [f64; 3]| add_scaled(at, direction, dot(sub(p, at), direction));
    (foot(node), direction, row.iter().map(|&p| distance2(p, foot(p))).sum())
}

/// As [`line`], of the circle through points; `None` if there is none.
fn arc(row: &[[f64; 3]], node: [f64; 3]) -> Option<([f64; 3], [f64; 3], f64)> {
    let round = Round::fit(row)?;
    let at = round.foot(node);
    let direction = unit(cross(round.normal, sub(at, round.centre)));
    Some((at, direction, row.iter().map(|&p| distance2(p, round.foot(p))).sum()))
}

/// The point of least squared distances from the curves and from the node, in their variances; `None` if the curves do not meet there.
fn met(node: [f64; 3], leads: &[Lead]) -> Option<[f64; 3]> {
    let spacing = leads.iter().map(|l| l.spacing).reduce(f64::min)?;
    let mut used: Vec<Lead> = leads.to_vec();
    loop {
        let at = nearest(node, &used, spacing)?;
        let miss = |l: &Lead| norm(l.off(at));
        let worst = (0..used.len()).max_by(|&a, &b| miss(&used[a]).total_cmp(&miss(&used[b])))?;
        if miss(&used[worst]) <= MISSED * spacing {
            let range = NEAR * spacing..=FAR * spacing;
            return range.contains(&distance(at, node)).then(|| at.map(on_grid));
        }
        used.remove(worst);
    }
}

fn nearest(node: [f64; 3], leads: &[Lead], spacing: f64) -> Option<[f64; 3]> {
    let prior = (NODE * spacing).powi(-2);
    let mut normal = [[0.0; 3]; 3];
    let mut right = [0.0; 3];
    (0..3).for_each(|i| normal[i][i] = prior);
    for lead in leads {
        let (d, off) = (lead.direction, lead.off(node));
        for i in 0..3 {
            right[i] -= off[i] / lead.variance;
            for j in 0..3 {
                normal[i][j] += (f64::from(u8::from(i == j)) - d[i] * d[j]) / lead.variance;
            }
        }
    }
    let step = solve(normal, right)?;
    Some(add_scaled(node, step, 1.0))
}

/// Moves the nodes, and lays the strips through their points up to where they bend.
fn lay(network: &mut Network, moved: &[Option<[f64; 3]>], scales: Scales, spline: &SplineParams) {
    for (node, to) in network.nodes.iter_mut().zip(moved) {
        node.position = to.unwrap_or(node.position);
    }
    let nodes = &network.nodes;
    for strip in &mut network.strips {
        let (Some(start), Some(end)) = (strip.start, strip.end) else { continue };
        let ends = [start, end].map(|n| n as usize);
        // A strip that is a single point is dropped later, on the way to the world frame.
        if ends.iter().all(|&n| moved[n].is_none()) || strip.points.len() < 2 {
            continue;
        }
        let bent = BENT * scales.finest(&strip.sources).spacing;
        let [from, to] = ends.map(|n| Place { at: nodes[n].position, sigma: None });
        let far = |p: &[f64; 3]| {
            ends.iter().all(|&n| moved[n].is_none() || distance(*p, nodes[n].position) >= bent)
        };
        let inner = &strip.points[1..strip.points.len() - 1];
        let places: Vec<Place> =
            inner.iter().copied().filter(far).map(|at| Place { at, sigma: None }).collect();
        let deviation = strip.deviation;
        spline::relay(strip, &places, [Some(from), Some(to)], scales, spline);
        strip.deviation = strip.deviation.max(deviation);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::network::{Node, NodeKind};
    use crate::pattern::{LineGraph, Pattern};
    use crate::recover::{LED_ON, recover};

    /// Three edges of a cube of 20, up to so far from the corner at the origin, where they bend to a node beside it.
    fn bent(node: [f64; 3]) -> Pattern {
        let mut crease = LineGraph::default();
        let corner = crease.push_vertex(0, node);
        for axis in 0..3 {
            let mut before = corner;
            for k in 3..=20 {
                let mut p = [0.0; 3];
                p[axis] = f64::from(k);
                let next = crease.push_vertex(crease.edges.len() as u32, p);
                crease.add_edge(before, next);
                before = next;
            }
        }
        Pattern { crease, ..Pattern::default() }
    }

    fn junction(pattern: &Pattern) -> (Network, Node) {
        let params = SplineParams::default();
        let resolution = Resolution { spacing: 1.0, noise: 0.05 };
        let mut network = recover(pattern, resolution, &params, LED_ON);
        meet(&mut network, Scales::from(resolution), &params);
        let node = network.nodes.iter().find(|n| n.kind == NodeKind::Junction).unwrap().clone();
        (network, node)
    }

    #[test]
    fn a_node_beside_its_corner_moves_there_with_its_lines() {
        let (network, node) = junction(&bent([1.0, 0.8, 0.9]));
        assert!(norm(node.position) < 0.15, "{:?}", node.position);
        for strip in &network.strips {
            assert!(
                strip.points.first() == Some(&node.position) || strip.points.last() == Some(&node.position)
            );
            let off = |p: &[f64; 3]| {
                let mut sorted = p.map(f64::abs);
                sorted.sort_by(f64::total_cmp);
                sorted[0].hypot(sorted[1])
            };
            assert!(strip.points.iter().map(off).fold(0.0, f64::max) < 0.3);
            assert_eq!(strip.curves.len(), 1);
        }
    }

    #[test]
    fn a_node_where_its_lines_meet_stays_and_one_far_from_there() {
        for far in [[0.05, 0.0, 0.0], [2.2, 2.2, 2.2]] {
            let (_, node) = junction(&bent(far));
            assert!(distance(node.position, far) < 1e-6, "{:?}", node.position);
        }
    }
}
