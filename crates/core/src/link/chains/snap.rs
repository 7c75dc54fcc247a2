//! Strips moved onto the chains beside them.

use super::Chain;
use super::samples::Samples;
use crate::math::vec3::{dot, norm, sub};
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// Greatest distance by which a vertex moves, in spacings.
const REACH: f64 = 1.0;
/// Least cosine between the directions of strip and chain.
const ALIGNED: f64 = 0.8;

/// Moves vertices of strips beside a chain of the same direction onto it; junctions stay.
pub(super) fn snap(lines: &mut LineGraph, chains: &[Chain], scales: Scales) {
    let samples = Samples::new(chains.iter().flat_map(segments));
    let places: Vec<[f64; 3]> = (0..lines.positions.len())
        .map(|v| {
            let own = lines.positions[v];
            let Some(along) = direction(lines, v) else { return own };
            let reach = REACH * scales.at(lines.points[v] as usize).spacing;
            let aligned = |s: usize| dot(samples.along[s], along).abs() > ALIGNED * norm(along);
            samples.nearest(own, reach, aligned).map_or(own, |s| samples.places[s])
        })
        .collect();
    lines.positions = places;
}

/// The segments of a chain with the spacing there.
fn segments<'a>(chain: &'a Chain) -> impl Iterator<Item = ([f64; 3], [f64; 3], f64)> + 'a {
    let members = &chain.members;
    let closing = chain.closed.then(|| [members[members.len() - 1], members[0]]);
    let pairs = members.windows(2).map(|w| [w[0], w[1]]).chain(closing);
    pairs.map(|[a, b]| (a.place, b.place, a.spacing))
}

/// The direction of a strip at a vertex; `None` at junctions and lone vertices.
fn direction(lines: &LineGraph, v: usize) -> Option<[f64; 3]> {
    match lines.edges[v][..] {
        [a] => Some(sub(lines.positions[a as usize], lines.positions[v])),
        [a, b] => Some(sub(lines.positions[b as usize], lines.positions[a as usize])),
        _ => None,
    }
}
