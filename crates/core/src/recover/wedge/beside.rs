//! The strip nearest to each point, and the face of it on which the point lies: what keeps the points of other faces out of a fit.
//!
//! The paper groups the points around a junction by votes along all its strips; away from the junction each strip has its own groups.
//! Here every point belongs to the strip that is nearest, so that beside a junction the points of faces that do not meet in a
//! strip are left to the strips that bound these.

use super::vote::Side;
use crate::math::vec3::{distance2, dot, sub};
use crate::neighbors::Index;
use crate::network::{Network, Strip};
use crate::parallel;
use crate::patch::Ground;

/// Distance from a strip up to which points are beside it, units of the place.
const REACH: f64 = 3.5;
/// No strip, or no side.
const NONE: u32 = u32::MAX;

/// Where a point lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::recover) struct Beside {
    /// The nearest strip; `u32::MAX` for none within reach.
    pub strip: u32,
    /// Distance from it, in the unit of the points; infinite for none.
    pub distance: f64,
    /// The group of the point among those of the strip; `u32::MAX` where the votes leave it open.
    pub side: u32,
    /// Whether the point lies beside the strip rather than beyond one of its ends.
    pub within: bool,
}

impl Beside {
    const NOWHERE: Beside = Beside { strip: NONE, distance: f64::INFINITY, side: NONE, within: false };

    /// Whether the side is known.
    pub(super) fn has_side(&self) -> bool {
        self.side != NONE
    }

    /// Whether the point lies on this face of this strip, at least `clear` from it.
    pub(super) fn is_on(&self, strip: u32, side: usize, clear: f64) -> bool {
        self.strip == strip && self.side == side as u32 && self.within && self.distance >= clear
    }
}

/// `(N)` where each point lies. `sides` are the groups beside each strip, by point; none of borders.
pub(in crate::recover) fn beside(network: &Network, sides: &[Vec<Side>], ground: &Ground) -> Vec<Beside> {
    let strips = &network.strips;
    let (mut places, mut of) = (Vec::new(), Vec::new());
    for (s, strip) in strips.iter().enumerate() {
        places.extend_from_slice(&strip.points);
        of.extend((0..strip.points.len()).map(|k| (s as u32, k)));
    }
    let index = Index::build(&places);
    parallel::map(ground.points.len(), parallel::QUICK, |i| {
        let p = ground.points[i];
        let mut best = (f64::INFINITY, NONE);
        index.around(p, REACH * ground.scales.unit(i as u32), |found| {
            if (found.distance2, found.index) < best {
                best = (found.distance2, found.index);
            }
        });
        let Some(&(s, k)) = of.get(best.1 as usize) else { return Beside::NOWHERE };
        let (distance, within) = place(&strips[s as usize], k, p);
        let list = &sides[s as usize];
        let side =
            list.binary_search_by_key(&(i as u32), |x| x.point).map_or(NONE, |at| list[at].side as u32);
        Beside { strip: s, distance, side, within }
    })
}

/// The distance of a point from a strip, next to whose point `k` it lies, and whether it lies between the ends.
fn place(strip: &Strip, k: usize, p: [f64; 3]) -> (f64, bool) {
    let points = &strip.points;
    let n = points.len();
    let next = if k + 1 < n { Some(k + 1) } else { strip.closed.then_some(0) };
    let before = if k > 0 { Some(k - 1) } else { strip.closed.then_some(n - 1) };
    let (mut least, mut within) = (distance2(p, points[k]), false);
    for other in [before, next].into_iter().flatten() {
        let (way, d) = (sub(points[other], points[k]), sub(p, points[k]));
        let along = dot(d, way) / dot(way, way).max(f64::MIN_POSITIVE);
        if along > 0.0 {
            within = true;
            least = least.min(dot(d, d) - along.min(1.0).powi(2) * dot(way, way));
        }
    }
    (least.max(0.0).sqrt(), within || before.is_some() && next.is_some())
}
