//! Folds of a mesh as chains: ours.
//!
//! Points sampled on the faces of a mesh show a crease only where these are several spacings wide. But the mesh says itself where its
//! faces fold, to the last bit, so these edges take the place of the lines beside them.

use std::collections::BTreeMap;

use super::graph::Graph;
use super::overlay;
use super::samples::Samples;
use crate::math::vec3::{add_scaled, distance, dot, sub, unit};
use crate::measure::Edgelet;
use crate::mesh::Fold;
use crate::neighbors::Index;
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// Distance in spacings from the points within which a fold is part of what they show.
const SHOWN: f64 = 3.0;
/// Least height in spacings of the triangles beside a fold: a narrower facet is part of a round, or its plane is left to chance.
const HEIGHT: f64 = 0.5;
/// Share of the fold that makes a crease from which on an edge is one too where it lies on a line or in a gap.
const FAINT: f64 = 0.5;
/// Distance in spacings of such an edge from the line.
const ALONG: f64 = 1.0;
/// Most such edges in a gap.
const GAP: usize = 3;
/// Cosine of the turn at a vertex, 50 degrees, from which on a line ends.
const TURN: f64 = 0.642_788;
/// Evidence of a fold, which is beyond doubt.
const CERTAIN: f64 = 1e4;
/// Most steps along an edge.
const STEPS: f64 = 1e4;

/// What is known of the mesh that the points were sampled on, local frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known<'a> {
    /// Its folds.
    pub(crate) folds: &'a [Fold],
    /// The points.
    pub(crate) points: &'a [[f64; 3]],
    /// Radians from which on a fold is a crease.
    pub(crate) least: f64,
}

/// The creases that are known, and the lines where there is none.
pub(in crate::link) fn lay(lines: LineGraph, known: &Known, scales: Scales) -> LineGraph {
    let mut edges = Edges::new(known, scales);
    edges.choose(known.least, &lines, scales);
    edges.fill();
    let graph = edges.graph(scales);
    if graph.edgelets.is_empty() {
        return lines;
    }
    let whole = vec![false; lines.edges.len()];
    overlay::overlay(graph, &lines, &whole, scales)
}

/// Edges of the mesh that fold, those of them that are creases, and which meet at each vertex.
struct Edges {
    folds: Vec<Fold>,
    /// `(E, 2)` numbers of the ends, and the points nearest to them.
    ends: Vec<[u32; 2]>,
    near: Vec<[u32; 2]>,
    /// `(E)` whether each is a crease.
    chosen: Vec<bool>,
    /// `(V)` edges at each end.
    at: Vec<Vec<u32>>,
}

impl Edges {
    /// The folds that the points show, but those that are too slight.
    fn new(known: &Known, scales: Scales) -> Edges {
        let index = Index::build(known.points);
        let mut numbers: BTreeMap<[u64; 3], u32> = BTreeMap::new();
        let mut edges = Edges {
            folds: Vec::new(),
            ends: Vec::new(),
            near: Vec::new(),
            chosen: Vec::new(),
            at: Vec::new(),
        };
        for fold in known.folds.iter().filter(|f| f.turn() >= FAINT * known.least) {
            let Some(near) = shown(fold, &index, scales) else { continue };
            let ends = fold.ends.map(|place| {
                let next = numbers.len() as u32;
                *numbers.entry(place.map(|x| (x + 0.0).to_bits())).or_insert(next)
            });
            edges.at.resize(numbers.len(), Vec::new());
            ends.iter().for_each(|&v| edges.at[v as usize].push(edges.folds.len() as u32));
            edges.folds.push(*fold);
            edges.ends.push(ends);
            edges.near.push(near);
        }
        edges
    }

