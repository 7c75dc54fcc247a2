//! Borders along creases: ours.
//!
//! At the rim of a hole the points of a face end, and where the wall of the hole holds few points they show a border, a fraction of a
//! spacing beside the crease. A surface that is folded there does not end there.

use crate::math::vec3::{add_scaled, distance, sub};
use crate::neighbors::Index;
use crate::pattern::{LineGraph, Path, Pattern, paths};
use crate::surface::Scales;

/// Greatest distance of the vertices of a border from the crease along it, spacings.
const BESIDE: f64 = 0.75;
/// Distance between the places looked at on a crease, spacings, and the greatest number of them on an edge.
const STEP: f64 = 0.5;
const PIECES: f64 = 256.0;

/// Removes each border with two loose ends all of which runs along creases, once these are whole.
pub(crate) fn unborder(pattern: &mut Pattern, scales: Scales) {
    let Pattern { crease, border, .. } = pattern;
    let index = Index::build(&places(crease, scales));
    let gap = |border: &LineGraph, v: u32| {
        let mut found = Vec::new();
        index.nearest(border.positions[v as usize], 1, &mut found);
        found.first().map_or(f64::INFINITY, |nearest| nearest.distance2.sqrt())
    };
    let beside =
        |border: &LineGraph, v: u32| gap(border, v) <= BESIDE * scales.unit(border.points[v as usize]);
    // A crease that was led on to a border has a vertex at its place.
    let meets = |border: &LineGraph, v: u32| gap(border, v) == 0.0;
    let loose = |v: u32| border.edges[v as usize].len() == 1 && !meets(border, v);
    let double = |path: &Path| {
        path.ends.is_some_and(|ends| ends.into_iter().all(loose))
            && path.vertices.iter().all(|&v| beside(border, v))
    };
    let doubles: Vec<Path> = paths(border).into_iter().filter(double).collect();
    doubles.iter().for_each(|path| path.remove_from(border));
}

/// Places along all edges of a graph.
fn places(lines: &LineGraph, scales: Scales) -> Vec<[f64; 3]> {
    let mut places = Vec::new();
    for (a, edges) in (0u32..).zip(&lines.edges) {
        for &b in edges.iter().filter(|&&b| b > a) {
            let [from, to] = [a, b].map(|v| lines.positions[v as usize]);
            let step = STEP * scales.between(lines.points[a as usize], lines.points[b as usize]);
            let pieces = (distance(from, to) / step).ceil().clamp(1.0, PIECES) as u32;
            let share = |k: u32| f64::from(k) / f64::from(pieces);
            places.extend((0..=pieces).map(|k| add_scaled(from, sub(to, from), share(k))));
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::resolution::Resolution;

    /// A line of some spacings along x from a place.
    fn line(from: [f64; 3], length: u32) -> LineGraph {
        let mut lines = LineGraph::default();
        for i in 0..=length {
            lines.push_vertex(0, [from[0] + f64::from(i), from[1], from[2]]);
        }
        (1..=length).for_each(|i| lines.add_edge(i - 1, i));
        lines
    }

    fn left(aside: f64, length: u32) -> usize {
        let mut crease = line([0.0; 3], 1);
        crease.positions[1] = [20.0, 0.0, 0.0];
        let mut pattern = Pattern { crease, border: line([5.3, aside, 0.0], length), ..Pattern::default() };
        unborder(&mut pattern, Resolution { spacing: 1.0, noise: 0.0 }.into());
        pattern.border.edge_count()
    }

    #[test]
    fn a_border_along_a_crease_goes() {
        assert_eq!(left(0.3, 8), 0);
    }

    #[test]
    fn one_farther_away_and_one_that_leads_on_stay() {
        assert_eq!(left(1.2, 8), 8);
        assert_eq!(left(0.3, 18), 18);
    }
}
