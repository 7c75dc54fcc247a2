//! Handles: lines that leave another one and come back to it close by: ours.
//!
//! Under noise the sections of one crease may show a narrow face along it, and its other edge makes a second line over a stretch.
//! The edges of a true narrow face have ends of their own, so that the way round over the other edge is the longer one.

use super::spanning::{Metric, Walker};
use crate::math::vec3::to_segment;
use crate::pattern::{LineGraph, Path, paths};
use crate::surface::Scales;

/// Greatest distance of a handle from the line beside it: spacings, and standard deviations of the noise besides.
const BESIDE: (f64, f64) = (1.1, 1.0);

/// Removes each line between two nodes beside which a shorter way leads from one to the other.
pub(super) fn remove(lines: &mut LineGraph, scales: Scales) {
    let metric = Metric::Lengths(scales);
    let length =
        |path: &Path| path.vertices.windows(2).map(|w| metric.length(lines, w[0], w[1])).sum::<f64>();
    let forks = |v: u32| lines.edges[v as usize].len() > 2;
    let open = |path: &Path| path.ends.is_some_and(|[a, b]| a != b && forks(a) && forks(b));
    let mut all: Vec<(f64, Path)> = paths(lines).into_iter().filter(open).map(|p| (length(&p), p)).collect();
    all.sort_by(|x, y| y.0.total_cmp(&x.0).then_with(|| x.1.vertices.cmp(&y.1.vertices)));
    let mut walker = Walker::new(lines.edges.len(), metric);
    for (length, path) in all {
        let [Some(&a), Some(&b)] = [path.vertices.first(), path.vertices.last()] else { continue };
        path.remove_from(lines);
        let way = walker.path(lines, a, b, length);
        if !way.is_some_and(|way| runs_beside(lines, &path, &way, scales)) {
            path.edges().into_iter().for_each(|(a, b)| lines.add_edge(a, b));
        }
    }
}

/// Whether every vertex of a path is near one of the way.
fn runs_beside(lines: &LineGraph, path: &Path, way: &[u32], scales: Scales) -> bool {
    let place = |v: u32| lines.positions[v as usize];
    path.vertices.iter().all(|&v| {
        let scale = scales.at(lines.points[v as usize] as usize);
        let reach = BESIDE.0 * scale.spacing + BESIDE.1 * scale.noise;
        way.windows(2).any(|w| to_segment(place(v), place(w[0]), place(w[1])) <= reach)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::resolution::Resolution;

    /// A line of 20 spacings along x, and another from its sixth to its sixteenth vertex, `aside` spacings away.
    fn handle(aside: f64) -> LineGraph {
        let mut lines = LineGraph::default();
        for i in 0..21 {
            lines.push_vertex(i, [f64::from(i), 0.0, 0.0]);
        }
        (1..21).for_each(|i| lines.add_edge(i - 1, i));
        let mut before = 5;
        for i in 6..15 {
            let next = lines.push_vertex(i, [f64::from(i), aside, 0.0]);
            lines.add_edge(before, next);
            before = next;
        }
        lines.add_edge(before, 15);
        lines
    }

    #[test]
    fn a_second_line_beside_one_goes_and_one_farther_away_stays() {
        let left = |aside: f64| {
            let mut lines = handle(aside);
            remove(&mut lines, Resolution { spacing: 1.0, noise: 0.0 }.into());
            lines.edge_count()
        };
        assert_eq!(left(0.8), 20);
        assert_eq!(left(3.0), 30);
    }

    #[test]
    fn a_handle_may_lie_farther_off_by_the_noise() {
        let left = |noise: f64| {
            let mut lines = handle(1.3);
            remove(&mut lines, Resolution { spacing: 1.0, noise }.into());
            lines.edge_count()
        };
        assert_eq!((left(0.0), left(0.3)), (30, 20));
    }

    #[test]
    fn the_edges_of_a_narrow_face_with_ends_stay() {
        let mut lines = LineGraph::default();
        for [x, y] in [[0, 0], [1, 0], [2, 0], [3, 0], [3, 1], [2, 1], [1, 1], [0, 1]] {
            lines.push_vertex(0, [f64::from(x), f64::from(y), 0.0]);
        }
        (0..8).for_each(|i| lines.add_edge(i, (i + 1) % 8));
        for (v, x) in [(0, -9.0), (3, 12.0), (4, 12.0), (7, -9.0)] {
            let end = lines.push_vertex(0, [x, 0.0, 5.0]);
            lines.add_edge(v, end);
        }
        let edges = lines.edge_count();
        remove(&mut lines, Resolution { spacing: 1.0, noise: 0.0 }.into());
        assert_eq!(lines.edge_count(), edges);
    }
}
