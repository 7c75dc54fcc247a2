//! Strips of the spanning graph that run over a flat face: ours.
//!
//! Where sampling is uneven, as where rows of points end at a wall, the neighbourhood of a point holds an edge that lies several
//! spacings away, and strips wander. Cross-sections tell that the face goes on straight there.

use crate::measure::Edgelet;
use crate::neighbors::Index;
use crate::pattern::{LineGraph, paths};
use crate::surface::Scales;

/// Distance from a flat place within which a strip lies on it, and from an edgelet within which it does not, in spacings.
const NEAR: (f64, f64) = (0.9, 1.5);
/// Least number of vertices, one after the other, on flat places.
const RUN: usize = 3;

/// Removes the stretches of strips that lie on `flat` places, away from all edgelets.
pub(super) fn remove(strips: &mut LineGraph, flat: &[[f64; 3]], edgelets: &[Edgelet], scales: Scales) {
    let folds: Vec<[f64; 3]> = edgelets.iter().map(|e| e.place).collect();
    let [flats, folds] = [flat, &folds].map(Index::build);
    let is_flat = |&v: &u32| {
        let (place, h) =
            (strips.positions[v as usize], scales.at(strips.points[v as usize] as usize).spacing);
        let any = |index: &Index, reach: f64| {
            let mut any = false;
            index.around(place, reach * h, |_| any = true);
            any
        };
        any(&flats, NEAR.0) && !any(&folds, NEAR.1)
    };
    let mut over: Vec<(u32, u32)> = Vec::new();
    for path in paths(strips) {
        let row: Vec<bool> = path.vertices.iter().map(is_flat).collect();
        let edges = path.edges();
        for run in runs(&row) {
            let within = |v: u32| path.vertices[run.clone()].contains(&v);
            over.extend(edges.iter().filter(|(a, b)| within(*a) || within(*b)));
        }
    }
    over.iter().for_each(|&(a, b)| strips.remove_edge(a, b));
}

/// Stretches of at least [`RUN`] vertices that lie on flat places.
fn runs(flat: &[bool]) -> Vec<std::ops::Range<usize>> {
    let mut runs = Vec::new();
    let mut from = 0;
    for to in 1..=flat.len() {
        if to == flat.len() || flat[to] != flat[from] {
            if flat[from] && to - from >= RUN {
                runs.push(from..to);
            }
            from = to;
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::resolution::Resolution;

    /// A strip along x with a vertex a spacing.
    fn strip(count: u32) -> LineGraph {
        let mut strip = LineGraph::default();
        for i in 0..count {
            strip.push_vertex(i, [f64::from(i), 0.0, 0.0]);
        }
        (1..count).for_each(|i| strip.add_edge(i - 1, i));
        strip
    }

    #[test]
    fn stretches_over_flat_places_go_unless_an_edgelet_is_near() {
        let edgelet = Edgelet {
            place: [5.0, 0.5, 0.0],
            point: 0,
            along: [1.0, 0.0, 0.0],
            arms: [[0.0, 1.0, 0.0], [0.0, 0.0, -1.0]],
            spacing: 1.0,
            deviation: 0.1,
            evidence: 100.0,
            reach: 9.0,
            radius: 0.0,
        };
        let flat: Vec<[f64; 3]> = (3..=7).map(|x| [f64::from(x), 0.6, 0.0]).collect();
        let left = |flat: &[[f64; 3]], edgelets: &[Edgelet]| {
            let mut strip = strip(12);
            remove(&mut strip, flat, edgelets, Resolution { spacing: 1.0, noise: 0.0 }.into());
            strip.edge_count()
        };
        assert_eq!(left(&flat, &[]), 5);
        assert_eq!(left(&flat, &[edgelet]), 11);
        assert_eq!(left(&flat[..2], &[]), 11);
        assert_eq!(left(&[], &[]), 11);
    }
}
