//! Rings in the place of the pieces of lines along them.

use super::ground::{Ground, Ring};
use super::wall::Wall;
use crate::math::union_find::UnionFind;
use crate::math::vec3::{cross, distance, dot, norm, sub};
use crate::measure::Evidence;
use crate::neighbors::Index;
use crate::pattern::LineGraph;
use std::f64::consts::TAU;

/// Distance from a ring within which a line is it, in spacings: of any direction, and along it.
const SAME: (f64, f64) = (0.7, 1.3);
/// Least cosine between a line along a ring and the ring.
const ALONG: f64 = 0.8;
/// Length of a piece of line up to which it is taken for a false end of a ring's pieces, in spacings, and that of one that joins rings.
const STUB: (f64, f64) = (4.0, 8.0);
/// Share of a piece's vertices on walls of rings from which on it is no line.
const EXPLAINED: f64 = 0.8;
/// Fewest lines on a ring that are many, and the length of it for each, in spacings.
const MANY: (f64, f64) = (3.0, 15.0);
/// Fewest vertices of a ring.
const FEWEST: usize = 12;
/// Evidence at which a ring is as likely right as wrong.
const EVEN: f64 = 50.0;

/// No ring.
const NONE: u32 = u32::MAX;

/// Puts the rings into the graph, in the place of the lines along them; all but those on which many lines end, as the rim of a hole
/// meets none.
pub(super) fn place(lines: &mut LineGraph, mut rings: Vec<Ring>, ground: &Ground) {
    let (owner, pieces) = told_apart(lines, &rings, ground);
    let joints = pieces.joints(lines, &owner, rings.len());
    let whole = |ring: &Ring, joints: f64| {
        joints < MANY.0 || joints * MANY.1 * ring.spacing < TAU * ring.round.radius
    };
    let mut joints = joints.into_iter();
    rings.retain(|ring| joints.next().is_some_and(|n| whole(ring, n)));
    let (owner, pieces) = told_apart(lines, &rings, ground);
    let first: Vec<u32> = rings.iter().map(|ring| draw(lines, ring, ground.index)).collect();
    let ends: Vec<u32> = first.iter().skip(1).copied().chain([lines.edges.len() as u32]).collect();
    for a in 0..owner.len() {
        for b in lines.edges[a].clone().into_iter().map(|b| b as usize).filter(|&b| b < owner.len()) {
            let between = owner[a] != NONE && owner[b] != NONE;
            let stub = owner[a] == NONE && pieces.stub(a);
            if between || stub {
                lines.remove_edge(a as u32, b as u32);
            } else if owner[a] != NONE {
                let ring = owner[a] as usize;
                lines.remove_edge(a as u32, b as u32);
                if !pieces.stub(b) {
                    let nearest = nearest(lines, first[ring]..ends[ring], lines.positions[b]);
                    lines.add_edge(nearest, b as u32);
                }
            }
        }
    }
    let is_own = |v: &u32| owner.get(*v as usize).is_none_or(|&o| o == NONE);
    lines.nodes.retain(is_own);
}

/// `(V)` the ring that each vertex lies along, and the pieces of lines along none.
fn told_apart(lines: &LineGraph, rings: &[Ring], ground: &Ground) -> (Vec<u32>, Pieces) {
    let owner = owners(lines, rings);
    let explained = explained(lines, &owner, rings, ground);
    let pieces = Pieces::new(lines, &owner, rings, &explained);
    (owner, pieces)
}

/// `(V)` the ring that each vertex lies along.
fn owners(lines: &LineGraph, rings: &[Ring]) -> Vec<u32> {
    let index = Index::build(&lines.positions);
    let mut owner = vec![NONE; lines.edges.len()];
    for (r, ring) in (0..).zip(rings) {
        let (round, h) = (ring.round, ring.spacing);
        index.around(round.centre, round.radius + SAME.1 * h, |f| {
            let v = f.index as usize;
            let own = lines.positions[v];
            let foot = round.foot(own);
            let direction = cross(round.normal, sub(foot, round.centre));
            let along = |&b: &u32| {
                let d = sub(lines.positions[b as usize], own);
                dot(d, direction).abs() >= ALONG * norm(d) * norm(direction)
            };
            let off = distance(foot, own);
            let is = off <= SAME.0 * h || (off <= SAME.1 * h && lines.edges[v].iter().any(along));
            if is && owner[v] == NONE {
                owner[v] = r;
            }
        });
    }
    owner
}

