//! Gaps that have samples in them, bridged.
//!
//! Points strewn at random, and faces cut near their rim, leave stretches of a curve whose samples are too few, or too much to
//! one side of the plane, to agree on nodes. They do not show how the curve runs, but they show that the surface goes on:
//! two loose ends are joined over them, while the ends at a border of the surface, with nothing between them, stay.

use super::end::{End, Joint, corner};
use crate::math::trees::packed::Packed;
use crate::math::vec2::{along, distance, dot, local, sub, unit};
use crate::section::surface::carry::Sample;

/// Greatest distance of a sample from each place of a bridge, along and across it, local spacings.
const SUPPORT_REACH: (f64, f64) = (1.0, 0.6);
/// Least cosine between a bridge and the curve as a sample on it has it.
const ALONG_COSINE: f64 = 0.7;

/// The samples of a slab, a tree over their feet, and how far they lead.
pub(crate) struct Support<'a> {
    pub samples: &'a [Sample],
    pub tree: &'a Packed,
    /// Longest bridge, in local spacings.
    pub longest: f64,
}

impl Support<'_> {
    /// A bridge between two ends: straight, or by the corner in which their straight continuations meet.
    pub(crate) fn joint(&self, ends: &[End], a: usize, b: usize) -> Option<Joint> {
        let (e, f) = (&ends[a], &ends[b]);
        let spacing = 0.5 * (e.spacing + f.spacing);
        let bridge = |corner: Option<[f64; 2]>| {
            let path: Vec<[f64; 2]> = [Some(e.at), corner, Some(f.at)].into_iter().flatten().collect();
            let length: f64 = path.windows(2).map(|w| distance(w[0], w[1])).sum();
            let holds = || path.windows(2).all(|w| self.holds(w[0], w[1], spacing));
            (length <= self.longest * spacing && holds()).then(|| Joint {
                cost: length / spacing,
                a,
                b,
                corner,
            })
        };
        bridge(None).or_else(|| bridge(Some(corner(e, f, spacing)?)))
    }

    /// Whether samples lie all along a straight stretch; the parts beside its ends and corners are taken for granted.
    fn holds(&self, from: [f64; 2], to: [f64; 2], spacing: f64) -> bool {
        let (length, way) = (distance(from, to), unit(sub(to, from)));
        let mut found = Vec::new();
        let steps = (length / spacing).ceil().max(1.0);
        (0..=steps as usize).all(|k| {
            let at = length * k as f64 / steps;
            at.min(length - at) < SUPPORT_REACH.0 * spacing || {
                let place = along(from, way, at);
                self.tree.within(place, SUPPORT_REACH.0 * spacing, &mut found);
                found.iter().map(|&i| &self.samples[i as usize]).any(|s| {
                    let (_, across) = local(way, place, s.foot);
                    across.abs() <= SUPPORT_REACH.1 * spacing && dot(s.tangent, way).abs() >= ALONG_COSINE
                })
            }
        })
    }
}
