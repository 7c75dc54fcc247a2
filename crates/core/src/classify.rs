//! Classes of the points, from the network.

use std::ops::Range;

use crate::math::trees::boxes::{Boxes, Extent};
use crate::math::vec3::{add_scaled, distance2, dot, sub};
use crate::measure::Class;
use crate::neighbors::Index;
use crate::network::{Network, Strip, StripKind};
use crate::parallel;
use crate::surface::Scales;

/// Greatest distance of a point on a line from it, in spacings at the point. On a square lattice the next row, which is not on the
/// line, lies at .88 spacings, the spacing being the mean distance to the six nearest.
const ON_LINE: f64 = 0.85;
/// Segments of a strip in one box: a tree over every segment would take longer than all searches in it.
const ROW: usize = 8;
/// Boxes are as exact as their numbers: this share more is looked at.
const ROUNDING: f64 = 1e-9;

/// `(N)` class of every point: near a node, near a strip, or neither. Network and points in the local frame, sources as canonical
/// indices.
pub fn classes(points: &[[f64; 3]], network: &Network, scales: Scales) -> Vec<Class> {
    classes_of(points, scales, network, scales)
}

/// As [`classes`], of points with their own `scales`, where `sources` are those of the points that the sources of the network name.
pub(crate) fn classes_of(
    points: &[[f64; 3]],
    scales: Scales,
    network: &Network,
    sources: Scales,
) -> Vec<Class> {
    let lines = Lines::new(network, sources);
    let bound = |i: u32| (ON_LINE * scales.cautious(i)).powi(2);
    let mut classes = parallel::map(points.len(), parallel::QUICK, |i| {
        lines.first_near(points[i], bound(i as u32)).map_or(Class::Smooth, |s| s.class)
    });
    let index = Index::build(points);
    let mut found = Vec::new();
    for node in &network.nodes {
        index.within(node.position, ON_LINE * sources.cautious(node.source), &mut found);
        for f in found.iter().filter(|f| f.distance2 <= bound(f.index)) {
            classes[f.index as usize] = Class::Corner;
        }
    }
    classes
}

/// A piece of a strip.
struct Segment {
    from: [f64; 3],
    to: [f64; 3],
    /// Greatest distance of the points that it can have: a sparse place beside a dense strip has none.
    reach: f64,
    class: Class,
}

impl Segment {
    /// Whether a point lies within the squared distance `bound`, and in the ball about the segment.
    fn holds(&self, p: [f64; 3], bound: f64) -> bool {
        let middle = [0, 1, 2].map(|c| 0.5 * (self.from[c] + self.to[c]));
        let radius = self.reach + 0.5 * distance2(self.from, self.to).sqrt();
        distance2(p, middle) <= radius * radius && segment_distance2(p, self.from, self.to) <= bound
    }
}

/// The pieces of a strip, the closing one of a loop included.
fn segments(strip: &Strip, scales: Scales) -> impl Iterator<Item = Segment> {
    let class = match strip.kind {
        StripKind::Crease => Class::Crease,
        StripKind::Border => Class::Border,
        StripKind::Rounded => Class::Smooth,
    };
    let reach = ON_LINE * scales.widest(&strip.sources);
    let closing = strip.closed.then(|| [strip.points[strip.points.len() - 1], strip.points[0]]);
    let pairs = strip.points.windows(2).map(|w| [w[0], w[1]]).chain(closing);
    pairs.map(move |[from, to]| Segment { from, to, reach, class })
}

/// The pieces of all strips, in rows under a tree of boxes.
struct Lines {
    segments: Vec<Segment>,
    rows: Vec<Range<usize>>,
    boxes: Boxes<3>,
}

impl Lines {
    fn new(network: &Network, scales: Scales) -> Lines {
        let (mut all, mut rows) = (Vec::new(), Vec::new());
        for strip in network.strips.iter().filter(|s| s.kind != StripKind::Rounded) {
            let first = all.len();
            all.extend(segments(strip, scales));
            rows.extend((first..all.len()).step_by(ROW).map(|row| row..(row + ROW).min(all.len())));
        }
        let ends = |row: &Range<usize>| all[row.clone()].iter().flat_map(|s| [s.from, s.to]);
        let boxes = Boxes::new(rows.iter().map(|row| Extent::of(ends(row))));
        Lines { segments: all, rows, boxes }
    }

