//! Classes of the points, from the network.

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
    let segments: Vec<Segment> = network.strips.iter().flat_map(|s| segments(s, sources)).collect();
    let boxes = Boxes::new(segments.iter().map(|s| Extent::of([s.from, s.to])));
    let bound = |i: u32| (ON_LINE * scales.cautious(i)).powi(2);
    let mut classes = parallel::map(points.len(), parallel::QUICK, |i| {
        first_near(&segments, &boxes, points[i], bound(i as u32)).map_or(Class::Smooth, |s| s.class)
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
    };
    let reach = ON_LINE * scales.widest(&strip.sources);
    let closing = strip.closed.then(|| [strip.points[strip.points.len() - 1], strip.points[0]]);
    let pairs = strip.points.windows(2).map(|w| [w[0], w[1]]).chain(closing);
    pairs.map(move |[from, to]| Segment { from, to, reach, class })
}

/// The first segment within the squared distance `bound` of a point.
fn first_near<'a>(segments: &'a [Segment], boxes: &Boxes<3>, p: [f64; 3], bound: f64) -> Option<&'a Segment> {
    let mut first = None;
    boxes.near(p, bound * (1.0 + ROUNDING), |i| {
        if first.is_none_or(|f| i < f) && segments[i as usize].holds(p, bound) {
            first = Some(i);
        }
        bound * (1.0 + ROUNDING)
    });
    first.map(|i| &segments[i as usize])
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

    #[test]
    fn long_segments_are_looked_at_by_the_points_beside_them_alone() {
        // The ball about each segment holds most of the points.
        let count = 40_000u32;
        let strip = |k: u32| Strip {
            kind: if k.is_multiple_of(2) { StripKind::Crease } else { StripKind::Border },
            closed: false,
            start: None,
            end: None,
            points: vec![[0.0, f64::from(k), 0.0], [f64::from(count), f64::from(k), 0.0]],
            curve: Default::default(),
            sources: vec![0],
            fold_deg: None,
            evidence: None,
            deviation: 0.0,
            confidence: 1.0,
            sigma: Vec::new(),
            curves: Vec::new(),
        };
        let network = Network { strips: (0..count).map(strip).collect(), ..Network::default() };
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
