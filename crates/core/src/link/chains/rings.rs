//! Strips that are closed already stay whole, moved onto the chains beside them.
//!
//! A closed strip is better evidence than pieces of chains beside it: chains of a small hole break where noise hides its wall.

use super::chain::Chain;
use super::samples::Samples;
use crate::math::vec3::{dot, norm, sub};
use crate::measure::Edgelet;
use crate::pattern::{LineGraph, paths};
use crate::surface::Scales;

/// Greatest distance by which a vertex moves, in spacings.
const REACH: f64 = 1.0;
/// Least cosine between the directions of strip and chain.
const ALIGNED: f64 = 0.8;
/// Distance from every closed strip at which an edgelet belongs to another line, in spacings.
const CLEAR: f64 = 0.5;

/// `(V)` whether each vertex belongs to a closed strip; such vertices move onto the chains, which keep the stretches that lie
/// beside no closed strip.
pub(super) fn take(strips: &mut LineGraph, chains: &mut Vec<Chain>, scales: Scales) -> Vec<bool> {
    let mut closed = vec![false; strips.edges.len()];
    for path in paths(strips).iter().filter(|path| path.ends.is_none()) {
        path.vertices.iter().for_each(|&v| closed[v as usize] = true);
    }
    snap(strips, &closed, chains, scales);
    let samples = Samples::new(edges(strips, &closed, scales));
    let free = |e: &Edgelet| samples.nearest(e.place, CLEAR * e.spacing, |_| true).is_none();
    *chains = chains.iter().flat_map(|chain| chain.stretches(free)).collect();
    closed
}

/// Moves the vertices of closed strips beside a chain of the same direction onto it.
fn snap(strips: &mut LineGraph, closed: &[bool], chains: &[Chain], scales: Scales) {
    let samples = Samples::new(chains.iter().flat_map(Chain::segments));
    let moved = |v: usize| {
        let own = strips.positions[v];
        let [a, b] = strips.edges[v][..] else { return own };
        let along = sub(strips.positions[b as usize], strips.positions[a as usize]);
        let reach = REACH * scales.at(strips.points[v] as usize).spacing;
        let aligned = |s: usize| dot(samples.along[s], along).abs() > ALIGNED * norm(along);
        samples.nearest(own, reach, aligned).map_or(own, |s| samples.places[s])
    };
    let places = |v: usize| if closed[v] { moved(v) } else { strips.positions[v] };
    strips.positions = (0..closed.len()).map(places).collect();
}

/// The edges of closed strips, each once, with the spacing of the cloud there.
fn edges<'a>(
    strips: &'a LineGraph,
    closed: &'a [bool],
    scales: Scales<'a>,
) -> impl Iterator<Item = ([f64; 3], [f64; 3], f64)> + 'a {
    let lists = strips.edges.iter().enumerate().filter(|(a, _)| closed[*a]);
    let all = lists.flat_map(|(a, list)| list.iter().map(move |&b| (a, b as usize)));
    all.filter(|(a, b)| a < b).map(move |(a, b)| {
        (strips.positions[a], strips.positions[b], scales.at(strips.points[a] as usize).spacing)
    })
}
