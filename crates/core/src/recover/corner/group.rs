//! The grouping of the points around a junction (Gumhold 2001, section 4.2, figure 11 c to e): votes along the incident strips into k weights
//! for each point, over and over until no point changes its group.

use super::view::{View, sector};
use crate::math::vec3::{cross, perpendicular};
use crate::recover::wedge::{FEWEST, Station, cross_section, split};

/// Greatest number of rounds; in the paper two or three do.
const ROUNDS: usize = 10;

/// A strip at a junction.
pub(in crate::recover) struct Arm {
    /// Number of the strip.
    pub strip: usize,
    /// Its crease points, from the junction on.
    pub stations: Vec<Station>,
    /// A place on its spline that shows its direction at the junction.
    pub beside: [f64; 3],
}

/// The points around a junction by face.
pub(in crate::recover) struct Grouping {
    /// The neighbourhood of the junction (the paper's `N_c`), ascending.
    pub points: Vec<u32>,
    /// The face of each.
    pub group: Vec<usize>,
    /// Number of the strip between the faces before and at each index.
    pub strips: Vec<usize>,
}

impl Grouping {
    /// The points that lie on neither face of a strip, ascending.
    pub(in crate::recover) fn strange_to(&self, strip: usize) -> Vec<u32> {
        let k = self.strips.len();
        let beside = |g: usize| self.strips[g] == strip || self.strips[(g + 1) % k] == strip;
        self.points.iter().zip(&self.group).filter(|&(_, &g)| !beside(g)).map(|(&p, _)| p).collect()
    }
}

/// Groups the ascending `near` points of a junction at `at`. `around` fills a list with the neighbourhood of a crease point. `None` where
/// the points show no direction to look from.
pub(in crate::recover) fn group(
    at: [f64; 3],
    near: Vec<u32>,
    mut arms: Vec<Arm>,
    points: &[[f64; 3]],
    unit_length: f64,
    mut around: impl FnMut(&Station, &mut Vec<u32>),
) -> Option<Grouping> {
    let view = View::new(at, near.iter().map(|&i| points[i as usize]))?;
    arms.sort_by(|a, b| view.angle(a.beside).total_cmp(&view.angle(b.beside)).then(a.strip.cmp(&b.strip)));
    let lines: Vec<f64> = arms.iter().map(|a| view.angle(a.beside)).collect();
    let mut group: Vec<usize> =
        near.iter().map(|&i| sector(&lines, view.angle(points[i as usize]))).collect();
    for _ in 0..ROUNDS {
        let mut weights = vec![vec![0.0; arms.len()]; near.len()];
        for (g, arm) in arms.iter().enumerate() {
            let faces = [(g + arms.len() - 1) % arms.len(), g];
            vote(arm, faces, &near, &group, points, unit_length, &mut around, &mut weights);
        }
        let next: Vec<usize> = weights.iter().zip(&group).map(|(w, &g)| most(w, g)).collect();
        if next == group {
            break;
        }
        group = next;
    }
    Some(Grouping { points: near, group, strips: arms.iter().map(|a| a.strip).collect() })
}

/// Adds the votes along one strip, until no more fall on the points around the junction.
#[allow(clippy::too_many_arguments)]
fn vote(
    arm: &Arm,
    faces: [usize; 2],
    near: &[u32],
    group: &[usize],
    points: &[[f64; 3]],
    unit_length: f64,
    around: &mut impl FnMut(&Station, &mut Vec<u32>),
    weights: &mut [Vec<f64>],
) {
    let mut list = Vec::new();
    for station in &arm.stations {
        list.clear();
        around(station, &mut list);
        let place = |i: u32| near.binary_search(&i).ok();
        // Points of faces that do not meet in this strip are not considered.
        list.retain(|&i| place(i).is_none_or(|k| faces.contains(&group[k])));
        if !list.iter().any(|&i| place(i).is_some()) {
            break;
        }
        let x = perpendicular(station.direction);
        let seen = cross_section(station, [x, cross(station.direction, x)], &list, points);
        let Some(left) = split(&seen, FEWEST) else { continue };
        // The side that holds more of a face's points is that face's.
        let leaning: i64 = list
            .iter()
            .zip(&left)
            .filter_map(|(&i, &l)| Some((group[place(i)?], l)))
            .fold(0, |sum, (g, l)| sum + if (g == faces[0]) == l { 1 } else { -1 });
        for ((&i, q), l) in list.iter().zip(&seen).zip(left) {
            if let Some(k) = place(i) {
                let face = faces[usize::from(l != (leaning >= 0))];
                weights[k][face] += unit_length / (unit_length + q[0].hypot(q[1]));
            }
        }
    }
}

/// The group of the greatest weight; the present one where no other is greater.
fn most(weights: &[f64], present: usize) -> usize {
    (0..weights.len()).fold(present, |best, g| if weights[g] > weights[best] { g } else { best })
}
