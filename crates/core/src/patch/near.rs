//! The strips near a point, each with its nearest station.

use super::stations::Stations;
use crate::math::trees::boxes::{Boxes, Extent};
use crate::neighbors::{Found, Index};

/// Greatest number of strips near a point: more are near the end of an edge only where it joins points of two scales, and with
/// all of them the work would grow with the product of points and strips.
const MOST_STRIPS: usize = 64;
/// Boxes are as exact as their numbers: this share more is looked at.
const ROUNDING: f64 = 1e-9;

/// The stations of each strip under a tree of their own, and the strips under one.
pub(super) struct Near<'a> {
    stations: &'a Stations,
    strips: Vec<Index>,
    boxes: Boxes<3>,
}

/// The station of a strip that is nearest to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct NearStrip {
    pub strip: u32,
    pub distance2: f64,
    pub station: u32,
}

impl<'a> Near<'a> {
    pub(super) fn new(stations: &'a Stations) -> Self {
        let places = |s: usize| stations.of(s).iter().map(|station| station.position);
        let count = stations.border.len();
        let boxes = Boxes::new((0..count).map(|s| Extent::of(places(s))));
        let strips = (0..count).map(|s| Index::build(&places(s).collect::<Vec<_>>())).collect();
        Self { stations, strips, boxes }
    }

    /// The strips within `reach` of a point in ascending order, the nearest [`MOST_STRIPS`] where they are more; `found` is
    /// room to search in.
    pub(super) fn of(&self, p: [f64; 3], reach: f64, found: &mut Vec<Found>) -> Vec<NearStrip> {
        let mut near: Vec<NearStrip> = Vec::new();
        let order =
            |a: &NearStrip, b: &NearStrip| a.distance2.total_cmp(&b.distance2).then(a.strip.cmp(&b.strip));
        let mut bound = reach * reach;
        self.boxes.near(p, bound * (1.0 + ROUNDING), |strip| {
            self.strips[strip as usize].nearest(p, 1, found);
            if let Some(&Found { distance2, index }) = found.first().filter(|f| f.distance2 <= bound) {
                let station = self.stations.first[strip as usize] as u32 + index;
                let new = NearStrip { strip, distance2, station };
                near.insert(near.partition_point(|n| order(n, &new).is_lt()), new);
                near.truncate(MOST_STRIPS);
                if near.len() == MOST_STRIPS {
                    bound = near[MOST_STRIPS - 1].distance2;
                }
            }
            bound * (1.0 + ROUNDING)
        });
        near.sort_unstable_by_key(|n| n.strip);
        near
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::points::distance2;
    use crate::patch::stations::Station;
    use crate::shapes::Rng;

    /// `count` strips of seven stations each, anywhere in a box of the size of one.
    fn strips(count: usize) -> Stations {
        let mut rng = Rng::new(5);
        let mut stations = Stations { first: vec![0], ..Default::default() };
        for strip in 0..count as u32 {
            let from = [0, 1, 2].map(|_| rng.uniform());
            stations.all.extend((0..7).map(|k| Station {
                strip,
                position: [from[0] + 0.01 * f64::from(k), from[1], from[2]],
                tangent: [1.0, 0.0, 0.0],
                across: [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
                end: 0.0,
                leaves: [None; 2],
            }));
            stations.first.push(stations.all.len());
            stations.border.push(false);
        }
        stations
    }

    #[test]
    fn the_nearest_station_of_each_strip_is_found_and_of_many_strips_the_nearest() {
        let mut found = Vec::new();
        for (count, reach) in [(1, 2.0), (60, 0.3), (60, 2.0), (500, 0.2), (500, 2.0)] {
            let stations = strips(count);
            let near = Near::new(&stations);
            for p in [[0.5; 3], [0.1, 0.9, 0.4], [1.5, 0.5, 0.5]] {
                let nearest = |strip: usize| {
                    let all = stations.first[strip]..stations.first[strip + 1];
                    let of = |s: usize| (distance2(stations.all[s].position, p), s);
                    let (distance2, s) = all.map(of).min_by(|a, b| a.partial_cmp(b).unwrap()).unwrap();
                    (distance2, strip as u32, s as u32)
                };
                let mut all: Vec<(f64, u32, u32)> = (0..count).map(nearest).collect();
                all.retain(|n| n.0 <= reach * reach);
                all.sort_by(|a, b| a.0.total_cmp(&b.0));
                all.truncate(MOST_STRIPS);
                let mut wanted: Vec<(u32, u32)> = all.iter().map(|n| (n.1, n.2)).collect();
                wanted.sort_unstable();
                let found = near.of(p, reach, &mut found);
                let found: Vec<(u32, u32)> = found.iter().map(|n| (n.strip, n.station)).collect();
                assert_eq!(found, wanted, "{count} strips");
            }
        }
    }
}
