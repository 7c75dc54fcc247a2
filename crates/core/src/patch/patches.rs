//! The patches of a cloud, as they are handed out.

use super::fit::Fit;
use super::loops::{Coedge, Loop};
use super::sides::Sides;
use crate::frame::Frame;

/// The patches of a cloud and how they hang together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Patches {
    /// `(M)` the patch of each point, [`NO_PATCH`](super::NO_PATCH) for none. Canonical order; [`Extraction::patch_labels`] gives that of the
    /// input.
    ///
    /// [`Extraction::patch_labels`]: crate::Extraction::patch_labels
    pub label: Vec<u32>,
    /// The patches, in the order of their first point.
    pub patches: Vec<Patch>,
    /// `(S)` for each strip of the network what lies beside it.
    pub sides: Vec<Sides>,
}

/// A smooth region of the surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    /// Its boundary: the outer loop first, then the holes. Empty for a surface without any, such as a whole sphere.
    pub loops: Vec<Loop>,
    /// Patches across the strips of its boundary, ascending.
    pub neighbors: Vec<u32>,
    /// The number of points.
    pub points: usize,
    /// Area in the squared unit of the input: that of the Voronoi cells of its points, which end at the strips.
    pub area: f64,
    /// The surface that suits the points best.
    pub fit: Fit,
}

impl Patches {
    /// The number of creases with two different patches beside them.
    pub fn separating(&self) -> usize {
        self.sides.iter().filter(|s| s.left.is_some() && s.right.is_some() && s.left != s.right).count()
    }

    /// Lengths, places and areas from the local frame to the world.
    pub(crate) fn placed(mut self, frame: &Frame) -> Patches {
        let unit = frame.length_to_world(1.0);
        for patch in &mut self.patches {
            patch.area *= unit * unit;
            patch.fit = patch.fit.to_world(frame);
        }
        self
    }

    /// What remains when only some strips `stay`, numbered anew.
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
