//! The vertices of a mesh: points on the lines, and the points of the cloud that do not lie beside them.
//!
//! Two neighbours on a line are joined by an edge of the Gabriel complex if no other point lies in the sphere between them. So
//! the points of the cloud that lie as near to a line give way to those on it.

use std::collections::BTreeMap;

use crate::apply::enrich::along_lines;
use crate::apply::ground::Terrain;
use crate::extract::Extraction;
use crate::math::vec3::distance;
use crate::measure::Class;
use crate::neighbors::{all_nearest, riemannian};
use crate::params::Params;
use crate::patch::{Crossing, Ground};
use crate::surface::{Scales, evened, spacings};

/// Distance from a line within which points of the cloud give way, as a share of the step between those on it.
const ASIDE: f64 = 0.6;
/// Least distance between two points on lines, as a share of the step.
const APART: f64 = 0.5;

/// The vertices, local frame.
pub(super) struct Vertices {
    pub(super) points: Vec<[f64; 3]>,
    pub(super) kinds: Vec<Class>,
    /// The strips that each vertex lies on, from the first on a line on.
    on: Vec<Vec<u32>>,
}

impl Vertices {
    /// Of a cloud, and of its lines with a point every `step` spacings.
    pub(super) fn new(terrain: &Terrain, found: &Extraction, step: Option<f64>) -> Vertices {
        let all = &terrain.positions;
        let (Some(step), false) = (step, terrain.network.strips.is_empty()) else {
            return Vertices { points: all.clone(), kinds: vec![Class::Smooth; all.len()], on: Vec::new() };
        };
        let crossing = Crossing::new(&terrain.ground(), &terrain.network);
        let aside = |&i: &usize| crossing.clearance(i) > ASIDE * step * terrain.scales().at(i).spacing;
        let mut points: Vec<[f64; 3]> = (0..all.len()).filter(aside).map(|i| all[i]).collect();
        let mut kinds = vec![Class::Smooth; points.len()];
        let mut on = Vec::new();
        let mut taken = Taken::new(APART * step * terrain.resolution.spacing);
        for point in along_lines(terrain, found, step) {
            let place = found.frame.to_local(point.position);
            if taken.take(place) {
                points.push(place);
                kinds.push(point.kind);
                on.push(point.strips);
            }
        }
        Vertices { points, kinds, on }
    }

    /// On which sides of the lines the vertices lie; `None` without lines.
    pub(super) fn crossing(&self, terrain: &Terrain, params: &Params) -> Option<Crossing> {
        if terrain.network.strips.is_empty() {
            return None;
        }
        let nearest = all_nearest(&self.points, params.neighbors.k);
        let spacing = evened(&spacings(&self.points, &nearest), terrain.resolution);
        let graph = riemannian::graph(&self.points, &nearest);
        let scales = Scales::new(terrain.resolution, &spacing);
        let ground = Ground { points: &self.points, graph: &graph, normals: &[], scales };
        let mut crossing = Crossing::lenient(&ground, &terrain.network);
        let first = self.points.len() - self.on.len();
        crossing.put_on(self.on.iter().enumerate().map(|(k, strips)| (first + k, strips.as_slice())));
        Some(crossing)
    }
}

/// Points that are some distance apart.
struct Taken {
    apart: f64,
    cells: BTreeMap<[i64; 3], Vec<[f64; 3]>>,
}

impl Taken {
    fn new(apart: f64) -> Self {
        Taken { apart, cells: BTreeMap::new() }
    }

    /// Takes a point unless one is nearer than they may be.
    fn take(&mut self, p: [f64; 3]) -> bool {
        let cell = p.map(|c| (c / self.apart).floor() as i64);
        for around in 0..27 {
            let at = [cell[0] + around % 3 - 1, cell[1] + around / 3 % 3 - 1, cell[2] + around / 9 - 1];
            if self.cells.get(&at).is_some_and(|there| there.iter().any(|&q| distance(p, q) < self.apart)) {
                return false;
            }
        }
        self.cells.entry(cell).or_default().push(p);
        true
    }
}
