//! Corners of a strip: nodes where two straight pieces meet at an angle.
//!
//! Creases that meet have a node already, but the corner of a border or of a lone crease is a vertex like any other, and a
//! spline would round it. Around each vertex two straight lines are compared with one smooth curve, both fitted to the vertices
//! on either side. The nearest vertices are left out, as the alignment of the points has rounded them. Not in Gumhold 2001.

mod meeting;

use crate::math::vec3::{add_scaled, distance, dot, sub};
use crate::network::StripKind;
use crate::params::RepairParams;
use crate::pattern::{LineGraph, Path, paths};
use crate::surface::Scales;
use meeting::Meeting;

/// Vertices nearer to a corner than this, in spacings, do not count for its sides.
const ROUNDED_OFF: f64 = 1.25;
/// Lengths of the sides that are tried, spacings: long ones are more certain, short ones fit between two corners.
const SIDES: [f64; 2] = [10.0, 6.0];
/// Least share of that length that a side must have, and its least number of vertices.
const FILLED_SIDE: (f64, usize) = (0.8, 4);
/// Least length of path between two corners, spacings.
const CORNERS_APART: f64 = 3.0;
/// Greatest length of path on either side that a corner's rounding spoils, spacings.
const MOST_SPOILT: f64 = 0.5 * SIDES[0];
/// Greatest ratio of the residual of two lines to the residual of a smooth curve, at the least turn and at a right angle: a
/// slight bend needs clearer evidence.
const CLEAR_RATIO: [f64; 2] = [0.4, 0.6];
/// Greatest radius by which the alignment of the points rounds a corner, spacings: much at a border, hardly at a crease. A
/// round of greater radius belongs to the part.
const ROUNDED: [(StripKind, f64); 2] = [(StripKind::Crease, 1.0), (StripKind::Border, 4.0)];

/// A corner found on a path.
#[derive(Clone, Copy, Debug)]
struct Corner {
    /// Index into the path.
    at: usize,
    position: [f64; 3],
    ratio: f64,
    /// Length of path on either side that is rounded, spacings.
    spoilt: f64,
}

/// Puts a node at every corner of the strips.
pub(crate) fn corners(lines: &mut LineGraph, kind: StripKind, scales: Scales, params: &RepairParams) {
    let rounded = ROUNDED.iter().find(|r| r.0 == kind).map_or(0.0, |r| r.1);
    for path in paths(lines) {
        let course = Course::new(lines, &path, scales, rounded);
        place(lines, &path, &course, &course.corners(params.corner_deg));
    }
}

/// The vertices of a path with their distance along it, in spacings.
struct Course {
    positions: Vec<[f64; 3]>,
    along: Vec<f64>,
    length: f64,
    closed: bool,
    /// The spacing at each vertex.
    units: Vec<f64>,
    /// Greatest radius of a corner's rounding, spacings.
    rounded: f64,
}

impl Course {
    fn new(lines: &LineGraph, path: &Path, scales: Scales, rounded: f64) -> Course {
        let units: Vec<f64> = path.vertices.iter().map(|&v| scales.unit(lines.points[v as usize])).collect();
        let positions: Vec<[f64; 3]> = path.vertices.iter().map(|&v| lines.positions[v as usize]).collect();
        let mut along = vec![0.0];
        let step = |a: usize, b: usize| distance(positions[a], positions[b]) / (0.5 * (units[a] + units[b]));
        for i in 1..positions.len() {
            along.push(along[i - 1] + step(i - 1, i));
        }
        let closed = path.ends.is_none();
        let last = along[along.len() - 1];
        let gap = if closed { step(0, positions.len() - 1) } else { 0.0 };
        Course { positions, along, length: last + gap, closed, units, rounded }
    }

