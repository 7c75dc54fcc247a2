//! What must hold of a result before any of it is written.

use super::PointTable;
use lineament::Network;

/// Indices lead somewhere, coordinates are finite, ends and nodes agree.
pub(super) fn network(network: &Network) -> Result<(), String> {
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

/// All columns have one value a point.
pub(super) fn points(table: &PointTable) -> Result<(), String> {
    let count = table.cloud.len();
    if table.classes.len() != count {
        return Err(format!("{} classes for {count} points", table.classes.len()));
    }
    if !table.scores.is_empty() && table.scores.len() != count {
        return Err(format!("{} scores for {count} points", table.scores.len()));
    }
    match table.cloud.attributes.iter().find(|a| a.values.len() != count) {
        Some(a) => Err(format!("attribute `{}` has {} values for {count} points", a.name, a.values.len())),
        None => Ok(()),
    }
}
