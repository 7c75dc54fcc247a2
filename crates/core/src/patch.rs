//! Patches: the smooth regions of the surface that the strips of a network bound, and the curve network they form.
//!
//! Demarsin et al. 2007 leave this step to the future (section 4: "a set of loops, where each loop defines the boundary of an
//! area where a patch can be fitted"). Here a patch is a connected part of the neighbour graph that no strip crosses:
//!
//! 1. `stations`: along each strip the directions in which the surface leaves it on both sides;
//! 2. `beside`: which points lie beside which strip, and on which side;
//! 3. `flood`: components of the graph over the edges that cross no strip;
//! 4. `orient`: normals that point outwards, from patch to patch over the strips;
//! 5. `area`, `fit`: a first surface of each patch;
//! 6. `sides`: the patches left and right of each strip, the fold between them;
//! 7. `loops`: strips in order round each patch.
//!
//! It takes the network of any method. Whether a patch is a whole face depends on the strips: a gap joins two faces.

mod area;
mod beside;
mod fit;
mod flood;
mod loops;
mod orient;
mod sides;
mod stations;

pub use fit::{Fit, Surface};
pub use loops::{Coedge, Loop};
pub use sides::Sides;

use crate::frame::Frame;
use crate::neighbors::Neighbors;
use crate::network::Network;
use crate::resolution::Resolution;

/// A point that belongs to no patch.
pub const NO_PATCH: u32 = u32::MAX;

/// The patches of a cloud and how they hang together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Patches {
    /// `(M)` the patch of each point, [`NO_PATCH`] for none. Canonical order; [`Extraction::patch_labels`] gives that of the
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

/// What the patches are found from: points in canonical order, local frame.
pub(crate) struct Ground<'a> {
    pub points: &'a [[f64; 3]],
    pub graph: &'a Neighbors,
    pub normals: &'a [[f32; 3]],
    pub resolution: Resolution,
}

/// The patches that the strips of `network` bound. Everything in the local frame.
pub(crate) fn patches(ground: &Ground, network: &Network) -> Patches {
    let stations = stations::stations(network, ground.resolution);
    let (stations, beside) = beside::beside(ground, stations);
    let label = flood::flood(ground, &beside);
    let count = label.iter().filter(|&&l| l != NO_PATCH).max().map_or(0, |&l| l as usize + 1);
    let area = area::areas(ground, &label, &stations, &beside);
    let normals = orient::outward(ground, &label, count, &stations, &beside, &area);
    let members = members(&label, count);
    let fits = fit::fits(ground, &normals, &members, &beside);
    let sides = sides::sides(network, &label, &normals, &stations, &beside, &fits);
    let loops = loops::loops(network, &sides, &members, &normals);
    let patches = loops.into_iter().zip(fits).enumerate().map(|(p, (loops, fit))| Patch {
        neighbors: across(&sides, p as u32),
        points: members[p].len(),
        area: members[p].iter().map(|&i| area[i as usize]).sum(),
        loops,
        fit,
    });
    Patches { patches: patches.collect(), label, sides }
}

/// The points of each patch, ascending.
fn members(label: &[u32], count: usize) -> Vec<Vec<u32>> {
    let mut members = vec![Vec::new(); count];
    for (i, &l) in label.iter().enumerate().filter(|(_, l)| **l != NO_PATCH) {
        members[l as usize].push(i as u32);
    }
    members
}

/// The patches on the other sides of the strips of patch `p`.
fn across(sides: &[Sides], p: u32) -> Vec<u32> {
    let other = |s: &Sides| match (s.left, s.right) {
        (Some(a), Some(b)) if a == p && b != p => Some(b),
        (Some(a), Some(b)) if b == p && a != p => Some(a),
        _ => None,
    };
    let mut all: Vec<u32> = sides.iter().filter_map(other).collect();
    all.sort_unstable();
    all.dedup();
    all
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

#[cfg(test)]
mod tests;
