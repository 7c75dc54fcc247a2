//! Which edges of the neighbour graph cross a strip.
//!
//! A point beside a strip is on the side whose half-line is nearer (`beside`). So near to the strip that its own error decides,
//! a point is on the side whose face it lies nearer to. The face is fitted in the frame of a station to the points that surely
//! lie on it: straight across the strip, and bent along it by a parabola, as the wall of a hole is.

use super::beside::{Beside, Entry, beside};
use super::ground::Ground;
use super::orient::in_space;
use super::stations::{Station, Stations, stations};
use crate::math::least_squares;
use crate::math::vec3::{dot, sub};
use crate::network::Network;
use crate::parallel;

/// Number of stations on either side of a station from which its faces take points.
const WINDOW: usize = 6;
/// Greatest distance from the strip of points that a face is fitted to, spacings.
const REACH: f64 = 2.0;
/// Distance from the strip up to which the faces decide, spacings: beyond, the line of a strip is never as wrong as that.
const DECIDED: f64 = 1.0;
/// Fewest points of a face.
const FEWEST: usize = 6;
/// The side of a point that lies on a strip: both.
const BOTH: u8 = 2;
/// Angle between a face and the way to a point above which the point lies on another.
const ASLANT_DEG: f64 = 40.0;
/// Distance from the end of a strip within which a third face may begin, spacings.
const WITHIN: f64 = 0.1;
/// Fits of a face; in each but the first a point counts the less the farther it lay from the face.
const FITS: usize = 3;

/// The sides of the strips on which the points of a cloud lie.
pub(crate) struct Crossing {
    beside: Beside,
}

/// A face beside a station: the direction away from the strip, and the height over it as `a + b v + c t + d t^2` of the
/// distance `v` in this direction and `t` along the strip.
#[derive(Clone, Copy, Debug)]
struct Side {
    away: [f64; 3],
    up: [f64; 3],
    height: [f64; 4],
}

impl Crossing {
    /// The sides of the strips of `network`, local frame.
    pub(crate) fn new(ground: &Ground, network: &Network) -> Self {
        Self::with_ends(ground, network, false)
    }

    /// As [`Crossing::new`], but points that may lie on a third face, as beside the end of a strip at a corner, are on no side: where
    /// triangles have to meet, one too many is less of an evil than a gap.
    pub(crate) fn lenient(ground: &Ground, network: &Network) -> Self {
        Self::with_ends(ground, network, true)
    }

    fn with_ends(ground: &Ground, network: &Network, lenient: bool) -> Self {
        let (stations, mut found) = beside(ground, stations(network, ground.scales, ground.points.len()));
        let faces = faces(ground, &stations, &found);
        let sides = parallel::flat_map(ground.points.len(), parallel::QUICK, |i, sides| {
            let reach = DECIDED * ground.scales.at(i).spacing;
            for (at, entry) in found.of(i).iter().enumerate().filter(|(_, e)| e.distance < reach) {
                let station = &stations.all[entry.station as usize];
                let [Some(a), Some(b)] = &faces[entry.station as usize] else { continue };
                let [a, b] = [a, b].map(|face| face.off(station, ground.points[i]).abs());
                sides.push((i, at, u8::from(b < a)));
            }
        });
        sides.into_iter().for_each(|(i, at, side)| found.set_side(i, at, side));
        let past = if lenient { past(ground, network, &stations, &found) } else { Vec::new() };
        past.into_iter().for_each(|(i, at)| found.set_side(i, at, BOTH));
        Self { beside: found }
    }

    /// Puts points on strips, given the strips that each of them lies on: nothing crosses a strip from or to a point on it.
    pub(crate) fn put_on<'a>(&mut self, points: impl Iterator<Item = (usize, &'a [u32])>) {
        for (i, strips) in points {
            for at in 0..self.beside.of(i).len() {
                if strips.contains(&self.beside.of(i)[at].strip) {
                    self.beside.set_side(i, at, BOTH);
                }
            }
        }
    }

    /// Distance of point `i` from the nearest strip beside it; infinite if there is none.
    pub(crate) fn clearance(&self, i: usize) -> f64 {
        self.beside.clearance(i)
    }

    /// Whether the straight way from point `i` to point `j` leads from one side of a strip to the other.
    pub(crate) fn between(&self, i: usize, j: usize) -> bool {
        crosses(self.beside.of(i), self.beside.of(j))
    }
}

/// Whether two points lie on different sides of a strip.
pub(super) fn crosses(a: &[Entry], b: &[Entry]) -> bool {
    a.iter().any(|e| b.iter().any(|f| e.strip == f.strip && e.side + f.side == 1))
}