    /// Chooses the sharp folds, and the faint ones all along which there is a line.
    fn choose(&mut self, least: f64, lines: &LineGraph, scales: Scales) {
        let spacing = |p: u32| scales.at(p as usize).spacing;
        let pairs = lines.edges.iter().zip(0_u32..).flat_map(|(list, a)| list.iter().map(move |&b| (a, b)));
        let place = |v: u32| lines.positions[v as usize];
        let segments = pairs.filter(|(a, b)| a < b);
        let seen =
            Samples::new(segments.map(|(a, b)| (place(a), place(b), spacing(lines.points[a as usize]))));
        let lined = |(fold, [a, b]): (&Fold, [u32; 2])| {
            let [p, q] = fold.ends;
            let reach = ALONG * 0.5 * (spacing(a) + spacing(b));
            let near = |t: f64| seen.nearest(add_scaled(p, sub(q, p), t), reach, |_| true).is_some();
            [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().all(near)
        };
        let rows = self.folds.iter().zip(self.near.iter().copied());
        self.chosen = rows.map(|(fold, near)| fold.turn() >= least || lined((fold, near))).collect();
    }

    /// Chooses up to three faint folds that lead straight on from a loose end to another crease.
    fn fill(&mut self) {
        let creases = |v: u32| self.at[v as usize].iter().filter(|&&e| self.chosen[e as usize]);
        let mut gaps = Vec::new();
        for v in 0..self.at.len() as u32 {
            if creases(v).count() != 1 {
                continue;
            }
            let Some(&first) = creases(v).next() else { continue };
            let (mut before, mut at, mut row) = (first, v, Vec::new());
            while row.len() < GAP
                && let Some(next) = self.onwards(before, at)
            {
                row.push(next);
                (before, at) = (next, self.other(next, at));
                if creases(at).next().is_some() {
                    gaps.append(&mut row);
                    break;
                }
            }
        }
        gaps.iter().for_each(|&e| self.chosen[e as usize] = true);
    }

    /// The edge that is no crease and goes on straightest from the end `v` of another.
    fn onwards(&self, from: u32, v: u32) -> Option<u32> {
        let away = |e: u32| self.away(e, v);
        let straight = |e: u32| -dot(away(from), away(e));
        let free = self.at[v as usize].iter().copied().filter(|&e| e != from && !self.chosen[e as usize]);
        free.filter(|&e| straight(e) > TURN).max_by(|&a, &b| straight(a).total_cmp(&straight(b)))
    }

    fn other(&self, e: u32, v: u32) -> u32 {
        let [a, b] = self.ends[e as usize];
        a ^ b ^ v
    }

    /// The unit direction of an edge away from its end `v`.
    fn away(&self, e: u32, v: u32) -> [f64; 3] {
        let [p, q] = self.folds[e as usize].ends;
        unit(if self.ends[e as usize][0] == v { sub(q, p) } else { sub(p, q) })
    }

    /// The graph of the creases, in steps of at most a spacing.
    fn graph(&self, scales: Scales) -> Graph {
        let mut graph = Graph::default();
        let mut number = vec![u32::MAX; self.at.len()];
        for e in (0..self.folds.len()).filter(|&e| self.chosen[e]) {
            let (fold, near) = (&self.folds[e], self.near[e]);
            let ([p, q], along) = (fold.ends, self.away(e as u32, self.ends[e][0]));
            let edgelet = |place: [f64; 3], point: u32| {
                let spacing = scales.at(point as usize).spacing;
                let (deviation, evidence, reach) = (0.0, CERTAIN, spacing);
                Edgelet {
                    place,
                    point,
                    along,
                    arms: fold.arms,
                    spacing,
                    deviation,
                    evidence,
                    reach,
                    radius: 0.0,
                }
            };
            let mut end = |k: usize| {
                let own = &mut number[self.ends[e][k] as usize];
                if *own == u32::MAX {
                    *own = graph.push(&edgelet(fold.ends[k], near[k]));
                }
                *own
            };
            let [first, last] = [end(0), end(1)];
            let steps = (distance(p, q) / scales.finest(&near).spacing).ceil().clamp(1.0, STEPS);
            let mut before = first;
            for k in 1..steps as usize {
                let t = k as f64 / steps;
                let next = graph.push(&edgelet(add_scaled(p, sub(q, p), t), near[usize::from(t > 0.5)]));
                graph.lines.add_edge(before, next);
                before = next;
            }
            graph.lines.add_edge(before, last);
        }
        self.corners(&number, &mut graph);
        graph
    }

    /// Ends lines where they turn.
    fn corners(&self, number: &[u32], graph: &mut Graph) {
        for (v, &own) in number.iter().enumerate() {
            let here: Vec<u32> = self.at[v].iter().copied().filter(|&e| self.chosen[e as usize]).collect();
            if let [a, b] = here[..]
                && -dot(self.away(a, v as u32), self.away(b, v as u32)) < TURN
            {
                graph.lines.nodes.push(own);
                graph.lines.corner[own as usize] = 0.0;
            }
        }
    }
}

/// The points nearest to the ends of a fold, where they show it.
fn shown(fold: &Fold, index: &Index, scales: Scales) -> Option<[u32; 2]> {
    let mut found = Vec::new();
    let mut nearest = |end: [f64; 3]| {
        index.nearest(end, 1, &mut found);
        let first = found.first()?;
        let spacing = scales.at(first.index as usize).spacing;
        let seen = first.distance2 <= (SHOWN * spacing).powi(2) && fold.height >= HEIGHT * spacing;
        seen.then_some(first.index)
    };
    Some([nearest(fold.ends[0])?, nearest(fold.ends[1])?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::paths;
    use crate::resolution::Resolution;

    /// A fold by `turn_deg` from one place to another, in a plane of z.
    fn fold(ends: [[f64; 3]; 2], turn_deg: f64) -> Fold {
        let [x, y, _] = unit(sub(ends[1], ends[0]));
        let (sin, cos) = turn_deg.to_radians().sin_cos();
        Fold { ends, arms: [[-y, x, 0.0], [y * cos, -x * cos, sin]], height: 2.0 }
    }

    /// How many lines there are along folds of these turns, four spacings each, end to end at `y`, each beginning `shift` aside.
    fn lines(turns_deg: &[f64], shift: f64) -> usize {
        let place = |k: usize| [4.0 * k as f64, if k % 2 == 1 { shift } else { 0.0 }, 0.0];
        let folds: Vec<Fold> =
            turns_deg.iter().enumerate().map(|(k, &turn)| fold([place(k), place(k + 1)], turn)).collect();
        let points: Vec<[f64; 3]> = (0..100).map(|i| [f64::from(i % 50), f64::from(i / 50), 0.0]).collect();
        let known = Known { folds: &folds, points: &points, least: 25_f64.to_radians() };
        let scales = Resolution { spacing: 1.0, noise: 0.0 }.into();
        paths(&lay(LineGraph::default(), &known, scales)).len()
    }

    #[test]
    fn a_line_leads_on_over_up_to_three_fainter_folds() {
        assert_eq!(lines(&[40.0, 30.0], 0.0), 1);
        assert_eq!(lines(&[40.0, 15.0, 30.0], 0.0), 1);
        assert_eq!(lines(&[40.0, 15.0, 15.0, 15.0, 30.0], 0.0), 1);
        assert_eq!(lines(&[40.0, 15.0, 15.0, 15.0, 15.0, 30.0], 0.0), 2);
        assert_eq!(lines(&[40.0, 10.0, 30.0], 0.0), 2);
        assert_eq!(lines(&[15.0, 15.0], 0.0), 0);
    }

    #[test]
    fn a_line_ends_where_it_turns() {
        assert_eq!(lines(&[40.0, 30.0], 1.0), 1);
        assert_eq!(lines(&[40.0, 30.0], 3.0), 2);
        // Nor does a gap lead round a corner.
        assert_eq!(lines(&[40.0, 15.0, 30.0], 3.0), 2);
    }

    #[test]
    fn facets_that_are_too_narrow_and_folds_far_from_the_points_say_nothing() {
        let points = [[0.0; 3], [1.0, 0.0, 0.0]];
        let count = |fold: Fold| {
            let known = Known { folds: &[fold], points: &points, least: 0.4 };
            lay(LineGraph::default(), &known, Resolution { spacing: 1.0, noise: 0.0 }.into()).edge_count()
        };
        let sound = fold([[0.0; 3], [3.0, 0.0, 0.0]], 40.0);
        assert_eq!(count(sound), 3);
        assert_eq!(count(Fold { height: 0.4, ..sound }), 0);
        assert_eq!(count(fold([[0.0; 3], [5.0, 0.0, 0.0]], 40.0)), 0);
    }
}
