//! Stretches of chains that no strip follows become strips.

use super::Chain;
use super::join::extent;
use super::samples::Samples;
use crate::measure::{Edgelet, Evidence};
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// Distance from every strip at which an edgelet is free, in spacings.
const CLEAR: f64 = 0.5;
/// Least length of a free stretch, in spacings.
const LENGTH: f64 = 4.0;
/// Evidence at which an edgelet is as likely right as wrong.
const EVEN: f64 = 50.0;

/// Adds the free stretches of all chains.
pub(super) fn add(lines: &mut LineGraph, chains: &[Chain], scales: Scales) {
    let samples = Samples::new(edges(lines, scales));
    for chain in chains {
        let free: Vec<bool> = chain
            .members
            .iter()
            .map(|e| samples.nearest(e.place, CLEAR * e.spacing, |_| true).is_none())
            .collect();
        if chain.closed && free.iter().all(|&f| f) {
            let added = add_run(lines, &chain.members);
            lines.add_edge(added[0], added[added.len() - 1]);
            continue;
        }
        for run in runs(&chain.members, &free) {
            if extent(run) >= LENGTH * run[0].spacing {
                add_run(lines, run);
            }
        }
    }
}

/// The edges of the lines, each once, with the spacing of the cloud there.
fn edges<'a>(
    lines: &'a LineGraph,
    scales: Scales<'a>,
) -> impl Iterator<Item = ([f64; 3], [f64; 3], f64)> + 'a {
    let all = lines.edges.iter().enumerate().flat_map(|(a, list)| list.iter().map(move |&b| (a, b as usize)));
    all.filter(|(a, b)| a < b).map(move |(a, b)| {
        (lines.positions[a], lines.positions[b], scales.at(lines.points[a] as usize).spacing)
    })
}

/// The free stretches of a row.
fn runs<'a>(members: &'a [Edgelet], free: &[bool]) -> Vec<&'a [Edgelet]> {
    let mut runs = Vec::new();
    let mut from = 0;
    for i in 0..=members.len() {
        if i == members.len() || !free[i] {
            if i > from {
                runs.push(&members[from..i]);
            }
            from = i + 1;
        }
    }
    runs
}

/// Adds a row of edgelets as a strip.
fn add_run(lines: &mut LineGraph, run: &[Edgelet]) -> Vec<u32> {
    let added: Vec<u32> = run
        .iter()
        .map(|e| {
            let v = lines.push_vertex(e.point, e.place);
            let doubt = EVEN * EVEN / (EVEN * EVEN + e.evidence * e.evidence);
            lines.penalty[v as usize] = Some(doubt as f32);
            let shown = e.evidence as f32;
            let fold = e.turn() as f32;
            lines.evidence[v as usize] = Some(Evidence { sharp: shown, expected: shown, fold });
            v
        })
        .collect();
    added.windows(2).for_each(|w| lines.add_edge(w[0], w[1]));
    added
}
