//! Invariants of a network's nodes.

use super::verdict::{deviations, finite};
use crate::network::{Network, NodeKind};

pub(super) fn faults(network: &Network) -> Vec<String> {
    let mut degrees = vec![0u32; network.nodes.len()];
    for node in network.strips.iter().flat_map(|s| [s.start, s.end]).flatten() {
        if let Some(degree) = degrees.get_mut(node as usize) {
            *degree += 1;
        }
    }
    let mut faults = Vec::new();
    for (i, (node, degree)) in network.nodes.iter().zip(degrees).enumerate() {
        if !finite(&node.position) {
            faults.push(format!("node {i}: position {:?} is not finite", node.position));
        }
        if !node.sigma.iter().all(deviations) {
            faults.push(format!("node {i}: standard deviations {:?}", node.sigma));
        }
        if node.degree != degree {
            faults.push(format!("node {i}: degree {} but {degree} strip ends", node.degree));
        }
        if node.kind != NodeKind::of_degree(degree) {
            faults.push(format!("node {i}: kind {} with {degree} strip ends", node.kind.name()));
        }
    }
    faults.extend(shared_places(network));
    faults
}

fn shared_places(network: &Network) -> Vec<String> {
    // Adding zero turns -0 into 0, so that both sort as equal.
    let place = |i: usize| network.nodes[i].position.map(|x| x + 0.0);
    let order = |&i: &usize, &j: &usize| {
        let (a, b) = (place(i), place(j));
        a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(a[2].total_cmp(&b[2])).then(i.cmp(&j))
    };
    let mut ids: Vec<usize> = (0..network.nodes.len()).collect();
    ids.sort_by(order);
    let same = ids.windows(2).filter(|w| place(w[0]) == place(w[1]));
    same.map(|w| format!("nodes {} and {}: both at {:?}", w[0], w[1], place(w[0]))).collect()
}