    /// The vertices of one side of `at`, behind it (`step` -1) or ahead of it (+1), from the distance `near` to the length `side`:
    /// distance along the path and position, in order away from `at`.
    fn side(&self, at: usize, step: isize, side: f64, near: f64) -> Vec<(f64, [f64; 3])> {
        let count = self.positions.len() as isize;
        let mut found = Vec::new();
        for k in 1..count {
            let raw = at as isize + step * k;
            if !self.closed && !(0..count).contains(&raw) {
                break;
            }
            let i = raw.rem_euclid(count) as usize;
            let turns = raw.div_euclid(count) as f64;
            let s = self.along[i] + turns * self.length - self.along[at];
            if s.abs() > side.min(0.4 * self.length) {
                break;
            }
            if s.abs() >= near {
                found.push((s, self.positions[i]));
            }
        }
        found
    }

    /// Length of path between two of its vertices, spacings.
    fn apart(&self, i: usize, j: usize) -> f64 {
        let s = (self.along[i] - self.along[j]).abs();
        if self.closed { s.min(self.length - s) } else { s }
    }

    /// The vertices less than `far` along the path from one of them, itself among them.
    fn around(&self, at: usize, far: f64) -> Vec<usize> {
        let count = self.positions.len() as isize;
        let mut found = vec![at];
        for step in [-1, 1] {
            let way = (1..count).map(|k| at as isize + step * k);
            let way = way.take_while(|raw| self.closed || (0..count).contains(raw));
            let near = way.map(|raw| raw.rem_euclid(count) as usize);
            found.extend(near.take_while(|&i| self.apart(i, at) < far));
        }
        found
    }

    /// The corners with a turn of at least `turn_deg`, the clearest first, none nearer to another than [`CORNERS_APART`].
    fn corners(&self, turn_deg: f64) -> Vec<Corner> {
        let mut all: Vec<Corner> = (0..self.positions.len())
            .filter_map(|i| SIDES.iter().find_map(|&side| self.corner(i, side, turn_deg)))
            .collect();
        all.sort_by(|a, b| a.ratio.total_cmp(&b.ratio).then(a.at.cmp(&b.at)));
        let mut kept: Vec<Corner> = Vec::new();
        let mut spoilt: Vec<Option<f64>> = vec![None; self.positions.len()];
        for corner in all {
            let near = |i: usize| {
                let least = spoilt[i].map(|other| (other + corner.spoilt).max(CORNERS_APART));
                least.is_some_and(|least| self.apart(i, corner.at) < least)
            };
            let far = (MOST_SPOILT + corner.spoilt).max(CORNERS_APART);
            if !self.around(corner.at, far).into_iter().any(near) {
                spoilt[corner.at] = Some(corner.spoilt);
                kept.push(corner);
            }
        }
        kept
    }

    /// The corner at a vertex as seen with sides of length `side`; where the path is rounded, the straight parts beyond place it.
    fn corner(&self, at: usize, side: f64, turn_deg: f64) -> Option<Corner> {
        let first = self.meeting(at, side, ROUNDED_OFF)?;
        let (turn, spoilt) = first.rounding(self.off(at, first.position) / self.units[at], self.rounded)?;
        // The tip of a rounding is no farther away than the rounding is long; nearly parallel sides meet anywhere.
        let near = |m: &Meeting| distance(m.position, self.positions[at]) <= spoilt * self.units[at];
        let beyond = self.meeting(at, side, spoilt).filter(|m| spoilt > ROUNDED_OFF && near(m));
        let position = beyond.map_or(first.position, |b| b.position);
        let [least, right] = CLEAR_RATIO;
        let share = ((turn - turn_deg) / (90.0 - turn_deg)).clamp(0.0, 1.0);
        let clear = first.ratio <= least + share * (right - least);
        // A rounding that uses up the whole sides is not that of a corner.
        (turn >= turn_deg && clear && spoilt <= 0.5 * side).then_some(Corner {
            at,
            position,
            ratio: first.ratio,
            spoilt: spoilt.max(ROUNDED_OFF),
        })
    }

