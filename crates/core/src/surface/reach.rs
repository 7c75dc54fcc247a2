//! What the stage reads: which of its results for a part of a cloud are those of the whole cloud.
//!
//! Lists of nearest neighbours are read over nine steps at most: planes one, spacings two, support and gaps one more, crowds and the points deep
//! in them two, the rounds in which clutter grows three. Searches beside them end at 4 and, in rows, 12 spacings. Two rules
//! read more. A crowd is judged as a whole, so that its verdict comes from outside (`crowds`). And a place that is
//! thinned keeps the first of its points in canonical order, which are first because earlier ones went: along a row that
//! chain leads back to its beginning, however far.

use super::islands::{Links, PIECE};
use super::local::{Judged, Local};
use super::rows::{FARTHEST, in_rows};
use super::support::{COUNTED, NEAR};
use crate::math::vec3::distance2;
use crate::neighbors::{Index, Neighbors};
use crate::reach::{Ground, Known};

/// Share by which a search is wider than what is compared with its results.
const ROUNDING: f64 = 1e-9;
/// Rounds of medians behind a spacing, and rounds in which clutter grows.
const ROUNDS: [usize; 2] = [super::scales::ROUNDS, super::clutter::ROUNDS];

/// Which of the values of [`Local`] are known.
pub(crate) struct LocalKnown {
    spacing: Known,
    /// Whether a point is clutter by itself, or in a crowd.
    single: Known,
    /// Whether a point is in a crowd, deep in it, and what it is linked to.
    pub(crate) crowd: Known,
    /// Distances between kept points.
    pub(crate) apart: Known,
}

/// What the stage reads of the whole cloud at once.
#[derive(Clone, Debug)]
pub(crate) struct Whole {
    /// The greatest distance between kept points where places are thinned.
    pub(crate) widest: f64,
    /// The points of which links can be longer than `long`, and how long: few, and far from all others.
    pub(crate) far: Vec<([f64; 3], f64)>,
    pub(crate) long: f64,
}

/// The spacings of [`spacings`](super::spacings): `lists` are those of nearest neighbours.
pub(crate) fn of_spacings(nearest: &Neighbors, lists: &Known) -> Known {
    lists.clone().steps(nearest, ROUNDS[0])
}

impl LocalKnown {
    /// From the lists that are known.
    pub(crate) fn new(ground: &Ground, nearest: &Neighbors, lists: &Known, local: &Local) -> LocalKnown {
        let planes = lists.over(nearest);
        let spacing = of_spacings(nearest, lists);
        let mut gaps = planes.and(lists);
        for i in in_rows(nearest, &local.planes).into_iter().map(|i| i as usize) {
            gaps.0[i] &= spacing.0[i] && ground.holds(i, FARTHEST * f64::from(local.spacing[i]));
        }
        let gaps = gaps.over(nearest);
        let near = |i: usize| NEAR * f64::from(local.spacing[i].max(local.raw[i]));
        let index = Index::build(ground.points);
        let counted = |i: usize| {
            let mut found = Vec::new();
            index.nearest(ground.points[i], COUNTED + 1, &mut found);
            found.get(COUNTED).map_or(f64::INFINITY, |f| f.distance2.sqrt())
        };
        let seen = |i: usize| ground.holds(i, near(i)) || ground.holds(i, counted(i));
        let support = Known::of(planes.0.len(), |i| planes.0[i] && spacing.0[i] && seen(i));
        let crowd = support.over(nearest);
        LocalKnown {
            single: crowd.and(&gaps),
            crowd: crowd.and(&spacing).over(nearest),
            apart: gaps.and(&spacing),
            spacing,
        }
    }

