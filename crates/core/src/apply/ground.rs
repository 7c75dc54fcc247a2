//! The surface of a result: the points in the local frame with the graph, the scales and the network of an extraction.

use crate::extract::Extraction;
use crate::neighbors::{Neighbors, all_nearest, riemannian};
use crate::network::{Network, Strip};
use crate::params::Params;
use crate::patch::Ground;
use crate::resolution::Resolution;
use crate::surface::{Scales, evened, spacings};

/// The points on surfaces in canonical order, all in the local frame. An extraction keeps neither positions nor graph, which are
/// the greater part of its memory and made anew in a fraction of its time.
pub(super) struct Terrain<'a> {
    found: &'a Extraction,
    /// `(M, 3)` positions.
    pub(super) positions: Vec<[f64; 3]>,
    /// The Riemannian graph.
    pub(super) graph: Neighbors,
    /// The strips with their points and their sources, canonical indices; no nodes, no curves.
    pub(super) network: Network,
    spacing: Vec<f32>,
    pub(super) resolution: Resolution,
}

impl<'a> Terrain<'a> {
    /// Of `world`, the `(N, 3)` positions that `found` was extracted from by `params`.
    pub(super) fn new(world: &[[f64; 3]], found: &'a Extraction, params: &Params) -> Self {
        let frame = &found.frame;
        let positions: Vec<[f64; 3]> = found
            .source
            .iter()
            .map(|&i| frame.to_local(world.get(i as usize).copied().unwrap_or_default()))
            .collect();
        let nearest = all_nearest(&positions, params.neighbors.k);
        let unit = frame.length_to_world(1.0);
        let resolution =
            Resolution { spacing: found.report.spacing / unit, noise: found.report.noise / unit };
        let spacing = evened(&spacings(&positions, &nearest), resolution);
        let graph = riemannian::graph(&positions, &nearest);
        Terrain { found, positions, graph, network: local(found), spacing, resolution }
    }

    /// The spacing at every point.
    pub(super) fn scales(&self) -> Scales<'_> {
        Scales::new(self.resolution, &self.spacing)
    }

    /// As patches take it.
    pub(super) fn ground(&self) -> Ground<'_> {
        let normals = &self.found.measure.normal;
        Ground { points: &self.positions, graph: &self.graph, normals, scales: self.scales() }
    }
}

/// The strips of a result in the local frame.
fn local(found: &Extraction) -> Network {
    let canonical = |i: &u32| found.canonical.get(*i as usize).copied().filter(|&c| c != u32::MAX);
    let strip = |strip: &Strip| Strip {
        points: strip.points.iter().map(|&p| found.frame.to_local(p)).collect(),
        sources: strip.sources.iter().filter_map(canonical).collect(),
        curve: Default::default(),
        curves: Vec::new(),
        ..strip.clone()
    };
    Network { nodes: Vec::new(), strips: found.network.on_surface().strips.iter().map(strip).collect() }
}
