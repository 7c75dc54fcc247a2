//! Rings: whole circles from pieces of lines, where the faces beside them go all the way round. Ours.
//!
//! The rim of a hole is found in pieces: noise hides its wall here and there, and a direction that turns within a few spacings misleads
//! what looks along it. But a few pieces tell the circle, and then the points all around it can be seen in one cross-section.
//! `windows` takes circles from stretches of lines, `traces` fits them to all lines beside them, and `ground` asks the points: whether
//! two faces meet along the circle all the way round. `wall` goes along the wall of a ring to the rim at its other end. The rings
//! that hold take the place of the pieces in `place`.

mod ground;
mod place;
mod traces;
mod wall;
mod windows;

use crate::curve::Round;
use crate::math::vec3::dot;
use crate::neighbors::Index;
use crate::parallel;
use crate::pattern::LineGraph;
use crate::surface::Scales;
use ground::{Ground, Ring};
use traces::{Trace, Traces};
use wall::Wall;

/// Distance of centres, and difference of radii, within which two circles are one, in spacings: as traced along lines, and as
/// confirmed by points.
const SAME: (f64, f64) = (0.5, 1.2);
/// Least cosine between their normals.
const ALIGNED: f64 = 0.9;

/// Puts whole circles in the place of their pieces; local frame.
pub(crate) fn close(lines: &mut LineGraph, points: &[[f64; 3]], scales: Scales) {
    let traces = Traces::new(lines, scales);
    let circles = windows::circles(lines, scales);
    let traced =
        parallel::flat_map(circles.len(), parallel::TASK, |c, out| out.extend(traces.trace(circles[c])));
    let traced = distinct(traced, |t: &Trace| (t.round, SAME.0 * t.spacing), |t| t.share);
    if traced.is_empty() {
        return;
    }
    let index = Index::build(points);
    let ground = Ground { points, index: &index, scales };
    let confirmed = |round: Round, out: &mut Vec<Ring>| out.extend(ground.confirm(round));
    let mut rings =
        parallel::flat_map(traced.len(), parallel::TASK, |t, out| confirmed(traced[t].round, out));
    let others = parallel::flat_map(rings.len(), parallel::TASK, |r, out| {
        let walls = Wall::of(&rings[r], &ground);
        walls.iter().flat_map(|wall| wall.rims(&rings[r])).for_each(|round| confirmed(round, out));
    });
    rings.extend(others);
    let rings = distinct(rings, |r: &Ring| (r.round, SAME.1 * r.spacing), |r| -r.uneven);
    place::place(lines, rings, &ground);
}

/// The best of each group of circles that are one: `circle` gives each with the distance within which others are the same.
fn distinct<T>(all: Vec<T>, circle: impl Fn(&T) -> (Round, f64), worth: impl Fn(&T) -> f64) -> Vec<T> {
    let rounds: Vec<(Round, f64)> = all.iter().map(circle).collect();
    let centres: Vec<[f64; 3]> = rounds.iter().map(|(round, _)| round.centre).collect();
    let index = Index::build(&centres);
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by(|&a, &b| worth(&all[b]).total_cmp(&worth(&all[a])).then(a.cmp(&b)));
    let mut kept = vec![false; all.len()];
    for i in order {
        let (own, off) = rounds[i];
        let mut known = false;
        index.around(own.centre, off, |f| {
            let (other, _) = rounds[f.index as usize];
            let same =
                (own.radius - other.radius).abs() < off && dot(own.normal, other.normal).abs() > ALIGNED;
            known |= same && kept[f.index as usize];
        });
        kept[i] = !known;
    }
    all.into_iter().zip(kept).filter_map(|(one, kept)| kept.then_some(one)).collect()
}

#[cfg(test)]
mod tests;
