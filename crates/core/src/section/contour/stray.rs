//! Strays left out: short open chains, and open ones that run along a longer chain.

use super::chain::Chain;
use crate::math::trees::kd::Tree;

/// Fewest vertices of an open chain.
const FEWEST_VERTICES: usize = 4;

/// The chains but for strays, longest first. A chain along one of the `settled` is a stray too.
pub(crate) fn dropped(mut chains: Vec<Chain>, settled: &[Chain], shortest: f64) -> Vec<Chain> {
    chains.sort_by_cached_key(|c| std::cmp::Reverse(c.length().to_bits()));
    chains.retain(|c| c.closed || !(short(c, shortest) || weak(c)));
    if chains.iter().all(|c| c.closed) {
        return chains;
    }
    let mut owners = Vec::new();
    let mut places = Vec::new();
    for (k, chain) in chains.iter().chain(settled).enumerate() {
        places.extend(chain.vertices.iter().map(|v| v.at));
        owners.resize(places.len(), k);
    }
    let tree = Tree::new(&places);
    let mut kept = vec![false; chains.len()];
    kept.resize(chains.len() + settled.len(), true);
    for (k, chain) in chains.iter().enumerate() {
        // Longer chains have been judged.
        kept[k] = chain.closed || !runs_along(chain, &tree, |i| kept[owners[i as usize]]);
    }
    let mut kept = kept.into_iter();
    chains.retain(|_| kept.next().unwrap_or(false));
    chains
}

fn short(chain: &Chain, shortest: f64) -> bool {
    chain.vertices.len() < FEWEST_VERTICES || chain.length() < shortest * chain.spacing()
}

fn weak(chain: &Chain) -> bool {
    chain.vertices.iter().filter(|v| v.weak).count() * 2 > chain.vertices.len()
}

/// Whether seven of ten vertices lie within a spacing of others that count.
fn runs_along(chain: &Chain, tree: &Tree<2>, counts: impl Fn(u32) -> bool) -> bool {
    let mut found = Vec::new();
    let mut near = 0;
    for vertex in &chain.vertices {
        tree.within(vertex.at, vertex.spacing, &mut found);
        near += usize::from(found.iter().any(|&i| counts(i)));
    }
    near * 10 > chain.vertices.len() * 7
}
