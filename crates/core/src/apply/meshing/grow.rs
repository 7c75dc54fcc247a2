//! A manifold out of Delaunay triangles: D. Cohen-Steiner and F. Da, "A greedy Delaunay-based surface reconstruction algorithm",
//! The Visual Computer 20, 2004.
//!
//! The surface grows from a triangle over the edges of its border. The candidate of an edge is the triangle at it with the least
//! empty sphere that leaves the surface a manifold; of all candidates, those that hardly turn go first, by their spheres, then
//! the others by their turn. So the faces fill before the surface turns over a crease.
//!
//! Triangles that join two sides of a line stay out. Near corners it is not always known on which side a point lies, though, and a
//! gap may be left; at the end those triangles fill it that go on from the face beside them without a turn.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::filters::Candidate;
use super::surface_mesh::edges;
use crate::delaunay::Facet;
use crate::math::vec3::{add, cross, dot, sub, unit};

/// Turn up to which a candidate is as good as its sphere is small, degrees.
const FLAT_DEG: f64 = 30.0;
/// Greatest turn of a candidate, degrees.
const MOST_TURN_DEG: f64 = 160.0;
/// No triangle.
const NONE: u32 = u32::MAX;

/// The place of an edge on the surface.
#[derive(Clone, Copy)]
struct Border {
    /// Number of triangles on the surface, 0 to 2.
    uses: u8,
    /// The first of them.
    triangle: u32,
}

/// A candidate on the queue: the greatest goes first.
#[derive(Clone, Copy, PartialEq)]
struct Entry {
    grade: f64,
    edge: u32,
    facet: u32,
}

impl Eq for Entry {}

impl Ord for Entry {
    fn cmp(&self, other: &Self) -> Ordering {
        self.grade.total_cmp(&other.grade).then(other.edge.cmp(&self.edge)).then(other.facet.cmp(&self.facet))
    }
}

impl PartialOrd for Entry {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The triangles of a manifold, turned alike within each connected part. `folded` says which points may lie on a fold.
pub(super) fn grow(
    points: &[[f64; 3]],
    facets: &[Candidate],
    folded: impl Fn(usize) -> bool,
) -> Vec<[u32; 3]> {
    let mut growth = Growth::new(points, facets);
    let mut seeds: Vec<u32> = (0..facets.len() as u32).filter(|&f| growth.seeds(f)).collect();
    seeds.sort_by(|&a, &b| growth.radius(a).total_cmp(&growth.radius(b)));
    for seed in seeds {
        let corners = facets[seed as usize].facet.corners;
        if corners.iter().all(|&c| !growth.reached[c as usize]) {
            growth.add(seed, corners);
            growth.advance(&folded);
        }
    }
    growth.last = true;
    growth.queue_border();
    growth.advance(&folded);
    growth.triangles
}

struct Growth<'a> {
    points: &'a [[f64; 3]],
    facets: &'a [Candidate],
    /// All edges, ascending.
    edges: Vec<[u32; 2]>,
    /// `(E + 1)` beginning of each edge's triangles in `at`, which has them by their radius.
    first: Vec<usize>,
    at: Vec<u32>,
    border: Vec<Border>,
    used: Vec<bool>,
    /// Whether a point is on the surface, the number of border edges at it, and the sum of the normals of its triangles.
    reached: Vec<bool>,
    open: Vec<u32>,
    normal: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    queue: BinaryHeap<Entry>,
    /// Whether triangles that join two sides of a line may fill what is left.
    last: bool,
}

impl<'a> Growth<'a> {
    fn new(points: &'a [[f64; 3]], facets: &'a [Candidate]) -> Self {
        let mut all: Vec<([u32; 2], f64, u32)> = Vec::with_capacity(3 * facets.len());
        for (f, facet) in facets.iter().enumerate() {
            all.extend(edges(&facet.facet.corners).map(|edge| (edge, facet.facet.radius, f as u32)));
        }
        all.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
        let mut edges: Vec<[u32; 2]> = all.iter().map(|a| a.0).collect();
        edges.dedup();
        let mut first: Vec<usize> = (0..all.len()).filter(|&k| k == 0 || all[k].0 != all[k - 1].0).collect();
        first.push(all.len());
        Growth {
            points,
            facets,
            border: vec![Border { uses: 0, triangle: NONE }; edges.len()],
            edges,
            first,
            at: all.into_iter().map(|a| a.2).collect(),
            used: vec![false; facets.len()],
            reached: vec![false; points.len()],
            open: vec![0; points.len()],
            normal: vec![[0.0; 3]; points.len()],
            triangles: Vec::new(),
            queue: BinaryHeap::new(),
            last: false,
        }
    }

    /// Whether the surface may grow from a triangle.
    fn seeds(&self, facet: u32) -> bool {
        self.facets[facet as usize].facet.gabriel && !self.facets[facet as usize].across
    }

