//! What a tile gives to its caller: the measure of its own points.

use crate::measure::{Measure, Penalties, Row};
use crate::prepare::Prepared;

/// The measure of a tile's own points; points are known by their indices in the input.
#[derive(Clone, Debug, Default)]
pub struct Found {
    /// `(M)` own points on surfaces, in canonical order, as indices of the input.
    pub source: Vec<u32>,
    /// `(M, 3)` their positions in the local frame of the whole cloud, and the spacing at each; empty if the mean holds everywhere.
    pub(super) position: Vec<[f64; 3]>,
    pub(super) spacing: Vec<f32>,
    /// `(M)` sampling density, evidence of a feature, and normal of each, as in [`Measure`](crate::Measure).
    pub density: Vec<f32>,
    /// See `density`.
    pub score: Vec<f32>,
    /// `(M, 3)` unit normals without orientation.
    pub normal: Vec<[f32; 3]>,
    /// Candidates of creases among them, with their penalties, local frame of the whole cloud.
    pub crease: Vec<(u32, Row)>,
    /// Candidates of borders.
    pub border: Vec<(u32, Row)>,
}

impl Found {
    pub(super) fn new(cloud: &Prepared, measure: &Measure, owned: &[bool]) -> Found {
        let own = || (0..owned.len()).filter(|&i| owned[i]);
        Found {
            source: own().map(|i| cloud.source[i]).collect(),
            position: own().map(|i| cloud.positions[i]).collect(),
            spacing: own().filter_map(|i| cloud.spacing_at(i)).collect(),
            density: own().map(|i| measure.density[i]).collect(),
            score: own().map(|i| measure.score[i]).collect(),
            normal: own().map(|i| measure.normal[i]).collect(),
            crease: rows(&measure.crease, cloud, owned),
            border: rows(&measure.border, cloud, owned),
        }
    }
}

/// A tile's own candidates, as indices of the input.
pub(super) fn rows(penalties: &Penalties, cloud: &Prepared, owned: &[bool]) -> Vec<(u32, Row)> {
    let own = (0..penalties.len()).filter(|&c| owned[penalties.points[c] as usize]);
    own.map(|c| (cloud.source[penalties.points[c] as usize], penalties.row(c))).collect()
}