    /// Whether a point is kept: neither clutter nor represented by another.
    pub(crate) fn kept(
        &self,
        ground: &Ground,
        nearest: &Neighbors,
        local: &Local,
        judged: &Judged,
        whole: &Whole,
    ) -> Known {
        let drawn = self.single.clone().steps(nearest, ROUNDS[1]).and(&self.spacing);
        let pieces = Pieces {
            ground,
            links: Links { points: ground.points, nearest, reach: &local.marks.reach, out: &judged.drawn },
            index: Index::build(ground.points),
            listed: drawn.over(nearest),
            whole,
        };
        let settled = |i: usize| if judged.drawn[i] { drawn.0[i] } else { pieces.settled(i) };
        let clutter = Known::of(judged.drawn.len(), settled);
        let thinned = self.thinned(ground, &local.apart, whole.widest);
        Known::of(clutter.0.len(), |i| thinned.0[i] && clutter.0[i] && clutter.at(judged.stands[i]))
    }

    /// The representatives of points: in canonical order, as each depends on those before it.
    fn thinned(&self, ground: &Ground, apart: &[f64], widest: f64) -> Known {
        let mut known = vec![true; apart.len()];
        if widest == 0.0 {
            return Known(known);
        }
        let index = Index::build(ground.points);
        let mut found = Vec::new();
        for i in 0..apart.len() {
            index.within(ground.points[i], widest, &mut found);
            let before = found.iter().filter(|f| f.index < i as u32);
            let acts = |j: usize, d: f64| apart[i] > 0.0 && apart[j] > 0.0 && d <= apart[j] * apart[j];
            let sound = |j: usize, d: f64| self.apart.0[j] && (known[j] || !acts(j, d));
            known[i] = self.apart.0[i]
                && ground.holds(i, widest)
                && before.map(|f| (f.index as usize, f.distance2)).all(|(j, d)| sound(j, d));
        }
        Known(known)
    }
}

/// The pieces of surface between clutter.
struct Pieces<'a> {
    ground: &'a Ground<'a>,
    links: Links<'a>,
    index: Index,
    /// Where clutter and links are known at a point and at all that it lists.
    listed: Known,
    whole: &'a Whole,
}

impl Pieces<'_> {
    /// Whether it is known if the piece of point `i` is large enough: it is when a walk along known links has met enough
    /// points, or when they all are known and it ends.
    fn settled(&self, i: usize) -> bool {
        let (mut seen, mut found) = (vec![i], Vec::new());
        for both in [false, true] {
            let mut next = 0;
            while next < seen.len() && seen.len() < PIECE {
                let from = seen[next];
                next += 1;
                if !self.listed.0[from] || both && !self.around(from, &mut found) {
                    return false;
                }
                let back = found.drain(..).filter(|&x| self.links.of(x).any(|j| j == from));
                for j in self.links.of(from).chain(back) {
                    if !seen.contains(&j) {
                        seen.push(j);
                    }
                }
            }
        }
        true
    }

    /// Finds all points that can list point `i` and be linked to it; false if one is missing or not known. No link is longer than what
    /// either of its ends allows.
    fn around(&self, i: usize, found: &mut Vec<usize>) -> bool {
        let Whole { far, long, .. } = self.whole;
        let (own, reach) = (self.ground.points[i], f64::from(self.links.reach[i]));
        let near = reach.min(*long);
        self.index.around(own, near * (1.0 + ROUNDING), |f| found.push(f.index as usize));
        let mut sound = self.ground.holds(i, near);
        let mut at = Vec::new();
        for (place, far) in far.iter().filter(|_| reach > near) {
            let d = distance2(own, *place).sqrt();
            if d > near && d <= reach.min(*far) * (1.0 + ROUNDING) {
                self.index.nearest(*place, 1, &mut at);
                sound &= at.first().is_some_and(|f| f.distance2 == 0.0);
                found.extend(at.iter().map(|f| f.index as usize));
            }
        }
        found.retain(|&j| !self.links.out[j] || !self.listed.0[j]);
        sound && found.iter().all(|&j| self.listed.0[j])
    }
}
