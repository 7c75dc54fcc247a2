//! Votes along a strip (Gumhold 2001, section 4.1, figure 10 c): every crease point groups its neighbours by the simplified wedge
//! fit, and the groups of all crease points add up to one weight for each neighbour.

use super::split::split;
use super::stations::Station;
use crate::math::vec3::{add_scaled, cross, dot, perpendicular, sub, unit};

/// Fewest points of a group.
pub(in crate::recover) const FEWEST: usize = 3;
/// Share of a point's votes that must be left over for one group: a weight nearer to zero belongs to neither.
const NEAR_ZERO: f64 = 0.2;

/// The group of a point beside a strip, 0 for the paper's A and 1 for B.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::recover) struct Side {
    /// The point of the cloud.
    pub point: u32,
    /// Its group.
    pub side: usize,
}

/// One vote.
pub(in crate::recover) struct Vote {
    /// The point of the cloud.
    pub point: u32,
    /// Positive for group A, negative for B; the less, the farther the point lies from the zenith.
    pub weight: f64,
}

/// The votes of the crease points of one strip on their `near` points; `unit_length` is the distance at which a vote has half its
/// weight.
///
/// Axes are carried from crease point to crease point, turned as little as the crease direction allows, so that the groups of
/// one are those of the next.
pub(in crate::recover) fn votes(
    stations: &[Station],
    points: &[[f64; 3]],
    unit_length: f64,
    mut near: impl FnMut(&Station, &mut Vec<u32>),
) -> Vec<Vote> {
    let mut votes = Vec::new();
    let mut list = Vec::new();
    let mut x = [0.0; 3];
    let mut before: Option<[f64; 2]> = None;
    for station in stations {
        x = carried(x, station.direction);
        let y = cross(station.direction, x);
        list.clear();
        near(station, &mut list);
        let seen = cross_section(station, [x, y], &list, points);
        let Some(mut left) = split(&seen, FEWEST) else { continue };
        let apart = between(&seen, &left);
        // The groups change names where the way from one to the other points against that before.
        let turned = before.is_some_and(|b| b[0] * apart[0] + b[1] * apart[1] < 0.0);
        if turned {
            left.iter_mut().for_each(|l| *l = !*l);
        }
        before = Some(if turned { apart.map(|a| -a) } else { apart });
        for ((&point, q), left) in list.iter().zip(&seen).zip(left) {
            let weight = unit_length / (unit_length + q[0].hypot(q[1]));
            votes.push(Vote { point, weight: if left { weight } else { -weight } });
        }
    }
    votes
}

/// Points in the plane across a crease point, along the axes there.
pub(in crate::recover) fn cross_section(
    station: &Station,
    axes: [[f64; 3]; 2],
    list: &[u32],
    points: &[[f64; 3]],
) -> Vec<[f64; 2]> {
    let from = |&i: &u32| sub(points[i as usize], station.at);
    list.iter().map(from).map(|d| axes.map(|a| dot(d, a))).collect()
}

/// The x axis at a crease point: that before, as far as the direction allows.
fn carried(x: [f64; 3], direction: [f64; 3]) -> [f64; 3] {
    let across = unit(add_scaled(x, direction, -dot(x, direction)));
    if across == [0.0; 3] { perpendicular(direction) } else { across }
}

/// From the mean of the right group to that of the left.
fn between(seen: &[[f64; 2]], left: &[bool]) -> [f64; 2] {
    let mut sums = [[0.0; 3]; 2];
    for (q, &l) in seen.iter().zip(left) {
        let sum = &mut sums[usize::from(l)];
        *sum = [sum[0] + q[0], sum[1] + q[1], sum[2] + 1.0];
    }
    let mean = sums.map(|[x, y, n]| [x / n.max(1.0), y / n.max(1.0)]);
    [mean[1][0] - mean[0][0], mean[1][1] - mean[0][1]]
}

/// The groups by the sign of the summed weights, by point; points near zero are left out.
pub(in crate::recover) fn sides(mut votes: Vec<Vote>) -> Vec<Side> {
    // Stable, so that each sum runs in the order of the crease points.
    votes.sort_by_key(|v| v.point);
    let side = |votes: &[Vote]| {
        let sum: f64 = votes.iter().map(|v| v.weight).sum();
        let all: f64 = votes.iter().map(|v| v.weight.abs()).sum();
        (sum.abs() > NEAR_ZERO * all).then(|| Side { point: votes[0].point, side: usize::from(sum < 0.0) })
    };
    votes.chunk_by(|a, b| a.point == b.point).filter_map(side).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::Rng;

    #[test]
    fn groups_keep_their_names_along_a_crease_that_turns_by_half_a_turn() {
        // A crease along a half circle of radius 10 between a disc and the cylinder under its rim.
        let mut rng = Rng::new(2);
        let (mut points, mut on_disc) = (Vec::new(), Vec::new());
        for i in 0..1500 {
            let (sin, cos) = rng.between(0.0, std::f64::consts::PI).sin_cos();
            let depth = rng.between(0.0, 3.0);
            let disc = i % 2 == 0;
            let [r, z] = if disc { [10.0 - depth, 0.0] } else { [10.0, -depth] };
            points.push([
                r * cos + 0.1 * rng.gaussian(),
                r * sin + 0.1 * rng.gaussian(),
                z + 0.1 * rng.gaussian(),
            ]);
            on_disc.push(disc);
        }
        let station = |k: u32| {
            let (sin, cos) = (std::f64::consts::PI * f64::from(k) / 30.0).sin_cos();
            Station { at: [10.0 * cos, 10.0 * sin, 0.0], direction: [-sin, cos, 0.0], source: 0 }
        };
        let stations: Vec<Station> = (0..=30).map(station).collect();
        let near = |s: &Station, list: &mut Vec<u32>| {
            let close = |&i: &u32| crate::math::vec3::distance(points[i as usize], s.at) < 3.0;
            list.extend((0..points.len() as u32).filter(close));
        };
        let sides = sides(votes(&stations, &points, 1.0, near));
        assert!(sides.len() > 1300, "{}", sides.len());
        let same = sides.iter().filter(|s| (s.side == 0) == on_disc[s.point as usize]).count();
        let right = same.max(sides.len() - same);
        assert!(right as f64 > 0.95 * sides.len() as f64, "{right} of {}", sides.len());
    }
}
