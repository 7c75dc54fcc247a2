//! Classes of the points, from the network.

use crate::math::vec3::{add_scaled, distance2, dot, sub};
use crate::measure::Class;
use crate::neighbors::Index;
use crate::network::{Network, StripKind};
use crate::surface::Scales;

/// Greatest distance of a point on a line from it, in spacings at the point. On a square lattice the next row, which is not on the
/// line, lies at .88 spacings, the spacing being the mean distance to the six nearest.
const ON_LINE: f64 = 0.85;

/// `(N)` class of every point: near a node, near a strip, or neither. Network and points in the local frame, sources as canonical
/// indices.
pub fn classes(points: &[[f64; 3]], network: &Network, scales: Scales) -> Vec<Class> {
    let mut classes = vec![Class::Smooth; points.len()];
    let index = Index::build(points);
    let near = |i: u32, distance2: f64| distance2 <= (ON_LINE * scales.cautious(i)).powi(2);
    let mut found = Vec::new();
    for strip in &network.strips {
        let class = match strip.kind {
            StripKind::Crease => Class::Crease,
            StripKind::Border => Class::Border,
        };
        let reach = ON_LINE * scales.widest(&strip.sources);
        let closing = strip.closed.then(|| [strip.points[strip.points.len() - 1], strip.points[0]]);
        for [a, b] in strip.points.windows(2).map(|w| [w[0], w[1]]).chain(closing) {
            let middle = [0, 1, 2].map(|c| 0.5 * (a[c] + b[c]));
            let radius = reach + 0.5 * distance2(a, b).sqrt();
            index.within(middle, radius, &mut found);
            for f in &found {
                let own = &mut classes[f.index as usize];
                let away = || segment_distance2(points[f.index as usize], a, b);
                if *own == Class::Smooth && near(f.index, away()) {
                    *own = class;
                }
            }
        }
    }
    for node in &network.nodes {
        index.within(node.position, ON_LINE * scales.cautious(node.source), &mut found);
        for f in found.iter().filter(|f| near(f.index, f.distance2)) {
            classes[f.index as usize] = Class::Corner;
        }
    }
    classes
}

fn segment_distance2(p: [f64; 3], a: [f64; 3], b: [f64; 3]) -> f64 {
    let (ab, ap) = (sub(b, a), sub(p, a));
    let length2 = dot(ab, ab);
    let t = if length2 > 0.0 { (dot(ap, ab) / length2).clamp(0.0, 1.0) } else { 0.0 };
    distance2(p, add_scaled(a, ab, t))
}
