//! Holes: closed borders with the surface around them.

use crate::math::vec3::{add, cross, dot, norm, sub, unit};
use crate::neighbors::{Found, Index};
use crate::network::{Network, StripKind};

/// Places along a loop at which it is asked where the surface lies.
const PLACES: usize = 64;
/// Points nearest to such a place whose mean gives the way to the surface.
const NEAREST: usize = 12;
/// Mean cosine between the ways to the surface and out of the loop from which on the surface lies around it: 60 degrees. At the
/// rim of a tube, where the surface leaves the plane of the loop, it is zero.
const AROUND: f64 = 0.5;

/// `(S)` the length of the loop for each strip that is part of a border around a hole, `None` for the others. `at` brings a point
/// of the network into the frame of `points`, those on surfaces.
pub(crate) fn holes(
    network: &Network,
    points: &[[f64; 3]],
    at: impl Fn([f64; 3]) -> [f64; 3],
) -> Vec<Option<f64>> {
    let surface = Surface { points, index: Index::build(points) };
    let mut holes = vec![None; network.strips.len()];
    for strips in loops(network) {
        let mut line = Vec::new();
        for &(strip, backwards) in &strips {
            let points = network.strips[strip].points.iter().map(|&p| at(p));
            if backwards { line.extend(points.rev()) } else { line.extend(points) }
        }
        line.dedup();
        if surface.is_around(&line) {
            let length = strips.iter().map(|&(strip, _)| network.strips[strip].length()).sum();
            strips.iter().for_each(|&(strip, _)| holes[strip] = Some(length));
        }
    }
    holes
}

/// The loops of borders: closed strips, and strips that meet two by two. Each strip with whether it is passed backwards.
fn loops(network: &Network) -> Vec<Vec<(usize, bool)>> {
    let strips = &network.strips;
    let mut at: Vec<Vec<usize>> = vec![Vec::new(); network.nodes.len()];
    for (s, strip) in strips.iter().enumerate() {
        [strip.start, strip.end].into_iter().flatten().for_each(|node| at[node as usize].push(s));
    }
    let mut passed = vec![false; strips.len()];
    let mut found = Vec::new();
    for first in (0..strips.len()).filter(|&s| strips[s].kind == StripKind::Border) {
        if passed[first] {
            continue;
        }
        passed[first] = true;
        let mut way = vec![(first, false)];
        let mut node = strips[first].end;
        while let Some(here) = node.filter(|&n| Some(n) != strips[first].start) {
            let next = at[here as usize].iter().find(|&&s| !passed[s] && strips[s].kind == StripKind::Border);
            let Some(&next) = next.filter(|_| at[here as usize].len() == 2) else { break };
            passed[next] = true;
            let backwards = strips[next].end == Some(here);
            way.push((next, backwards));
            node = if backwards { strips[next].start } else { strips[next].end };
        }
        let closes = |n: u32| Some(n) == strips[first].start && at[n as usize].len() == 2;
        if node.is_none_or(closes) {
            found.push(way);
        }
    }
    found
}

/// The points on surfaces, and the search among them.
struct Surface<'a> {
    points: &'a [[f64; 3]],
    index: Index,
}

impl Surface<'_> {
    /// Whether the surface lies around a closed polyline, and not within it or to one side of its plane.
    fn is_around(&self, line: &[[f64; 3]]) -> bool {
        let count = line.len();
        if count < 3 {
            return false;
        }
        let triangle = |k: usize| cross(sub(line[k], line[0]), sub(line[k + 1], line[0]));
        let area = (1..count - 1).map(triangle).fold([0.0; 3], add);
        let (mut sum, mut total) = (0.0, 0.0);
        let mut near = Vec::new();
        for k in (0..count).step_by(count.div_ceil(PLACES)) {
            let along = sub(line[(k + 1) % count], line[(k + count - 1) % count]);
            let outwards = unit(cross(along, area));
            let length = norm(along);
            sum += length * dot(outwards, self.way(line[k], &mut near));
            total += length;
        }
        sum > AROUND * total
    }

    /// The unit direction from a place to the mean of the points near it.
    fn way(&self, place: [f64; 3], near: &mut Vec<Found>) -> [f64; 3] {
        self.index.nearest(place, NEAREST, near);
        unit(near.iter().map(|f| sub(self.points[f.index as usize], place)).fold([0.0; 3], add))
    }
}
