//! Corners and edges of two graphs, one to one, as wireframes of buildings are scored (Building3D, Wang et al. 2023): corners are
//! paired within a tolerance, and an edge is right where its two corners are those of a known edge.
//!
//! There the pairs of least total distance are taken of all corners, and those beyond the tolerance dropped, so that a far corner may
//! cost a near pair; here as many pairs as there can be within the tolerance, of least total distance. Loops without a corner are no
//! part of it, and no tolerance is common to the papers: state it beside the figure.

use std::collections::BTreeMap;

use super::assignment::assign;
use super::figures::Hits;
use super::topology::Graph;
use crate::math::trees::kd;
use crate::math::union_find::UnionFind;
use crate::math::vec3::distance;

/// Most corners on either side that are paired at least cost, as that takes their third power; greedily beyond.
const MOST: usize = 400;

/// Corners and edges of a graph that are right.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wireframe {
    /// Ends of open lines.
    pub corners: Hits,
    /// Open lines.
    pub edges: Hits,
    /// Mean distance of the paired corners, in the unit of the lines; NaN without a pair.
    pub offset: f64,
}

impl Wireframe {
    pub(super) fn of(found: &Graph, known: &Graph, tolerance: f64) -> Self {
        let (corners, places) = (Corners::new(found), Corners::new(known));
        let pairs = pairs(&corners.places, &places.places, tolerance);
        let mut wanted: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        places.edges.iter().for_each(|&e| *wanted.entry(e).or_default() += 1);
        let mut right = 0;
        for edge in &corners.edges {
            let [Some(a), Some(b)] = edge.map(|c| pairs[c]) else { continue };
            if let Some(left) = wanted.get_mut(&[a.min(b), a.max(b)]).filter(|left| **left > 0) {
                *left -= 1;
                right += 1;
            }
        }
        let apart = pairs.iter().enumerate().filter_map(|(i, p)| Some((i, (*p)?)));
        let apart: Vec<f64> = apart.map(|(i, j)| distance(corners.places[i], places.places[j])).collect();
        Self {
            corners: Hits::counted(apart.len(), corners.places.len(), places.places.len()),
            edges: Hits::counted(right, corners.edges.len(), places.edges.len()),
            offset: apart.iter().sum::<f64>() / apart.len() as f64,
        }
    }
}

/// The nodes and lines of a graph without its closed lines.
struct Corners {
    places: Vec<[f64; 3]>,
    /// The corners of each line, the lesser first.
    edges: Vec<[usize; 2]>,
}

impl Corners {
    fn new(graph: &Graph) -> Self {
        let open = graph.lines.iter().filter(|[a, b]| a != b);
        let mut number = vec![None; graph.places.len()];
        let mut places = Vec::new();
        let mut corner = |node: usize| {
            *number[node].get_or_insert_with(|| {
                places.push(graph.places[node]);
                places.len() - 1
            })
        };
        let edges = open.map(|&[a, b]| [corner(a), corner(b)]).map(|[a, b]| [a.min(b), a.max(b)]).collect();
        Self { places, edges }
    }
}

/// For each point the one of the others that it is paired with.
fn pairs(points: &[[f64; 3]], others: &[[f64; 3]], tolerance: f64) -> Vec<Option<usize>> {
    let tree = kd::Tree::new(others);
    let (n, mut near, mut links) = (points.len(), Vec::new(), Vec::new());
    let mut sets = UnionFind::new(n + others.len());
    for (i, &p) in points.iter().enumerate() {
        tree.within(p, tolerance, &mut near);
        for &j in &near {
            sets.union(i as u32, n as u32 + j);
            links.push((i, j as usize));
        }
    }
    let mut parts: BTreeMap<u32, [Vec<usize>; 2]> = BTreeMap::new();
    for i in 0..n + others.len() {
        let part = parts.entry(sets.find(i as u32)).or_default();
        part[usize::from(i >= n)].push(if i < n { i } else { i - n });
    }
    let apart = |i: usize, j: usize| distance(points[i], others[j]);
    let mut paired = vec![None; n];
    for [ours, theirs] in parts.values().filter(|p| !p[0].is_empty() && !p[1].is_empty()) {
        if ours.len().max(theirs.len()) > MOST {
            let inside = links.iter().filter(|(i, _)| ours.binary_search(i).is_ok());
            greedy(inside.map(|&(i, j)| (apart(i, j), i, j)).collect(), &mut paired);
            continue;
        }
        // A pair beyond the tolerance costs more than all pairs within it could.
        let beyond = tolerance * (ours.len() + theirs.len()) as f64;
        let cost = |a: usize, b: usize| Some(apart(ours[a], theirs[b])).filter(|d| *d <= tolerance);
        let within = |a: usize, b: usize| cost(a, b).unwrap_or(beyond);
        let chosen: Vec<(usize, usize)> = if ours.len() <= theirs.len() {
            assign(ours.len(), theirs.len(), within).into_iter().enumerate().collect()
        } else {
            let back = assign(theirs.len(), ours.len(), |b, a| within(a, b));
            back.into_iter().enumerate().map(|(b, a)| (a, b)).collect()
        };
        let kept = chosen.into_iter().filter(|&(a, b)| cost(a, b).is_some());
        kept.for_each(|(a, b)| paired[ours[a]] = Some(theirs[b]));
    }
    paired
}

/// The nearest pair first, then the nearest of those left.
fn greedy(mut links: Vec<(f64, usize, usize)>, paired: &mut [Option<usize>]) {
    links.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut taken = std::collections::BTreeSet::new();
    for (_, i, j) in links {
        if paired[i].is_none() && taken.insert(j) {
            paired[i] = Some(j);
        }
    }
}