/// The entries of points on neither face of a strip: at right angles to both, or past an end in which others meet it, where a third
/// face begins.
fn past(ground: &Ground, network: &Network, stations: &Stations, beside: &Beside) -> Vec<(usize, usize)> {
    let ends: Vec<u32> = network.strips.iter().flat_map(|s| [s.start, s.end]).flatten().collect();
    let mut degree = vec![0; ends.iter().max().map_or(0, |&most| most as usize + 1)];
    ends.iter().for_each(|&node| degree[node as usize] += 1);
    let junction = |station: &Station| {
        let strip = &network.strips[station.strip as usize];
        let node = if station.end < 0.0 { strip.start } else { strip.end };
        station.end != 0.0 && node.is_some_and(|node| degree[node as usize] >= 3)
    };
    parallel::flat_map(ground.points.len(), parallel::QUICK, |i, past| {
        let spacing = ground.scales.at(i).spacing;
        for (at, entry) in beside.of(i).iter().enumerate() {
            let station = &stations.all[entry.station as usize];
            let along = dot(sub(ground.points[i], station.position), station.tangent) * station.end;
            let aslant = station.leaves[usize::from(entry.side & 1)].is_some_and(|leave| {
                let towards = leave[0] * entry.offset[0] + leave[1] * entry.offset[1];
                towards < ASLANT_DEG.to_radians().cos() * entry.offset[0].hypot(entry.offset[1])
            });
            if aslant && entry.distance > DECIDED * spacing || junction(station) && along > -WITHIN * spacing
            {
                past.push((i, at));
            }
        }
    })
}

/// The faces on both sides of every station.
fn faces(ground: &Ground, stations: &Stations, beside: &Beside) -> Vec<[Option<Side>; 2]> {
    let mut at: Vec<[Vec<u32>; 2]> = vec![Default::default(); stations.all.len()];
    for i in 0..ground.points.len() {
        let reach = REACH * ground.scales.at(i).spacing;
        for entry in beside.of(i).iter().filter(|e| !e.seam && e.nearest && e.distance <= reach) {
            at[entry.station as usize][usize::from(entry.side)].push(i as u32);
        }
    }
    parallel::flat_map(stations.border.len(), parallel::TASK, |strip, faces| {
        let range = stations.first[strip]..stations.first[strip + 1];
        for s in range.clone() {
            let window = s.saturating_sub(WINDOW).max(range.start)..range.end.min(s + WINDOW + 1);
            faces.push([0, 1].map(|side| {
                let near = at[window.clone()].iter().flat_map(|sides| &sides[side]);
                let points: Vec<[f64; 3]> = near.map(|&i| ground.points[i as usize]).collect();
                Side::fit(&stations.all[s], side, &points, ground.scales.mean.unit())
            }));
        }
    })
}

impl Side {
    /// The face through points on one side of a station; `None` if they are too few, or do not determine it.
    fn fit(station: &Station, side: usize, points: &[[f64; 3]], unit: f64) -> Option<Side> {
        let leave = station.leaves[side].filter(|_| points.len() >= FEWEST)?;
        let (away, up) = (in_space(station, leave), in_space(station, [-leave[1], leave[0]]));
        let mut face = Side { away, up, height: [0.0; 4] };
        let mut scale = f64::INFINITY;
        for _ in 0..FITS {
            let rows = points.iter().map(|&p| {
                let (row, w) = face.row(station, p);
                let off = face.off(station, p) / scale;
                let weight = 1.0 / (1.0 + off * off);
                (row.map(|x| weight * x), weight * w)
            });
            face.height = least_squares::least_squares(rows)?;
            let mut offs: Vec<f64> = points.iter().map(|&p| face.off(station, p).abs()).collect();
            let middle = offs.len() / 2;
            scale = 2.0 * *offs.select_nth_unstable_by(middle, f64::total_cmp).1 + 1e-3 * unit;
        }
        Some(face)
    }

    /// The terms of a point and its height.
    fn row(&self, station: &Station, p: [f64; 3]) -> ([f64; 4], f64) {
        let d = sub(p, station.position);
        let (t, v) = (dot(d, station.tangent), dot(d, self.away));
        ([1.0, v, t, t * t], dot(d, self.up))
    }

    /// Height of a point over the face.
    fn off(&self, station: &Station, p: [f64; 3]) -> f64 {
        let (row, w) = self.row(station, p);
        w - row.iter().zip(self.height).map(|(x, h)| x * h).sum::<f64>()
    }
}
