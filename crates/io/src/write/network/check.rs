//! Conditions on a network before any of it is written.

use lineament::Network;

/// Indices lead somewhere, coordinates are finite, ends and nodes agree.
pub(in crate::write) fn check(network: &Network) -> Result<(), String> {
    let finite = |p: &[f64; 3]| p.iter().all(|c| c.is_finite());
    if let Some(id) = network.nodes.iter().position(|node| !finite(&node.position)) {
        return Err(format!("node {id} lies at {:?}", network.nodes[id].position));
    }
    for (id, strip) in network.strips.iter().enumerate() {
        if let Some(point) = strip.points.iter().find(|point| !finite(point)) {
            return Err(format!("strip {id} runs through {point:?}"));
        }
        let ends = [strip.start, strip.end];
        if ends.iter().any(|end| end.is_none() != strip.closed) {
            return Err(format!("strip {id} has closed = {} and the ends {ends:?}", strip.closed));
        }
        if let Some(end) = ends.iter().flatten().find(|&&end| end as usize >= network.nodes.len()) {
            return Err(format!("strip {id} ends at node {end} of {}", network.nodes.len()));
        }
    }
    Ok(())
}
