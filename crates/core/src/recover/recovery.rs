//! What the recovery of creases and corners found, for viewers (Gumhold 2001, figures 10 and 11).

use super::corner::{Corner, Grouping};
use super::wedge::{Recovered, Side};

/// The groups and the recovered places, canonical indices, local frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recovery {
    /// The points beside the strips, strip by strip, by index within each; one that lies beside two strips stands twice.
    pub beside: Vec<Grouped>,
    /// The points around the junctions, node by node; empty in the form `quadric`, which has no groups there.
    pub around: Vec<Grouped>,
    /// The crease points strip by strip, in order, then the corners node by node.
    pub places: Vec<RecoveredPlace>,
}

/// A point that was told to lie on one of the faces that meet in a strip or at a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grouped {
    /// The strip, or the node.
    pub of: u32,
    /// The point.
    pub point: u32,
    /// Its face: 0 or 1 beside a strip, 0 to `k - 1` around a junction of `k` creases.
    pub face: u32,
}

/// A place on a crease, or a corner, where faces meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RecoveredPlace {
    /// The strip; `None` for a corner.
    pub strip: Option<u32>,
    /// The node; `None` for a place on a crease.
    pub node: Option<u32>,
    /// The place.
    pub at: [f64; 3],
    /// Its standard deviation on each axis, from the fits of the faces.
    pub sigma: [f64; 3],
    /// Angle by which the faces fold, degrees; `None` for a corner.
    pub fold_deg: Option<f64>,
}

/// What one pass found, canonical indices, local frame.
pub(crate) struct Pass {
    /// `(S)` the groups of the points beside each strip.
    pub(super) sides: Vec<Vec<Side>>,
    /// The groups of the points around junctions, with the node of each; none in the form `quadric`, which has no such groups.
    pub(super) around: Vec<(usize, Grouping)>,
    /// `(S)` the crease points of each strip; none where too few could be recovered.
    pub(super) found: Vec<Vec<Recovered>>,
    /// `(N)` the corners.
    pub(super) corners: Vec<Option<Corner>>,
}

impl From<Pass> for Recovery {
    fn from(pass: Pass) -> Self {
        let sides = pass.sides.iter().zip(0..);
        let beside = sides.flat_map(|(sides, of)| {
            sides.iter().map(move |s| Grouped { of, point: s.point, face: s.side as u32 })
        });
        let around = pass.around.iter().flat_map(|(node, grouping)| {
            let faces = grouping.points.iter().zip(&grouping.group);
            faces.map(|(&point, &face)| Grouped { of: *node as u32, point, face: face as u32 })
        });
        let places = pass.found.iter().zip(0..).flat_map(|(found, strip)| {
            found.iter().map(move |place| RecoveredPlace {
                strip: Some(strip),
                node: None,
                at: place.at,
                sigma: deviations(&place.covariance),
                fold_deg: Some(place.fold.to_degrees()),
            })
        });
        let corners = pass.corners.iter().zip(0..).filter_map(|(corner, node)| {
            let corner = corner.as_ref()?;
            let sigma = deviations(&corner.covariance);
            Some(RecoveredPlace { strip: None, node: Some(node), at: corner.at, sigma, fold_deg: None })
        });
        Recovery {
            beside: beside.collect(),
            around: around.collect(),
            places: places.chain(corners).collect(),
        }
    }
}

/// The standard deviations on the axes.
pub(super) fn deviations(covariance: &[[f64; 3]; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| covariance[k][k].max(0.0).sqrt())
}
