//! Points moved onto several surfaces.

use crate::math::vec3::{add_scaled, cross, dot, norm, scale, sub};
use crate::network::Network;
use crate::patch::fit::Surface;
use crate::patch::patches::Patches;

/// Steps of Gauss and Newton at most, and the share of a place's size below which a step ends them.
const STEPS: usize = 40;
const ROUNDING: f64 = 1e-15;
/// Shares of extent and coordinates that rounding leaves.
const OF_EXTENT: f64 = 1e-9;
const OF_COORDINATES: f64 = 1e-14;
/// Weight of staying against lying on the surfaces, in each step: surfaces that touch move a point along them by little at a time.
const STAY: f64 = 1e-3;

/// The point near `p` that lies on all of the surfaces, or nearest to them where there is none.
pub(super) fn meet(mut p: [f64; 3], surfaces: &[Surface]) -> [f64; 3] {
    for _ in 0..STEPS {
        let mut rows = [0, 1, 2].map(|k| std::array::from_fn(|j| if j == k { STAY } else { 0.0 }));
        let mut right = [0.0; 3];
        for surface in surfaces {
            let (n, d) = (surface.normal(p), surface.distance(p));
            for (row, along) in rows.iter_mut().zip(n) {
                *row = add_scaled(*row, n, along);
            }
            right = add_scaled(right, n, -d);
        }
        let step = solved(rows, right);
        p = add_scaled(p, step, 1.0);
        if norm(step) <= ROUNDING * norm(p) {
            break;
        }
    }
    p
}

/// The solution of a symmetric system of three equations that has one.
fn solved([a, b, c]: [[f64; 3]; 3], right: [f64; 3]) -> [f64; 3] {
    let bc = cross(b, c);
    let sum = add_scaled(scale(bc, right[0]), cross(c, a), right[1]);
    scale(add_scaled(sum, cross(a, b), right[2]), 1.0 / dot(a, bc))
}

/// The vertices of a boundary representation as they are found.
pub(super) struct Vertices {
    pub positions: Vec<[f64; 3]>,
    /// The vertex of each node.
    of_node: Vec<Option<u32>>,
    /// `(S)` the surfaces beside each strip, and `(N)` those around each node.
    sides: Vec<Vec<(u32, Surface)>>,
    around: Vec<Vec<(u32, Surface)>>,
    nodes: Vec<[f64; 3]>,
    residuals: Vec<f64>,
}

impl Vertices {
    pub fn new(network: &Network, patches: &Patches, chosen: &[u32]) -> Self {
        let mut sides: Vec<Vec<(u32, Surface)>> = vec![Vec::new(); network.strips.len()];
        let mut around: Vec<Vec<(u32, Surface)>> = vec![Vec::new(); network.nodes.len()];
        for &p in chosen {
            let patch = &patches.patches[p as usize];
            let own = (p, patch.fit.surface);
            for coedge in patch.loops.iter().flat_map(|l| &l.coedges) {
                let strip = &network.strips[coedge.strip as usize];
                sides[coedge.strip as usize].push(own);
                for node in [strip.start, strip.end].into_iter().flatten() {
                    let around = &mut around[node as usize];
                    if !around.iter().any(|other| other.0 == p) {
                        around.push(own);
                    }
                }
            }
        }
        Self {
            positions: Vec::new(),
            of_node: vec![None; network.nodes.len()],
            sides,
            around,
            nodes: network.nodes.iter().map(|n| n.position).collect(),
            residuals: patches.patches.iter().map(|p| p.fit.residual).collect(),
        }
    }

    /// The surfaces beside a strip.
    pub fn beside(&self, strip: u32) -> Vec<Surface> {
        self.sides[strip as usize].iter().map(|side| side.1).collect()
    }

    /// The greatest distance of points from a surface beside a strip, root mean square.
    pub fn residual(&self, strip: u32) -> f64 {
        self.sides[strip as usize].iter().map(|side| self.residuals[side.0 as usize]).fold(0.0, f64::max)
    }

    /// The vertex of a node, where the surfaces around it meet.
    pub fn of_node(&mut self, node: u32) -> u32 {
        let n = node as usize;
        if let Some(vertex) = self.of_node[n] {
            return vertex;
        }
        let surfaces: Vec<Surface> = self.around[n].iter().map(|own| own.1).collect();
        let vertex = self.add(meet(self.nodes[n], &surfaces));
        self.of_node[n] = Some(vertex);
        vertex
    }

    pub fn add(&mut self, at: [f64; 3]) -> u32 {
        self.positions.push(at);
        self.positions.len() as u32 - 1
    }

    pub fn at(&self, vertex: u32) -> [f64; 3] {
        self.positions[vertex as usize]
    }
}

/// The greatest distance of a point from the surfaces.
pub(super) fn off(p: [f64; 3], surfaces: &[Surface]) -> f64 {
    surfaces.iter().map(|s| s.distance(p).abs()).fold(0.0, f64::max)
}

/// The points between two, evenly, both left out.
pub(super) fn between(a: [f64; 3], b: [f64; 3], count: usize) -> impl Iterator<Item = [f64; 3]> {
    let along = sub(b, a);
    (1..count).map(move |k| add_scaled(a, along, k as f64 / count as f64))
}

/// A point on the axis of a surface, and its direction; `None` for planes and spheres.
pub(super) fn axis(surface: &Surface) -> Option<([f64; 3], [f64; 3])> {
    match *surface {
        Surface::Cylinder { point, axis, .. } => Some((point, axis)),
        Surface::Cone { apex, axis, .. } => Some((apex, axis)),
        Surface::Torus { center, axis, .. } => Some((center, axis)),
        Surface::Plane { .. } | Surface::Sphere { .. } => None,
    }
}

/// The part of the way from an axis to a point that is across the axis.
pub(super) fn radial((on, axis): ([f64; 3], [f64; 3]), p: [f64; 3]) -> [f64; 3] {
    let d = sub(p, on);
    add_scaled(d, axis, -dot(d, axis))
}

/// What rounding leaves between places: a share of their extent, and of their coordinates, which on maps are far greater.
pub(super) fn rounding(points: &[[f64; 3]]) -> f64 {
    let of = |pick: fn(f64, f64) -> f64, k: usize| points.iter().map(|p| p[k]).reduce(pick).unwrap_or(0.0);
    let sides = (0..3).map(|k| of(f64::max, k) - of(f64::min, k)).fold(0.0, f64::max);
    let most = points.iter().flatten().fold(0.0, |most: f64, c| most.max(c.abs()));
    OF_EXTENT * sides + OF_COORDINATES * most
}