    /// The first segment within the squared distance `bound` of a point.
    fn first_near(&self, p: [f64; 3], bound: f64) -> Option<&Segment> {
        let mut first: Option<usize> = None;
        self.boxes.near(p, bound * (1.0 + ROUNDING), |row| {
            let Range { start, end } = self.rows[row as usize].clone();
            let before = first.map_or(end, |f| f.min(end));
            first = (start..before).find(|&i| self.segments[i].holds(p, bound)).or(first);
            bound * (1.0 + ROUNDING)
        });
        first.map(|i| &self.segments[i])
    }
}

fn segment_distance2(p: [f64; 3], a: [f64; 3], b: [f64; 3]) -> f64 {
    let (ab, ap) = (sub(b, a), sub(p, a));
    let length2 = dot(ab, ab);
    let t = if length2 > 0.0 { (dot(ap, ab) / length2).clamp(0.0, 1.0) } else { 0.0 };
    distance2(p, add_scaled(a, ab, t))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strip(kind: StripKind, points: Vec<[f64; 3]>) -> Strip {
        Strip {
            kind,
            closed: false,
            start: None,
            end: None,
            points,
            curve: Default::default(),
            sources: vec![0],
            fold_deg: None,
            evidence: None,
            deviation: 0.0,
            confidence: 1.0,
            sigma: Vec::new(),
            blend: None,
            curves: Vec::new(),
        }
    }

    #[test]
    fn the_first_line_within_reach_gives_the_class_wherever_it_is_near() {
        let mut rng = crate::shapes::Rng::new(3);
        let mut place = || [0, 1, 2].map(|_| rng.between(0.0, 10.0));
        let kinds = [StripKind::Crease, StripKind::Border];
        let strips = (0..20).map(|k| strip(kinds[k % 2], (0..k + 2).map(|_| place()).collect())).collect();
        let network = Network { strips, ..Network::default() };
        let points: Vec<[f64; 3]> = (0..2000).map(|_| place()).collect();
        let unit = crate::Resolution { spacing: 1.0, noise: 0.0 };
        let near = |p: &[f64; 3]| {
            let of = |s: &&Strip| {
                s.points.windows(2).any(|w| segment_distance2(*p, w[0], w[1]) <= ON_LINE * ON_LINE)
            };
            network.strips.iter().find(of).map_or(Class::Smooth, |s| match s.kind {
                StripKind::Crease => Class::Crease,
                StripKind::Border => Class::Border,
                StripKind::Rounded => Class::Smooth,
            })
        };
        assert_eq!(classes(&points, &network, unit.into()), points.iter().map(near).collect::<Vec<_>>());
    }

    #[test]
    fn long_segments_are_looked_at_by_the_points_beside_them_alone() {
        // The ball about each segment holds most of the points.
        let count = 40_000u32;
        let line = |k: u32| {
            let kind = if k.is_multiple_of(2) { StripKind::Crease } else { StripKind::Border };
            strip(kind, vec![[0.0, f64::from(k), 0.0], [f64::from(count), f64::from(k), 0.0]])
        };
        let network = Network { strips: (0..count).map(line).collect(), ..Network::default() };
        let points: Vec<[f64; 3]> = (0..count)
            .flat_map(|k| [0.84, 0.86].map(|z| [f64::from(count - k) * 0.7, f64::from(k), z]))
            .collect();
        let unit = crate::Resolution { spacing: 1.0, noise: 0.0 };
        let classes = classes(&points, &network, unit.into());
        for (k, pair) in classes.chunks(2).enumerate() {
            let on = if k % 2 == 0 { Class::Crease } else { Class::Border };
            assert_eq!(pair, [on, Class::Smooth]);
        }
    }
}
