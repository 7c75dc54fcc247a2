//! Imposes the relations of a network on its curves, by one joint least squares over all of them.
//!
//! Unknowns are the joints, and centre, radius and axis of each arc and circle; what a relation makes equal is one unknown. `rows` has the
//! observations, each curve with its covariance and each joint where it was, and the relations as conditions, among them that curves end on
//! their joints; `solve` finds the least squares. `judge` holds the result against the noise: a curve that would leave what its points
//! allow is released from its relations, and all is solved again. `place` lays the network on the result.

mod doubts;
mod imposed;
mod judge;
mod layout;
mod order;
mod place;
mod row;
mod rows;
mod solve;

use super::find::Found;
use super::relations::{Member, Regularised, Relation, RelationKind};
use crate::network::Network;
use imposed::Imposed;
use layout::Layout;
use rows::System;
use std::collections::BTreeSet;

/// Rounds of solving and releasing.
const ROUNDS: usize = 12;

/// Moves the curves and nodes of a network, of which each strip has points `spacing` apart, so that its relations hold. Returns these,
/// without the curves that were released, and what was moved.
pub(crate) fn regularise(
    network: &mut Network,
    found: &Found,
    spacing: &[f64],
    noise: f64,
) -> (Vec<Relation>, Regularised) {
    let doubt = doubts::doubts(network, found, spacing, noise);
    let (mut released, mut unseen) = (BTreeSet::new(), BTreeSet::new());
    for _ in 0..ROUNDS {
        let imposed = Imposed::of(found, &released);
        let layout = Layout::new(found, &imposed, &unseen, network);
        let system = System { found, imposed: &imposed, layout: &layout, doubt: &doubt, unseen: &unseen };
        let solved = solve::solve(&system);
        let offenders = judge::offenders(&system, solved.as_deref());
        if let (Some(x), true) = (&solved, offenders.is_empty()) {
            let moved = place::place(network, &system, x);
            return (kept(found, &released), Regularised { released: members(found, &released), ..moved });
        }
        let before = (released.len(), unseen.len());
        // Where there is no solution, arcs in no relation go along with their ends first: how far they bend may be what has none.
        // Then the less sure half goes.
        let offenders = match solved {
            Some(_) => offenders,
            None => match free_arcs(found, &imposed, &unseen) {
                arcs if arcs.is_empty() => unsure(found, offenders),
                arcs => arcs,
            },
        };
        for i in offenders {
            if !imposed.has(i) || !released.insert(i) {
                unseen.insert(i);
            }
        }
        if (released.len(), unseen.len()) == before {
            break;
        }
    }
    let curves = network.strips.iter().map(|s| vec![0.0; s.curves.len()]).collect();
    let none = Regularised { nodes: vec![0.0; network.nodes.len()], curves, released: Vec::new() };
    (found.relations(), none)
}

/// Arcs and circles that no relation holds and whose own points still do.
fn free_arcs(found: &Found, imposed: &Imposed, unseen: &BTreeSet<usize>) -> Vec<usize> {
    let free = |i: &usize| found.features[*i].round().is_some() && !imposed.has(*i) && !unseen.contains(i);
    (0..found.features.len()).filter(free).collect()
}

/// The half of features whose directions are known least.
fn unsure(found: &Found, mut of: Vec<usize>) -> Vec<usize> {
    of.sort_by(|&a, &b| found.features[b].doubt().total_cmp(&found.features[a].doubt()).then(a.cmp(&b)));
    of.truncate(of.len().div_ceil(2));
    of
}

fn members(found: &Found, released: &BTreeSet<usize>) -> Vec<Member> {
    released.iter().map(|&i| found.features[i].member).collect()
}

/// The relations that now hold, and those that are not imposed.
fn kept(found: &Found, released: &BTreeSet<usize>) -> Vec<Relation> {
    let out: BTreeSet<Member> = members(found, released).into_iter().collect();
    let settle = |mut relation: Relation| {
        if relation.kind == RelationKind::Symmetric {
            return Some(relation);
        }
        relation.members.retain(|m| !out.contains(m));
        relation.others.retain(|m| !out.contains(m));
        let facing = relation.kind == RelationKind::Perpendicular;
        let holds = if facing {
            !relation.members.is_empty() && !relation.others.is_empty()
        } else {
            relation.members.len() > 1
        };
        relation.imposed = true;
        holds.then_some(relation)
    };
    found.relations().into_iter().filter_map(settle).collect()
}
