//! Chains of edgelets beside the strips: strips are put on them, and chains that no strip follows become strips.

use super::chain::Chain;
use crate::detect::edgelets::knob;
use crate::math::vec3::{add_scaled, distance, dot, norm, sub};
use crate::neighbors::{Found, Index};
use crate::pattern::LineGraph;

/// Samples along the chains with their directions.
struct Samples {
    places: Vec<[f64; 3]>,
    along: Vec<[f64; 3]>,
}

fn samples(chains: &[Chain], h: f64) -> Samples {
    let mut s = Samples { places: Vec::new(), along: Vec::new() };
    for chain in chains {
        let mut line = chain.places.clone();
        if chain.closed {
            line.push(line[0]);
        }
        for w in line.windows(2) {
            let d = sub(w[1], w[0]);
            let n = (norm(d) / (0.1 * h)).ceil().max(1.0) as usize;
            for k in 0..n {
                s.places.push(add_scaled(w[0], d, k as f64 / n as f64));
                s.along.push(add_scaled([0.0; 3], d, 1.0 / norm(d).max(1e-12)));
            }
        }
    }
    s
}

pub(in crate::link) fn apply(lines: &mut LineGraph, index: &Index, chains: &[Chain], h: f64) {
    let samples = samples(chains, h);
    let mut found: Vec<Found> = Vec::new();
    if !samples.places.is_empty() && knob("SNAP", 1.0) > 0.0 {
        snap(lines, &samples, h);
    }
    let mut own: Vec<[f64; 3]> = Vec::new();
    for (a, list) in lines.edges.iter().enumerate() {
        for &b in list.iter().filter(|&&b| b as usize > a) {
            let (p, q) = (lines.positions[a], lines.positions[b as usize]);
            let n = (distance(p, q) / (0.1 * h)).ceil().max(1.0) as usize;
            own.extend((0..=n).map(|k| add_scaled(p, sub(q, p), k as f64 / n as f64)));
        }
    }
    let taken = (!own.is_empty()).then(|| Index::build(&own));
    let clear = knob("CLEAR", 0.5) * h;
    for chain in chains {
        let free: Vec<bool> = chain
            .places
            .iter()
            .map(|&p| {
                taken.as_ref().is_none_or(|t| {
                    t.within(p, clear, &mut found);
                    found.is_empty()
                })
            })
            .collect();
        let n = chain.places.len();
        let whole = chain.closed && free.iter().all(|&f| f);
        let mut i = 0;
        while i < n {
            if !free[i] {
                i += 1;
                continue;
            }
            let from = i;
            while i < n && free[i] {
                i += 1;
            }
            let run = &chain.places[from..i];
            let length: f64 = run.windows(2).map(|w| distance(w[0], w[1])).sum();
            if length < knob("RUN", 4.0) * h {
                continue;
            }
            let added: Vec<u32> = run
                .iter()
                .map(|&p| {
                    let mut near = Vec::new();
                    index.nearest(p, 1, &mut near);
                    let point = near.first().map_or(0, |f| f.index);
                    lines.push_vertex(point, p)
                })
                .collect();
            added.windows(2).for_each(|w| lines.add_edge(w[0], w[1]));
            if whole {
                lines.add_edge(added[0], added[added.len() - 1]);
            }
        }
    }
}

/// Vertices of strips beside a chain of the same direction move onto it.
fn snap(lines: &mut LineGraph, samples: &Samples, h: f64) {
    let index = Index::build(&samples.places);
    let mut found: Vec<Found> = Vec::new();
    let reach = knob("REACH", 1.0) * h;
    let moved: Vec<Option<[f64; 3]>> = (0..lines.positions.len())
        .map(|v| {
            let p = lines.positions[v];
            let list = &lines.edges[v];
            if list.len() > 2 || list.is_empty() {
                return None;
            }
            let ends = [list[0], *list.last()?].map(|w| lines.positions[w as usize]);
            let d = if list.len() == 2 { sub(ends[1], ends[0]) } else { sub(ends[0], p) };
            index.within(p, reach, &mut found);
            let best = found
                .iter()
                .filter(|f| dot(samples.along[f.index as usize], d).abs() > 0.8 * norm(d))
                .min_by(|a, b| a.distance2.total_cmp(&b.distance2).then(a.index.cmp(&b.index)))?;
            Some(samples.places[best.index as usize])
        })
        .collect();
    for (v, p) in moved.into_iter().enumerate() {
        if let Some(p) = p {
            lines.positions[v] = p;
        }
    }
}
