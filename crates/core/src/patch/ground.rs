//! The ground: the cloud on which patches are found.

use crate::neighbors::Neighbors;
use crate::surface::Scales;

/// The label of a point in no patch.
pub const NO_PATCH: u32 = u32::MAX;

/// A cloud: points in canonical order, local frame.
pub(crate) struct Ground<'a> {
    pub points: &'a [[f64; 3]],
    pub graph: &'a Neighbors,
    pub normals: &'a [[f32; 3]],
    pub scales: Scales<'a>,
}
