//! Creases on blends: ours.
//!
//! A rounded edge is no crease, but where its radius is small beside the spacing it passes for one over some stretches. Where cross-sections show
//! the whole round, from face to face, its creases go.

use crate::math::vec3::{add_scaled, dot, norm, scale, sub, unit};
use crate::measure::Edgelet;
use crate::neighbors::Index;
use crate::pattern::{LineGraph, Path, paths};

/// Greatest distance of a place on a round along the edge from one of its edgelets, from the arc, and beyond its ends, spacings.
const BESIDE: (f64, f64, f64) = (1.5, 0.9, 0.5);
/// Least cosine between a crease on a round and the edge.
const ALONG: f64 = 0.6;

/// Removes the creases along rounds, and what these leave of others there. `blends` are the edgelets of rounded edges.
pub(super) fn remove(lines: &mut LineGraph, blends: &[Edgelet]) {
    let rounds = Rounds::new(blends);
    let mut cut = vec![false; lines.edges.len()];
    let on: Vec<Option<[f64; 3]>> = (0..lines.edges.len())
        .map(|v| (!lines.edges[v].is_empty()).then(|| rounds.at(lines.positions[v])).flatten())
        .collect();
    for a in 0..lines.edges.len() as u32 {
        for b in lines.edges[a as usize].clone().into_iter().filter(|&b| b > a) {
            let ends = [a, b].map(|v| v as usize);
            let direction = unit(sub(lines.positions[ends[1]], lines.positions[ends[0]]));
            let along = |v: usize| on[v].is_some_and(|edge| dot(edge, direction).abs() >= ALONG);
            if ends.iter().all(|&v| along(v)) {
                lines.remove_edge(a, b);
                ends.iter().for_each(|&v| cut[v] = true);
            }
        }
    }
    let loose = |v: u32, lines: &LineGraph| lines.edges[v as usize].len() == 1;
    let rest = |path: &Path, lines: &LineGraph| {
        path.vertices.iter().all(|&v| on[v as usize].is_some())
            && path.ends.is_none_or(|ends| ends.iter().any(|&v| loose(v, lines) || cut[v as usize]))
    };
    let gone: Vec<Path> = paths(lines).into_iter().filter(|p| rest(p, lines)).collect();
    gone.iter().for_each(|path| path.remove_from(lines));
}

/// The rounds of rounded edges, to look up places on them.
struct Rounds<'a> {
    blends: &'a [Edgelet],
    index: Index,
    reach: f64,
}

impl Rounds<'_> {
    fn new(blends: &[Edgelet]) -> Rounds<'_> {
        let places: Vec<[f64; 3]> = blends.iter().map(|e| e.place).collect();
        let far = |e: &Edgelet| (e.tangent() + e.spacing).hypot(BESIDE.0 * e.spacing);
        Rounds { blends, index: Index::build(&places), reach: blends.iter().map(far).fold(0.0, f64::max) }
    }

    /// The direction of the edge whose round a place lies on.
    fn at(&self, place: [f64; 3]) -> Option<[f64; 3]> {
        let mut near = Vec::new();
        self.index.around(place, self.reach, |f| near.push((f.distance2, f.index as usize)));
        near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        near.iter().map(|n| &self.blends[n.1]).find(|e| on_round(e, place)).map(|e| e.along)
    }
}

/// Whether a place lies on the round beside an edgelet of its design edge.
fn on_round(e: &Edgelet, place: [f64; 3]) -> bool {
    let (aside, off, beyond) = BESIDE;
    let d = sub(place, e.place);
    let along = dot(d, e.along);
    let across = add_scaled(d, e.along, -along);
    let touch = e.tangent();
    let [a, b] = e.arms;
    let inwards = unit(add_scaled(a, b, 1.0));
    let centre = scale(inwards, touch.hypot(e.radius));
    along.abs() <= aside * e.spacing
        && e.arms.iter().all(|&arm| dot(across, arm) <= touch + beyond * e.spacing)
        && (norm(sub(across, centre)) - e.radius).abs() <= off * e.spacing
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rounded edge along x with radius 3, its faces at right angles.
    fn round() -> Vec<Edgelet> {
        let at = |x: i32| Edgelet {
            place: [f64::from(x), 0.0, 0.0],
            point: 0,
            along: [1.0, 0.0, 0.0],
            arms: [[0.0, 1.0, 0.0], [0.0, 0.0, -1.0]],
            spacing: 1.0,
            deviation: 0.1,
            evidence: 9.0,
            reach: 7.0,
            radius: 3.0,
        };
        (0..=20).map(at).collect()
    }

    /// The edges left of a line through places.
    fn left(places: &[[f64; 3]]) -> usize {
        let mut lines = LineGraph::default();
        for (i, &p) in (0..).zip(places) {
            lines.push_vertex(i, p);
            if i > 0 {
                lines.add_edge(i - 1, i);
            }
        }
        remove(&mut lines, &round());
        lines.edge_count()
    }

    #[test]
    fn creases_along_a_round_go() {
        // The middle of the round lies 3 (1 - 1 / sqrt 2) from both faces.
        let off = 3.0 * (1.0 - 0.5_f64.sqrt());
        let row: Vec<[f64; 3]> = (2..18).map(|x| [f64::from(x), off, -off]).collect();
        assert_eq!(left(&row), 0);
        // On the other side of a sheet, and beyond the end of the edge.
        let behind: Vec<[f64; 3]> = row.iter().map(|p| [p[0], p[1] + 1.5, p[2] - 1.5]).collect();
        assert_eq!(left(&behind), 15);
        let beyond: Vec<[f64; 3]> = row.iter().map(|p| [p[0] + 30.0, p[1], p[2]]).collect();
        assert_eq!(left(&beyond), 15);
    }

    #[test]
    fn a_crease_across_stays() {
        let across: Vec<[f64; 3]> = (0..8).map(|y| [10.0, 4.0 + f64::from(y), 0.0]).collect();
        let arc = (1..6).map(|k| {
            let angle = 0.25 * f64::from(k);
            [10.0, 3.0 * (1.0 - angle.sin()), 3.0 * (angle.cos() - 1.0)]
        });
        let row: Vec<[f64; 3]> = across.into_iter().rev().chain(arc).collect();
        assert_eq!(left(&row), 12);
    }
}
