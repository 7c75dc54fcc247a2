//! Guests: what a tile sees around its lonely points, those that have not enough neighbours within its margin.
//!
//! The nearest neighbours of a stray return lie wherever they lie. A margin as wide as they are far could hold the whole cloud; but a ball
//! around the point that holds just them has only them, and what is asked of them is answered by their own surroundings.

use super::plan::Plan;
use super::points::{Corners, Points};
use crate::error::Error;
use crate::frame::{Frame, cell, finite};
use crate::math::vec3::{distance2, norm};

/// Neighbours of a lonely point that are looked for: more than any stage reads around a point without surface.
const NEAREST: usize = 32;
/// Share by which a ball is larger than the distance of its last point, and a box than what it has to hold.
const BEYOND: f64 = 1e-6;

/// Balls around lonely points, and the places of the points in them; local frame.
#[derive(Clone, Debug, Default)]
pub(super) struct Guests {
    balls: Vec<([f64; 3], f64)>,
    places: Vec<[f64; 3]>,
}

impl Guests {
    /// The guests of some lonely points, local frame, among all points of the cloud.
    ///
    /// # Errors
    /// Those of the points.
    pub(super) fn of(
        lonely: &[[f64; 3]],
        plan: &Plan,
        frame: Frame,
        points: &dyn Points,
    ) -> Result<Guests, Error> {
        let mut near: Vec<Vec<(f64, [f64; 3])>> = vec![Vec::new(); lonely.len()];
        let world = |p: &[f64; 3]| p.map(|x| x * frame.scale);
        let boxes: Vec<Corners> = lonely.iter().flat_map(|p| plan.around(world(p), NEAREST as u64)).collect();
        points.within(&boxes, &mut |_, p| {
            if finite(&p) {
                let local = plan.grid.relative(p).map(|x| x / frame.scale);
                lonely
                    .iter()
                    .zip(&mut near)
                    .for_each(|(own, near)| insert(near, distance2(*own, local), local));
            }
        })?;
        let radius =
            |near: &[(f64, [f64; 3])]| near.last().map_or(0.0, |last| last.0.sqrt() * (1.0 + BEYOND));
        Ok(Guests {
            balls: lonely.iter().zip(&near).map(|(own, near)| (*own, radius(near))).collect(),
            places: near.iter().flatten().map(|found| found.1).collect(),
        })
    }

    /// Boxes in which all lie that a margin holds, local frame.
    pub(super) fn boxes(&self, margin: f64) -> impl Iterator<Item = Corners> + '_ {
        let balls = self.balls.iter().map(|(centre, radius)| around(*centre, *radius));
        balls.chain(self.places.iter().map(move |place| around(*place, margin)))
    }

    /// Whether a point lies in a ball, or within a margin of a guest on every axis.
    pub(super) fn hold(&self, p: [f64; 3], margin: f64) -> bool {
        self.balls.iter().any(|(centre, radius)| distance2(*centre, p) <= radius * radius)
            || self.places.iter().any(|q| beside(*q, p) <= margin)
    }

    /// Distance up to which no point is missing around a point that they hold; zero around others.
    pub(super) fn room(&self, p: [f64; 3], margin: f64) -> f64 {
        let balls = self.balls.iter().map(|(centre, radius)| radius - distance2(*centre, p).sqrt());
        balls.chain(self.places.iter().map(|q| margin - beside(*q, p))).fold(0.0, f64::max)
    }
}

/// Adds a point to the nearest ones, of which the last gives way.
fn insert(near: &mut Vec<(f64, [f64; 3])>, distance2: f64, p: [f64; 3]) {
    let place = near.partition_point(|other| other.0 <= distance2);
    if place < NEAREST {
        near.truncate(NEAREST - 1);
        near.insert(place, (distance2, p));
    }
}

/// A box that holds a ball, rounding included.
fn around(p: [f64; 3], radius: f64) -> Corners {
    let side = radius * (1.0 + BEYOND);
    [p.map(|x| x - side), p.map(|x| x + side)]
}

/// The greatest distance on any axis.
fn beside(p: [f64; 3], q: [f64; 3]) -> f64 {
    (0..3).map(|a| (p[a] - q[a]).abs()).fold(0.0, f64::max)
}

impl Plan {
    /// The cells in which the points nearest to a place lie, so many of them, or all if there are fewer. From the least corner of
    /// the cloud, in the unit of the input.
    fn around(&self, from: [f64; 3], wanted: u64) -> Vec<Corners> {
        let side = self.grid.side(self.level);
        let cells = self.codes.iter().map(|&code| {
            let low = cell(code).map(|c| f64::from(c) * side);
            [low, low.map(|x| x + side)]
        });
        // The distances of the nearest and the farthest place in a cell.
        let far = |[low, high]: Corners| norm([0, 1, 2].map(|a| (from[a] - low[a]).max(high[a] - from[a])));
        let near = |[low, high]: Corners| {
            norm([0, 1, 2].map(|a| (low[a] - from[a]).max(from[a] - high[a]).max(0.0)))
        };
        let mut reach: Vec<(f64, u64)> = cells.clone().map(far).zip(self.counts.iter().copied()).collect();
        reach.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let mut held = 0;
        let enough = reach.iter().find(|(_, count)| {
            held += count;
            held >= wanted
        });
        let reach = enough.map_or(f64::INFINITY, |cell| cell.0 * (1.0 + BEYOND));
        cells.filter(|&cell| near(cell) <= reach).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::histogram::Histogram;
    use super::*;
    use crate::shapes::Rng;

    /// A source that passes on the points in its boxes alone, and counts them.
    struct Boxed<'a>(&'a [[f64; 3]], &'a Plan, std::cell::Cell<usize>);

    impl Points for Boxed<'_> {
        fn count(&self) -> usize {
            self.0.len()
        }

        fn within(&self, boxes: &[Corners], take: &mut dyn FnMut(u32, [f64; 3])) -> Result<(), Error> {
            let inside =
                |p: [f64; 3], [low, high]: &Corners| (0..3).all(|a| low[a] <= p[a] && p[a] <= high[a]);
            for (&p, i) in self.0.iter().zip(0..) {
                if boxes.iter().any(|b| inside(self.1.grid.relative(p), b)) {
                    self.2.set(self.2.get() + 1);
                    take(i, p);
                }
            }
            Ok(())
        }
    }

    #[test]
    fn guests_are_the_nearest_of_all_points_though_few_boxes_are_read() {
        let mut rng = Rng::new(8);
        let mut points: Vec<[f64; 3]> =
            (0..20_000).map(|_| [100.0 * rng.uniform(), 100.0 * rng.uniform(), 0.0]).collect();
        points.extend([[400.0, 3.0, 2.0], [50.0, 50.0, 30.0]]);
        let plan = Plan::new(&Histogram::of(&points, 1 << 12).unwrap(), 1000);
        let frame = Frame { offset: plan.corner(), scale: 1.0 };
        let lonely = [20_000, 20_001].map(|i: usize| plan.grid.relative(points[i]));
        let all = Guests::of(&lonely, &plan, frame, &points).unwrap();
        let boxed = Boxed(&points, &plan, Default::default());
        let some = Guests::of(&lonely, &plan, frame, &boxed).unwrap();
        assert_eq!((&some.balls, &some.places), (&all.balls, &all.places));
        assert!(some.places.len() == 64 && boxed.2.get() < 3000, "{}", boxed.2.get());
    }
}