    fn radius(&self, facet: u32) -> f64 {
        self.facets[facet as usize].facet.radius
    }

    /// Puts all edges of the border on the queue.
    fn queue_border(&mut self) {
        let open = (0..self.edges.len()).filter(|&edge| self.border[edge].uses == 1);
        self.queue.extend(open.map(|edge| Entry { grade: f64::INFINITY, edge: edge as u32, facet: NONE }));
    }

    /// Adds triangles until no edge has a candidate.
    fn advance(&mut self, folded: &impl Fn(usize) -> bool) {
        while let Some(entry) = self.queue.pop() {
            let Some((now, corners)) = self.candidate(entry.edge, folded) else { continue };
            if now == entry {
                self.add(now.facet, corners);
            } else {
                self.queue.push(now);
            }
        }
    }

    /// Puts a triangle on the surface.
    fn add(&mut self, facet: u32, corners: [u32; 3]) {
        let number = self.triangles.len() as u32;
        self.triangles.push(corners);
        self.used[facet as usize] = true;
        let normal = self.normal_of(corners);
        for k in 0..3 {
            let (from, to) = (corners[k], corners[(k + 1) % 3]);
            self.reached[from as usize] = true;
            self.normal[from as usize] = add(self.normal[from as usize], normal);
            let Some(edge) = self.edge(from, to) else { continue };
            let border = &mut self.border[edge];
            border.uses += 1;
            let opened = border.uses == 1;
            if opened {
                border.triangle = number;
                // Looked up when its turn comes; until then it is as good as can be.
                self.queue.push(Entry { grade: f64::INFINITY, edge: edge as u32, facet: NONE });
            }
            for end in [from, to] {
                let open = &mut self.open[end as usize];
                *open = if opened { *open + 1 } else { *open - 1 };
            }
        }
    }

    fn edge(&self, a: u32, b: u32) -> Option<usize> {
        self.edges.binary_search(&[a.min(b), a.max(b)]).ok()
    }

    fn normal_of(&self, corners: [u32; 3]) -> [f64; 3] {
        let [a, b, c] = corners.map(|i| self.points[i as usize]);
        unit(cross(sub(b, a), sub(c, a)))
    }

    /// The best triangle that can follow at a border edge, with its corners turned like the surface.
    fn candidate(&self, edge: u32, folded: &impl Fn(usize) -> bool) -> Option<(Entry, [u32; 3])> {
        let Border { uses: 1, triangle } = self.border[edge as usize] else { return None };
        let corners = self.triangles[triangle as usize];
        let ends = self.edges[edge as usize];
        let k = (0..3).find(|&k| !ends.contains(&corners[(k + 2) % 3]))?;
        // The new triangle runs along the edge the other way.
        let (from, to) = (corners[(k + 1) % 3], corners[k]);
        let normal = self.normal_of(corners);
        for &facet in &self.at[self.first[edge as usize]..self.first[edge as usize + 1]] {
            let Candidate { facet: Facet { corners: of_facet, radius, .. }, across } =
                self.facets[facet as usize];
            let Some(&tip) =
                of_facet.iter().find(|c| !ends.contains(c)).filter(|_| !self.used[facet as usize])
            else {
                continue;
            };
            let new = [from, to, tip];
            let own = self.normal_of(new);
            let turn = dot(normal, own).clamp(-1.0, 1.0).acos();
            let flat = turn <= FLAT_DEG.to_radians();
            let may = if across { self.last && flat } else { turn <= MOST_TURN_DEG.to_radians() };
            if !may || !self.fits(new, own, folded) {
                continue;
            }
            let grade = if flat { 1.0 / radius } else { -turn };
            return Some((Entry { grade, edge, facet }, new));
        }
        None
    }

    /// Whether the surface stays a manifold with a triangle over its first edge.
    fn fits(&self, [from, to, tip]: [u32; 3], normal: [f64; 3], folded: &impl Fn(usize) -> bool) -> bool {
        if !self.reached[tip as usize] {
            return true;
        }
        if self.open[tip as usize] == 0 {
            return false;
        }
        let mut shared = 0;
        for (a, b) in [(to, tip), (tip, from)] {
            let Some(edge) = self.edge(a, b) else { return false };
            let Border { uses, triangle } = self.border[edge];
            if uses == 1 {
                let corners = self.triangles[triangle as usize];
                // Turned alike, the triangle that is there runs along the edge the other way.
                let along = (0..3).any(|k| corners[k] == a && corners[(k + 1) % 3] == b);
                if along {
                    return false;
                }
                shared += 1;
            } else if uses > 1 {
                return false;
            }
        }
        shared > 0 || folded(tip as usize) || dot(self.normal[tip as usize], normal) > 0.0
    }
}
