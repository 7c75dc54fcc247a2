//! The patches of a cloud: the result.

use super::fit::Fit;
use super::ground::NO_PATCH;
use super::loops::{Coedge, Loop};
use super::sides::Sides;
use crate::frame::Frame;

/// The patches of a cloud and their adjacency.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Patches {
    /// `(M)` patch of each point, [`NO_PATCH`](super::NO_PATCH) for none; canonical order. [`Extraction::patch_labels`] has them
    /// in the order of the input.
    ///
    /// [`Extraction::patch_labels`]: crate::Extraction::patch_labels
    pub label: Vec<u32>,
    /// The patches, in the order of their first point.
    pub patches: Vec<Patch>,
    /// `(S)` sides of each strip of the network.
    pub sides: Vec<Sides>,
}

/// A smooth region of the surface.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Patch {
    /// Its boundary: the outer loop first, then the holes. Empty for a surface without boundary, such as a whole sphere.
    pub loops: Vec<Loop>,
    /// Patches across the strips of its boundary, ascending.
    pub neighbors: Vec<u32>,
    /// The number of points.
    pub points: usize,
    /// Area in the squared unit of the input: the sum of the Voronoi cells of its points, which end at the strips.
    pub area: f64,
    /// The surface that fits the points best.
    pub fit: Fit,
}

impl Patches {
    /// Those of `count` points on no surface.
    pub(crate) fn without_surface(count: usize) -> Patches {
        Patches { label: vec![NO_PATCH; count], ..Patches::default() }
    }

    /// The number of creases with two different patches beside them.
    pub fn separating(&self) -> usize {
        self.sides.iter().filter(|s| s.left.is_some() && s.right.is_some() && s.left != s.right).count()
    }

    /// The patches in the world frame: lengths, places and areas.
    pub(crate) fn placed(mut self, frame: &Frame) -> Patches {
        let unit = frame.length_to_world(1.0);
        for patch in &mut self.patches {
            patch.area *= unit * unit;
            patch.fit = patch.fit.to_world(frame);
        }
        self
    }

    /// The patches with only those strips that `stay`, numbered anew.
    pub(crate) fn of_strips(mut self, stay: &[bool]) -> Patches {
        if stay.iter().all(|&s| s) {
            return self;
        }
        let mut number = vec![None; stay.len()];
        (0..stay.len()).filter(|&s| stay[s]).enumerate().for_each(|(n, s)| number[s] = Some(n as u32));
        let mut next = stay.iter();
        self.sides.retain(|_| next.next().is_some_and(|&s| s));
        for l in self.patches.iter_mut().flat_map(|p| &mut p.loops) {
            let kept =
                l.coedges.iter().filter_map(|c| Some(Coedge { strip: number[c.strip as usize]?, ..*c }));
            l.coedges = kept.collect();
        }
        self.patches.iter_mut().for_each(|p| p.loops.retain(|l| !l.coedges.is_empty()));
        self
    }
}