    /// The place where the lines through both sides meet.
    fn meeting(&self, at: usize, side: f64, near: f64) -> Option<Meeting> {
        let sides = [-1, 1].map(|step| self.side(at, step, side, near));
        let (share, fewest) = FILLED_SIDE;
        if sides.iter().any(|s| s.len() < fewest || s[s.len() - 1].0.abs() < share * side) {
            return None;
        }
        Meeting::new(&sides, SIDES[0], 1e-9 * self.units[at])
    }

    /// The distance from the path of a place near vertex `at`.
    fn off(&self, at: usize, place: [f64; 3]) -> f64 {
        let count = self.positions.len();
        let window = if self.closed { count } else { count - 1 };
        let first = if self.closed { at + count - 3 } else { at.saturating_sub(3) };
        (first..first + 6)
            .filter(|&i| self.closed || i < window)
            .map(|i| [i % count, (i + 1) % count].map(|k| self.positions[k]))
            .map(|[a, b]| {
                let d = sub(b, a);
                let t = (dot(sub(place, a), d) / dot(d, d).max(1e-30)).clamp(0.0, 1.0);
                distance(place, add_scaled(a, d, t))
            })
            .fold(f64::INFINITY, f64::min)
    }
}

/// Puts nodes at the corners of a path in place of the vertices next to them.
fn place(lines: &mut LineGraph, path: &Path, course: &Course, corners: &[Corner]) {
    let count = path.vertices.len();
    let is_end = |i: usize| !course.closed && (i == 0 || i + 1 == count);
    let (mut spoilt, mut is_corner) = (vec![false; count], vec![false; count]);
    for corner in corners {
        course.around(corner.at, corner.spoilt).into_iter().for_each(|i| spoilt[i] = true);
        is_corner[corner.at] = true;
    }
    let kept: Vec<u32> =
        (0..count).filter(|&i| is_end(i) || is_corner[i] || !spoilt[i]).map(|i| path.vertices[i]).collect();
    if corners.is_empty() || (course.closed && kept.len() < 3) {
        return;
    }
    for corner in corners {
        let vertex = path.vertices[corner.at];
        lines.positions[vertex as usize] = corner.position;
        lines.corner[vertex as usize] = 0.0;
        lines.nodes.push(vertex);
    }
    let around = |row: &[u32]| row.windows(2).map(|w| (w[0], w[1])).collect::<Vec<_>>();
    let closing = |row: &[u32]| course.closed.then(|| (row[row.len() - 1], row[0]));
    around(&path.vertices)
        .into_iter()
        .chain(closing(&path.vertices))
        .for_each(|(a, b)| lines.remove_edge(a, b));
    around(&kept).into_iter().chain(closing(&kept)).for_each(|(a, b)| lines.add_edge(a, b));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rectangle as a loop of vertices `step` apart, the first `shift` along it.
    fn rectangle(sides: [f64; 2], step: f64, shift: f64) -> LineGraph {
        let [a, b] = sides;
        let round = 2.0 * (a + b);
        let at = |s: f64| match s.rem_euclid(round) {
            s if s < a => [s, 0.0, 0.0],
            s if s < a + b => [a, s - a, 0.0],
            s if s < 2.0 * a + b => [2.0 * a + b - s, b, 0.0],
            s => [0.0, round - s, 0.0],
        };
        let mut lines = LineGraph::default();
        let count = (round / step) as u32;
        for i in 0..count {
            lines.push_vertex(i, at(shift + f64::from(i) * step));
        }
        (0..count).for_each(|i| lines.add_edge(i, (i + 1) % count));
        lines
    }

    /// The corners that are kept where each is compared with all others.
    fn compared_with_all(course: &Course, turn_deg: f64) -> Vec<usize> {
        let seen = |i: usize| SIDES.iter().find_map(|&side| course.corner(i, side, turn_deg));
        let mut all: Vec<Corner> = (0..course.positions.len()).filter_map(seen).collect();
        all.sort_by(|a, b| a.ratio.total_cmp(&b.ratio).then(a.at.cmp(&b.at)));
        let least = |a: &Corner, b: &Corner| (a.spoilt + b.spoilt).max(CORNERS_APART);
        let mut kept: Vec<Corner> = Vec::new();
        for corner in all {
            if kept.iter().all(|k| course.apart(k.at, corner.at) >= least(k, &corner)) {
                kept.push(corner);
            }
        }
        kept.iter().map(|corner| corner.at).collect()
    }

    #[test]
    fn corners_are_compared_with_those_around_them_alone() {
        let unit = crate::Resolution { spacing: 1.0, noise: 0.0 }.into();
        let mut found = 0;
        for (step, shift) in [(0.7, 0.0), (0.7, 0.3), (1.0, 0.5), (1.3, 0.1), (1.0, 0.9)] {
            for sides in [[30.0, 4.0], [30.0, 8.0], [13.0, 12.0], [60.0, 50.0]] {
                let lines = rectangle(sides, step, shift);
                let course = Course::new(&lines, &paths(&lines)[0], unit, 4.0);
                let kept: Vec<usize> = course.corners(30.0).iter().map(|corner| corner.at).collect();
                assert_eq!(kept, compared_with_all(&course, 30.0), "{step} {shift} {sides:?}");
                found += kept.len();
            }
        }
        assert!(found > 50, "{found} corners");
        let lines = rectangle([50_000.0, 50_000.0], 1.0, 0.0);
        let course = Course::new(&lines, &paths(&lines)[0], unit, 4.0);
        assert_eq!((course.around(0, 8.0).len(), course.around(70_000, 8.0).len()), (15, 15));
    }

    #[test]
    fn corners_stay_beside_the_path_where_its_sides_are_nearly_parallel() {
        let unit = crate::Resolution { spacing: 1.0, noise: 0.0 }.into();
        // There and back on lines that part a little, around a rounded end.
        for lean in [0.0, 0.01, -0.01, 0.03, -0.03, 0.1] {
            let line = |k: i32, side: f64| [f64::from(k), side * (1.0 + lean * f64::from(k)), 0.0];
            let there = (0..=14).rev().map(|k| line(k, -1.0));
            let round = [[-0.7, -0.7, 0.0], [-1.0, 0.0, 0.0], [-0.7, 0.7, 0.0]];
            let path: Vec<[f64; 3]> = there.chain(round).chain((0..=14).map(|k| line(k, 1.0))).collect();
            let mut lines = LineGraph::default();
            for (i, &p) in (0..).zip(&path) {
                lines.push_vertex(i, p);
            }
            (1..path.len() as u32).for_each(|i| lines.add_edge(i - 1, i));
            corners(&mut lines, StripKind::Crease, unit, &RepairParams::default());
            for p in &lines.positions {
                let off = path.iter().map(|q| distance(*p, *q)).fold(f64::INFINITY, f64::min);
                assert!(off < 3.0, "{lean}: {p:?}");
            }
        }
    }

    #[test]
    fn a_loop_with_near_corners_stays_closed() {
        let mut found = 0;
        for step in [0.7, 1.0, 1.3] {
            for (shift, side) in
                (0..10).flat_map(|k| [4.0, 5.0, 6.0, 8.0].map(|side| (0.1 * f64::from(k), side)))
            {
                let mut lines = rectangle([30.0, side], step, shift);
                let unit = crate::Resolution { spacing: 1.0, noise: 0.0 }.into();
                corners(&mut lines, StripKind::Border, unit, &RepairParams::default());
                assert!(lines.edges.iter().all(|e| e.is_empty() || e.len() == 2), "{step} {shift} {side}");
                found += lines.nodes.len();
            }
        }
        assert!(found > 200, "{found} corners");
    }
}
