//! Which relations move curves too far: of those that a curve takes part in, or one that ends where it does, the one without which the squares of the
//! observations would be least. The curve that is moved most is not always that of the wrong relation.

use super::super::odds::bound;
use super::cause::Cause;
use super::forces::Forces;
use super::rows::System;
use std::collections::{BTreeMap, BTreeSet};

/// Share of the worst from which on others are released along with it.
pub(super) const SHARE: f64 = 0.5;

/// What to release where `offenders`, features with how many times too far each is moved, are too many. `soft` are unknowns at which
/// conditions give way.
pub(super) fn culprits(system: &System, soft: &[f64], offenders: &[(usize, f64)]) -> Vec<Cause> {
    let worst = offenders.iter().map(|o| o.1).fold(0.0, f64::max);
    let most = offenders.iter().filter(|o| o.1 >= SHARE * worst).map(|o| o.0);
    let Some(forces) = Forces::new(system, soft) else { return most.map(Cause::Feature).collect() };
    let mut rows: BTreeMap<Cause, Vec<usize>> = BTreeMap::new();
    for (k, &cause) in forces.conditions().causes.iter().enumerate().filter(|c| *c.1 != Cause::Unit) {
        rows.entry(cause).or_default().push(k);
    }
    let mut at: BTreeMap<usize, BTreeSet<Cause>> = BTreeMap::new();
    for (&cause, rows) in &rows {
        for (unknown, _) in rows.iter().flat_map(|&k| &forces.conditions().rows[k].terms) {
            at.entry(*unknown).or_default().insert(cause);
        }
    }
    let mut gains: BTreeMap<Cause, f64> = BTreeMap::new();
    let mut found = BTreeSet::new();
    for i in most {
        let near = own(system, i).into_iter().filter_map(|unknown| at.get(&unknown)).flatten().copied();
        let near: BTreeSet<Cause> = near.collect();
        let best = near
            .into_iter()
            .map(|cause| (*gains.entry(cause).or_insert_with(|| forces.gain(&rows[&cause])), cause))
            .max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
        // Where no relation explains it, the curve itself is let go; and a curve that does not fit one relation is no measure for others.
        let culprit = best.filter(|b| b.0 > bound(1)).map_or(Cause::Feature(i), |b| b.1);
        found.insert(culprit.feature().map_or(culprit, Cause::Feature));
    }
    found.into_iter().collect()
}

/// The unknowns that a feature has, or the joints at its ends.
fn own(system: &System, i: usize) -> Vec<usize> {
    let layout = system.layout;
    let joints = system.ends(i).into_iter().flatten().map(|j| layout.joint[j]);
    joints.chain(layout.centre[i]).chain(layout.radius[i]).collect()
}
