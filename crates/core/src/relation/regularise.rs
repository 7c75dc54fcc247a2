//! Imposes the relations of a network on its curves, by one joint least squares over all of them.
//!
//! Unknowns are the joints, and centre, radius and axis of each arc and circle; what a relation makes equal is one unknown. `rows` has the
//! observations, each curve with its covariance and each joint where it was, and the relations as conditions, among them that curves end on
//! their joints (`conditions`, each with its `cause`); `solve` finds the least squares. Where conditions contradict each other those that lack most are
//! released. `judge` holds the result against the noise: a curve that would leave what its points allow is released from its relations. Then all
//! is solved again. `place` lays the network on the result, `state` tells what holds.

mod cause;
mod conditions;
mod culprit;
mod doubts;
mod forces;
mod imposed;
mod judge;
mod layout;
mod order;
mod place;
mod row;
mod rows;
mod solve;
mod state;

use super::find::Found;
use super::relations::{Member, Regularised, Relation};
use crate::network::Network;
use cause::{Cause, Released};
use conditions::Conditions;
use culprit::SHARE;
use imposed::Imposed;
use layout::Layout;
use rows::System;
use std::collections::BTreeSet;

/// Rounds of solving and releasing.
const ROUNDS: usize = 60;

/// What was let go.
#[derive(Default)]
struct Let {
    /// Of the relations.
    released: Released,
    /// Features that count as not observed.
    unseen: BTreeSet<usize>,
}

/// Moves the curves and nodes of a network, of which each strip has points `spacing` apart, so that its relations hold. Returns these, each
/// with whether it is imposed, and what was moved.
pub(crate) fn regularise(
    network: &mut Network,
    found: &Found,
    spacing: &[f64],
    noise: f64,
) -> (Vec<Relation>, Regularised) {
    let doubt = doubts::doubts(network, found, spacing, noise);
    let mut gone = Let::default();
    for _ in 0..ROUNDS {
        let Let { released, unseen } = &gone;
        let imposed = Imposed::of(found, released);
        let layout = Layout::new(found, &imposed, unseen, network);
        let system = System { found, imposed: &imposed, layout: &layout, doubt: &doubt, unseen };
        let solution = solve::solve(&system);
        let offenders = match solution.holds {
            true => judge::offenders(&system, &solution.x),
            false => Vec::new(),
        };
        if solution.holds && offenders.is_empty() {
            let moved = place::place(network, &system, &solution.x);
            let relations = state::state(found, &imposed, &layout, &solution.x);
            return (relations, Regularised { released: left_out(found, released), ..moved });
        }
        let culprits = match solution.holds {
            true => culprit::culprits(&system, &solution.soft, &offenders),
            false => lacking(&solution.conditions),
        };
        if !gone.release(&culprits, &imposed) {
            break;
        }
    }
    let curves = network.strips.iter().map(|s| vec![0.0; s.curves.len()]).collect();
    let all = found.features.iter().map(|f| f.member).collect();
    let none = Regularised { nodes: vec![0.0; network.nodes.len()], curves, released: all };
    (found.relations(), none)
}

impl Let {
    /// Lets go what is at fault; whether there was anything.
    fn release(&mut self, culprits: &[Cause], imposed: &Imposed) -> bool {
        let mut any = false;
        for &cause in culprits {
            any |= match cause {
                Cause::Feature(i) if !imposed.has(i) => self.unseen.insert(i),
                _ => self.released.insert(cause),
            };
        }
        any
    }
}

/// What lacks most where conditions contradict each other.
fn lacking(conditions: &Conditions) -> Vec<Cause> {
    let all = || {
        let all = conditions.causes.iter().zip(&conditions.rows);
        all.filter(|c| *c.0 != Cause::Unit).map(|(&cause, row)| (cause, row.residual.abs()))
    };
    let worst = all().map(|c| c.1).fold(0.0, f64::max);
    all().filter(|c| c.1 >= SHARE * worst).map(|c| c.0).collect()
}

/// The curves that were left out of a relation.
fn left_out(found: &Found, released: &Released) -> Vec<Member> {
    let features: BTreeSet<usize> = released.iter().filter_map(|cause| cause.feature()).collect();
    features.into_iter().map(|i| found.features[i].member).collect()
}
