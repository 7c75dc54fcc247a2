//! Removes rungs: short links that a spanning graph leaves between two lines side by side (robust form).
//!
//! The rims of a plate or of a thin wall are lines of their own, a spacing or two apart. The minimum spanning graph joins
//! whatever it can reach (Gumhold 2001, section 3.2), so one edge leads from rim to rim; as both its ends lie on lines, no
//! pruning of branches finds it. A link is a rung if it is short, both lines pass its ends without a turn, and it has no row
//! of points of its own.

use crate::math::vec3::{distance, dot, sub, unit};
use crate::params::RepairParams;
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// Greatest number of edges of a rung: a longer row of points is a line of its own.
const MOST_EDGES: usize = 2;
/// Length of line on either side of a rung's end by which the line passes straight or not, spacings.
const TANGENT: f64 = 2.5;
/// Greatest turn of a line that passes straight.
const PASSING_DEG: f64 = 40.0;

/// Removes all rungs, the shortest first.
pub(crate) fn remove_rungs(lines: &mut LineGraph, scales: Scales, params: &RepairParams) {
    let h = |v: u32| scales.unit(lines.points[v as usize]);
    let mut rungs: Vec<(f64, Vec<u32>)> = (0..lines.edges.len() as u32)
        .filter(|&v| lines.edges[v as usize].len() == 3)
        .flat_map(|v| lines.edges[v as usize].iter().map(move |&w| (v, w)))
        .filter_map(|(v, w)| rung(lines, v, w, params.rung_spacings * h(v)))
        .filter(|(_, path)| path[0] < path[path.len() - 1])
        .collect();
    rungs.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
    for (_, path) in rungs {
        let ends = [(path[0], path[1]), (path[path.len() - 1], path[path.len() - 2])];
        if ends
            .iter()
            .all(|&(v, away)| passes(lines, v, away, TANGENT * scales.unit(lines.points[v as usize])))
        {
            path.windows(2).for_each(|e| lines.remove_edge(e[0], e[1]));
        }
    }
}

/// The path from junction `v` through `w` to the next junction, with its length, if it is short.
fn rung(lines: &LineGraph, v: u32, w: u32, longest: f64) -> Option<(f64, Vec<u32>)> {
    let mut path = vec![v, w];
    let mut length = 0.0;
    loop {
        let [before, at] = [path[path.len() - 2], path[path.len() - 1]];
        length += distance(lines.positions[before as usize], lines.positions[at as usize]);
        let next = &lines.edges[at as usize];
        if length > longest || at == v {
            return None;
        }
        match next.len() {
            3 => return Some((length, path)),
            2 if path.len() <= MOST_EDGES => path.push(if next[0] == before { next[1] } else { next[0] }),
            _ => return None,
        }
    }
}

/// Whether the line through `v`, apart from its edge to `away`, passes straight.
fn passes(lines: &LineGraph, v: u32, away: u32, reach: f64) -> bool {
    let through: Vec<u32> = lines.edges[v as usize].iter().copied().filter(|&w| w != away).collect();
    let [a, b] = through[..] else { return false };
    let [p, q] = [a, b].map(|w| unit(sub(ahead(lines, v, w, reach), lines.positions[v as usize])));
    -dot(p, q) >= PASSING_DEG.to_radians().cos()
}

/// The place of the line from `v` through `w` at the distance `reach`, or at its next junction.
fn ahead(lines: &LineGraph, v: u32, w: u32, reach: f64) -> [f64; 3] {
    let (mut before, mut at, mut length) = (v, w, 0.0);
    loop {
        length += distance(lines.positions[before as usize], lines.positions[at as usize]);
        let next = &lines.edges[at as usize];
        if length >= reach || next.len() != 2 || at == v {
            return lines.positions[at as usize];
        }
        (before, at) = (at, if next[0] == before { next[1] } else { next[0] });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two rows of vertices a spacing apart, `gap` from each other.
    fn rows(gap: f64) -> LineGraph {
        let mut lines = LineGraph::default();
        for row in 0..2 {
            for i in 0..20u32 {
                lines.push_vertex(row * 20 + i, [f64::from(i), f64::from(row) * gap, 0.0]);
            }
            (0..19).for_each(|i| lines.add_edge(row * 20 + i, row * 20 + i + 1));
        }
        lines
    }

    const UNIT: crate::Resolution = crate::Resolution { spacing: 1.0, noise: 0.0 };

    #[test]
    fn a_rung_between_two_rims_goes() {
        let mut lines = rows(1.5);
        lines.add_edge(9, 30);
        remove_rungs(&mut lines, UNIT.into(), &RepairParams::default());
        assert_eq!(lines.edge_count(), 38);
    }

    #[test]
    fn the_short_side_of_a_rectangle_stays() {
        let mut lines = rows(1.5);
        lines.add_edge(0, 20);
        lines.add_edge(19, 39);
        remove_rungs(&mut lines, UNIT.into(), &RepairParams::default());
        assert_eq!(lines.edge_count(), 40);
    }

    #[test]
    fn a_long_link_stays() {
        let mut lines = rows(6.0);
        lines.add_edge(9, 29);
        remove_rungs(&mut lines, UNIT.into(), &RepairParams::default());
        assert_eq!(lines.edge_count(), 39);
    }
}
