//! Which values at the points of a part of a cloud are those of the whole cloud.
//!
//! A part holds every point of the cloud in some box, so that each of its points has some room around it in which nothing is missing. A
//! value is known where all that it was made of is: positions in a ball, if the ball fits into the room; values at
//! other points, if they are known there. Each stage says what it reads, and no distance is guessed.

use crate::math::vec3::distance;
use crate::neighbors::{Index, Neighbors};
use crate::parallel;

/// Share by which a ball must be smaller than the room: more than rounding can take away.
const ROUNDING: f64 = 1e-9;

/// Multiple of the greatest distance in a list of nearest neighbours from which points enter the neighbour graph.
const LISTING: f64 = crate::neighbors::riemannian::STRAY;

/// Positions of a part of a cloud and the room around each.
pub(crate) struct Ground<'a> {
    /// `(N, 3)` local frame.
    pub(crate) points: &'a [[f64; 3]],
    /// `(N)` distance up to which no point of the cloud is missing around each; infinite where none is missing at all.
    pub(crate) room: Vec<f64>,
}

/// `(N)` whether the value at each point is that of the whole cloud.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Known(pub(crate) Vec<bool>);

impl Ground<'_> {
    /// Whether a ball around point `i` lies in its room.
    pub(crate) fn holds(&self, i: usize, radius: f64) -> bool {
        self.room[i] == f64::INFINITY || radius * (1.0 + ROUNDING) < self.room[i]
    }

    /// The same points with room up to the nearest point of which it is not known whether it belongs to the cloud; `blind` are the
    /// positions of those.
    pub(crate) fn seen<'b>(&self, points: &'b [[f64; 3]], room: Vec<f64>, blind: &[[f64; 3]]) -> Ground<'b> {
        let index = Index::build(blind);
        let room = parallel::map_with(points.len(), parallel::QUICK, |found, i| {
            index.nearest(points[i], 1, found);
            found.first().map_or(room[i], |f| room[i].min(f.distance2.sqrt()))
        });
        Ground { points, room }
    }

    /// Distance of the last of `k` nearest neighbours of point `i`; infinite where the part has fewer.
    fn farthest(&self, nearest: &Neighbors, i: usize, k: usize) -> f64 {
        let last = nearest.of(i).get(k.wrapping_sub(1));
        last.map_or(f64::INFINITY, |&j| distance(self.points[i], self.points[j as usize]))
    }

    /// The lists of the `k` nearest neighbours: nothing nearer is missing.
    pub(crate) fn lists(&self, nearest: &Neighbors, k: usize) -> Known {
        Known::of(nearest.len(), |i| self.holds(i, self.farthest(nearest, i, k)))
    }

    /// The rows of the neighbour graph: the own list, and those of all points that can list the point.
    ///
    /// More points around one that lists `i` can only drive `i` from its list, so that the rows hold all that may list `i`.
    pub(crate) fn rows(&self, nearest: &Neighbors, graph: &Neighbors, k: usize, lists: &Known) -> Known {
        Known::of(graph.len(), |i| {
            let row = graph.of(i).iter();
            self.holds(i, LISTING * self.farthest(nearest, i, k))
                && row.chain([&(i as u32)]).all(|&j| lists.at(j))
        })
    }
}

impl Known {
    /// `(N)` by a test of each point.
    pub(crate) fn of(count: usize, test: impl Fn(usize) -> bool + Sync) -> Known {
        Known(parallel::map(count, parallel::QUICK, test))
    }

    /// Whether the value at a point is known.
    #[inline]
    pub(crate) fn at(&self, i: u32) -> bool {
        self.0[i as usize]
    }

    /// Where both are known.
    pub(crate) fn and(&self, other: &Known) -> Known {
        Known::of(self.0.len(), |i| self.0[i] && other.0[i])
    }

    /// Where the value is known at a point and at all that it lists.
    pub(crate) fn over(&self, lists: &Neighbors) -> Known {
        Known::of(self.0.len(), |i| self.0[i] && lists.of(i).iter().all(|&j| self.at(j)))
    }

    /// Where the value is known at all points up to a number of steps along the lists.
    pub(crate) fn steps(self, lists: &Neighbors, steps: usize) -> Known {
        (0..steps).fold(self, |known, _| known.over(lists))
    }
}
