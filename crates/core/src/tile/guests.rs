//! Guests: what a tile sees around its lonely points, those that have not enough neighbours within its margin.
//!
//! The nearest neighbours of a stray return lie wherever they lie. A margin as wide as they are far could hold the whole cloud; but a ball
//! around the point that holds just them has only them, and what is asked of them is answered by their own surroundings.

use crate::math::vec3::distance2;

/// Neighbours of a lonely point that are looked for: more than any stage reads around a point without surface.
const NEAREST: usize = 32;
/// Share by which a ball is larger than the distance of its last point.
const BEYOND: f64 = 1e-6;

/// Balls around lonely points, and the places of the points in them; local frame.
#[derive(Clone, Debug, Default)]
pub(super) struct Guests {
    balls: Vec<([f64; 3], f64)>,
    places: Vec<[f64; 3]>,
}

impl Guests {
    /// The guests of some lonely points among all points of the cloud, by one pass over these.
    pub(super) fn of(lonely: &[[f64; 3]], all: impl Iterator<Item = [f64; 3]>) -> Guests {
        let mut near: Vec<Vec<(f64, [f64; 3])>> = vec![Vec::new(); lonely.len()];
        for p in all {
            for (own, near) in lonely.iter().zip(&mut near) {
                let found = (distance2(*own, p), p);
                let place = near.partition_point(|other| other.0 <= found.0);
                if place < NEAREST {
                    near.truncate(NEAREST - 1);
                    near.insert(place, found);
                }
            }
        }
        let radius =
            |near: &[(f64, [f64; 3])]| near.last().map_or(0.0, |last| last.0.sqrt() * (1.0 + BEYOND));
        Guests {
            balls: lonely.iter().zip(&near).map(|(own, near)| (*own, radius(near))).collect(),
            places: near.iter().flatten().map(|found| found.1).collect(),
        }
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

/// The greatest distance on any axis.
fn beside(p: [f64; 3], q: [f64; 3]) -> f64 {
    (0..3).map(|a| (p[a] - q[a]).abs()).fold(0.0, f64::max)
}