/// `(V)` whether each vertex lies on the wall of a ring, where there is no fold.
fn explained(lines: &LineGraph, owner: &[u32], rings: &[Ring], ground: &Ground) -> Vec<bool> {
    let mut explained = vec![false; owner.len()];
    let index = Index::build(&lines.positions);
    for ring in rings {
        for wall in Wall::of(ring, ground) {
            let reach = wall.reach(ring);
            index.around(ring.round.centre, reach, |f| {
                let v = f.index as usize;
                explained[v] =
                    explained[v] || (owner[v] == NONE && wall.explains(ring, ground, lines.positions[v]));
            });
        }
    }
    explained
}

/// The lines along no ring, in connected pieces.
struct Pieces {
    /// `(V)` the piece of each vertex, and by it whether it is a false end.
    piece: Vec<u32>,
    stub: Vec<bool>,
}

impl Pieces {
    fn new(lines: &LineGraph, owner: &[u32], rings: &[Ring], explained: &[bool]) -> Pieces {
        let count = owner.len();
        let pairs = || {
            let lists = lines.edges.iter().enumerate();
            lists.flat_map(|(a, list)| list.iter().map(move |&b| (a, b as usize)))
        };
        let mut sets = UnionFind::new(count);
        for (a, b) in pairs().filter(|&(a, b)| owner[a] == NONE && owner[b] == NONE) {
            sets.union(a as u32, b as u32);
        }
        let piece: Vec<u32> = (0..count as u32).map(|v| sets.find(v)).collect();
        let (mut length, mut joints, mut unit) = (vec![0.0; count], vec![0; count], vec![0.0; count]);
        for (a, b) in pairs().filter(|&(a, _)| owner[a] == NONE) {
            let (own, step) = (piece[a] as usize, distance(lines.positions[a], lines.positions[b]));
            match owner[b] {
                NONE => length[own] += 0.5 * step,
                ring => {
                    length[own] += step;
                    joints[own] += 1;
                    unit[own] = rings[ring as usize].spacing;
                }
            }
        }
        let most = [0.0, STUB.0, STUB.1];
        let (mut size, mut on_wall) = (vec![0.0; count], vec![0.0; count]);
        for v in (0..count).filter(|&v| owner[v] == NONE) {
            size[piece[v] as usize] += 1.0;
            on_wall[piece[v] as usize] += f64::from(u8::from(explained[v]));
        }
        let short = |p: usize| length[p] < most[joints[p].min(2)] * unit[p];
        let stub =
            (0..count).map(|p| short(p) || on_wall[p] > 0.0 && on_wall[p] >= EXPLAINED * size[p]).collect();
        Pieces { piece, stub }
    }

    /// `(R)` the number of lines that end on each ring.
    fn joints(&self, lines: &LineGraph, owner: &[u32], rings: usize) -> Vec<f64> {
        let mut joints = vec![0.0; rings];
        for (v, list) in lines.edges.iter().enumerate().filter(|(v, _)| owner[*v] != NONE) {
            let kept = list.iter().filter(|&&b| owner[b as usize] == NONE && !self.stub(b as usize));
            joints[owner[v] as usize] += kept.count() as f64;
        }
        joints
    }

    /// Whether a vertex lies on a false end.
    fn stub(&self, v: usize) -> bool {
        self.stub[self.piece[v] as usize]
    }
}

/// Adds the vertices and edges of a ring; returns its first vertex.
fn draw(lines: &mut LineGraph, ring: &Ring, cloud: &Index) -> u32 {
    let sweep = ring.sweep();
    let count = ((TAU * ring.round.radius / ring.spacing).round() as usize).max(FEWEST);
    let first = lines.edges.len() as u32;
    let mut found = Vec::new();
    let doubt = EVEN * EVEN / (EVEN * EVEN + ring.evidence * ring.evidence);
    let [a, b] = ring.profile.faces.map(|f| f.angle);
    let between = (a - b).rem_euclid(TAU);
    let fold = (std::f64::consts::PI - between).abs() as f32;
    for k in 0..count {
        let at = sweep.point(TAU * ring.round.radius * k as f64 / count as f64);
        cloud.nearest(at, 1, &mut found);
        let v = lines.push_vertex(found.first().map_or(0, |f| f.index), at) as usize;
        lines.penalty[v] = Some(doubt as f32);
        let shown = ring.evidence as f32;
        lines.evidence[v] = Some(Evidence { sharp: shown, expected: shown, fold });
    }
    for k in 0..count as u32 {
        lines.add_edge(first + k, first + (k + 1) % count as u32);
    }
    first
}

/// The vertex of a range that is nearest to a place.
fn nearest(lines: &LineGraph, range: std::ops::Range<u32>, place: [f64; 3]) -> u32 {
    let off = |v: u32| distance(lines.positions[v as usize], place);
    range.clone().min_by(|&a, &b| off(a).total_cmp(&off(b))).unwrap_or(range.start)
}
