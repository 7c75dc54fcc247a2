//! Least squares under conditions, by Gauss-Newton steps with the method of multipliers (Hestenes 1969; Powell 1969): conditions have a great
//! weight, and what they still lack is added to their multipliers. Conditions that say the same twice do no harm.

use super::order::order;
use super::row::Row;
use super::rows::System;
use crate::math::sparse::Sparse;

/// Weight of a condition against that of the surest unknown.
const STIFF: f64 = 1e4;
/// Weight that keeps an unknown where nothing says anything of it, against that of the surest.
const RIDGE: f64 = 1e-10;
/// Most steps.
const STEPS: usize = 40;
/// Least share of a step that is taken: a full one may go round in a circle where conditions bend.
const SHORTEST: f64 = 1.0 / 64.0;
/// Share by which the sum may rise: rounding.
const SAME: f64 = 1e-9;
/// Times that a step is led back to the conditions.
const BENDS: usize = 2;
/// What a condition may lack, relative to the size of the network.
const REST: f64 = 1e-13;
/// Step, relative to that size, at which the fit has come to rest.
const STILL: f64 = 1e-7;
/// What a condition may lack in the end, in that of rest: rounding.
const ROUNDING: f64 = 30.0;

/// The unknowns of the least squares; `None` where the conditions contradict each other or the equations are singular.
pub(super) fn solve(system: &System) -> Option<Vec<f64>> {
    let mut x = system.layout.start.clone();
    let size = system.size();
    let (rows, conditions) = (system.observations(&x), system.conditions(&x));
    let all: Vec<Row> = rows.iter().chain(&conditions).cloned().collect();
    let (place, mut matrix) = order(&system.layout.blocks, x.len(), &all);
    let mut multipliers = vec![0.0; conditions.len()];
    for _ in 0..STEPS {
        let (rows, conditions) = (system.observations(&x), system.conditions(&x));
        let lacks = lacking(&conditions);
        let mut diagonal = vec![0.0; x.len()];
        rows.iter().flat_map(|r| &r.terms).for_each(|t| diagonal[t.0] += t.1 * t.1);
        let surest = diagonal.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let stiff = STIFF * surest;
        matrix.clear();
        let mut right = vec![0.0; x.len()];
        rows.iter().for_each(|r| add(&mut matrix, &mut right, &place, r, 1.0, r.residual));
        for (c, m) in conditions.iter().zip(&multipliers) {
            add(&mut matrix, &mut right, &place, c, stiff, m + stiff * c.residual);
        }
        (0..x.len()).for_each(|k| matrix.add(k, k, RIDGE * surest));
        if !matrix.factorise() {
            return None;
        }
        matrix.solve(&mut right);
        let step: Vec<f64> = place.iter().map(|&p| right[p]).collect();
        let greatest = step.iter().fold(0.0, |most: f64, s| most.max(s.abs()));
        if !greatest.is_finite() {
            return None;
        }
        if greatest <= STILL * size && lacks <= REST * size {
            return Some(x);
        }
        let pull = |x: &[f64]| pull(system, x, &multipliers, stiff);
        let bent = |x: Vec<f64>| bent_back(system, x, &conditions, &place, &matrix, stiff);
        let (before, mut share) = (pull(&x), 1.0);
        let mut next = bent(moved(system, &x, &step, share));
        while pull(&next) > before + SAME * before.abs() && share > SHORTEST {
            share *= 0.5;
            next = bent(moved(system, &x, &step, share));
        }
        for (c, m) in conditions.iter().zip(&mut multipliers) {
            let change: f64 = c.terms.iter().map(|t| t.1 * step[t.0]).sum();
            *m += stiff * (c.residual + share * change);
        }
        x = next;
    }
    let lacks = lacking(&system.conditions(&x));
    (lacks <= ROUNDING * REST * size).then_some(x)
}

/// The unknowns after a share of a step.
fn moved(system: &System, x: &[f64], step: &[f64], share: f64) -> Vec<f64> {
    let mut next: Vec<f64> = x.iter().zip(step).map(|(x, s)| x + share * s).collect();
    system.settle(&mut next);
    next
}

/// The unknowns after a step, led back to the conditions along which it was straight.
fn bent_back(
    system: &System,
    mut x: Vec<f64>,
    conditions: &[Row],
    place: &[usize],
    matrix: &Sparse,
    stiff: f64,
) -> Vec<f64> {
    for _ in 0..BENDS {
        let mut right = vec![0.0; x.len()];
        for (old, new) in conditions.iter().zip(system.conditions(&x)) {
            old.terms.iter().for_each(|&(a, slope)| right[place[a]] -= slope * stiff * new.residual);
        }
        matrix.solve(&mut right);
        let step: Vec<f64> = place.iter().map(|&p| right[p]).collect();
        x = moved(system, &x, &step, 1.0);
    }
    x
}

/// The sum that steps make less: half the squares of the observations, and the conditions by their multipliers and their weight.
fn pull(system: &System, x: &[f64], multipliers: &[f64], stiff: f64) -> f64 {
    let seen: f64 = system.observations(x).iter().map(|r| r.residual * r.residual).sum();
    let conditions = system.conditions(x);
    let held = conditions.iter().zip(multipliers).map(|(c, m)| c.residual * (m + 0.5 * stiff * c.residual));
    0.5 * seen + held.sum::<f64>()
}

/// The greatest of what conditions lack.
fn lacking(conditions: &[Row]) -> f64 {
    conditions.iter().map(|c| c.residual.abs()).fold(0.0, f64::max)
}

/// Adds a row to the normal equations; `pull` is its weighted residual.
fn add(matrix: &mut Sparse, right: &mut [f64], place: &[usize], row: &Row, weight: f64, pull: f64) {
    for (k, &(a, slope)) in row.terms.iter().enumerate() {
        right[place[a]] -= slope * pull;
        matrix.add(place[a], place[a], weight * slope * slope);
        for &(b, other) in &row.terms[..k] {
            let both = if a == b { 2.0 } else { 1.0 };
            matrix.add(place[a], place[b], both * weight * slope * other);
        }
    }
}
