//! Least squares under conditions. First the conditions are reached: damped Gauss-Newton steps (Levenberg 1944, Marquardt 1963) on the squares of
//! observations and conditions, these with a weight that grows, then on the conditions alone. From there the observations lead along the
//! conditions: each step of the least squares is led back to them before it is judged. Conditions that say the same twice do no harm.

use super::conditions::Conditions;
use super::order::order;
use super::row::Row;
use super::rows::System;
use crate::math::sparse::Sparse;

/// Weights of a condition against that of the surest unknown, one after the other.
const STIFF: [f64; 4] = [1e-2, SOFT, 1e2, 1e4];
/// The one at which what conditions lack tells with what force they pull.
pub(super) const SOFT: f64 = 1.0;
/// Weight that keeps an unknown where nothing says anything of it, against that of the surest.
const RIDGE: f64 = 1e-10;
/// The first weight that keeps an unknown where a step made the sum greater, and the last.
const DAMPED: [f64; 2] = [1e-6, 1e2];
/// By how much it grows and shrinks.
const DAMPING: f64 = 10.0;
/// Most steps of one weight, back to the conditions, and along them.
const STEPS: [usize; 3] = [12, 40, 40];
/// Times that a step is led back to the conditions by the slopes that it began with.
const BENDS: usize = 12;
/// Steps back to the conditions that may bring nothing.
const PATIENCE: usize = 3;
/// Least share of a step along the conditions that is taken.
const SHORTEST: f64 = 1.0 / 64.0;
/// Share by which the sum sinks at least for a further step.
const SINKS: f64 = 1e-4;
/// What a condition may lack, relative to the size of the network.
const REST: f64 = 1e-13;
/// What a condition may lack in the end, in that of rest: rounding.
const ROUNDING: f64 = 30.0;
/// Step, relative to that size, at which the fit has come to rest.
const STILL: f64 = 1e-7;

/// Where the least squares ended.
pub(super) struct Solution {
    /// The unknowns.
    pub x: Vec<f64>,
    /// The unknowns at which the conditions, with a weight no greater than that of the surest observation, still give way.
    pub soft: Vec<f64>,
    /// The conditions at `x`, with what they lack.
    pub conditions: Conditions,
    /// Whether all of them hold.
    pub holds: bool,
}

/// The least squares as it is worked on.
pub(super) struct Work<'a> {
    system: &'a System<'a>,
    size: f64,
    /// The place of each unknown in the matrix.
    pub place: Vec<usize>,
    matrix: Sparse,
    /// The weight of the unknown that is known best.
    pub surest: f64,
}

/// The unknowns of the least squares under the conditions, or the nearest to these where they contradict each other.
pub(super) fn solve(system: &System) -> Solution {
    let mut work = Work::new(system);
    let mut x = system.layout.start.clone();
    let mut soft = Vec::new();
    for stiff in STIFF {
        x = work.approach(x, stiff);
        if stiff == SOFT {
            soft.clone_from(&x);
        }
    }
    x = work.reach(x);
    if work.holds(&x) {
        x = work.descend(x);
    }
    let conditions = system.conditions(&x);
    Solution { holds: work.holds(&x), soft, conditions, x }
}

impl<'a> Work<'a> {
    pub(super) fn new(system: &'a System<'a>) -> Self {
        let x = &system.layout.start;
        let rows = system.observations(x);
        let mut diagonal = vec![0.0; x.len()];
        rows.iter().flat_map(|r| &r.terms).for_each(|t| diagonal[t.0] += t.1 * t.1);
        let surest = diagonal.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let all: Vec<Row> = rows.into_iter().chain(system.conditions(x).rows).collect();
        let (place, matrix) = order(&system.layout.blocks, x.len(), &all);
        Self { system, size: system.size(), place, matrix, surest }
    }

    fn holds(&self, x: &[f64]) -> bool {
        self.system.conditions(x).lacking() <= ROUNDING * REST * self.size
    }

    /// Half the squares of the observations, and of the conditions by their weight.
    fn sum(&self, x: &[f64], stiff: f64) -> f64 {
        let squares = |rows: &[Row]| rows.iter().map(|r| r.residual * r.residual).sum::<f64>();
        let conditions = if stiff > 0.0 { squares(&self.system.conditions(x).rows) } else { 0.0 };
        0.5 * (squares(&self.system.observations(x)) + stiff * self.surest * conditions)
    }

    /// Factorises the normal equations at `x`; the step that they give. `None` where they are singular.
    pub(super) fn step(&mut self, x: &[f64], stiff: f64, damp: f64) -> Option<Vec<f64>> {
        let (rows, conditions) = (self.system.observations(x), self.system.conditions(x).rows);
        let stiff = stiff * self.surest;
        self.matrix.clear();
        let mut right = vec![0.0; x.len()];
        rows.iter().for_each(|r| add(&mut self.matrix, &mut right, &self.place, r, 1.0));
        conditions.iter().for_each(|c| add(&mut self.matrix, &mut right, &self.place, c, stiff));
        let kept = (RIDGE + damp) * self.surest;
        (0..x.len()).for_each(|k| self.matrix.add(k, k, kept));
        for &at in &self.system.layout.directions {
            // A direction turns what is as far away as the network is large.
            let turn = damp * self.surest * self.size * self.size;
            (at..at + 3).for_each(|k| self.matrix.add(self.place[k], self.place[k], turn));
        }
        if !self.matrix.factorise() {
            return None;
        }
        self.solved(right)
    }

    /// The solution of the equations as they stand factorised; `None` where it is not finite.
    pub(super) fn solved(&self, mut right: Vec<f64>) -> Option<Vec<f64>> {
        self.matrix.solve(&mut right);
        let step: Vec<f64> = self.place.iter().map(|&p| right[p]).collect();
        step.iter().all(|s| s.is_finite()).then_some(step)
    }

    /// The unknowns after a share of a step.
    fn moved(&self, x: &[f64], step: &[f64], share: f64) -> Vec<f64> {
        let mut next: Vec<f64> = x.iter().zip(step).map(|(x, s)| x + share * s).collect();
        self.system.settle(&mut next);
        next
    }

    /// Led towards the conditions `count` times by the slopes at which the equations of weight `stiff` stand factorised.
    fn bent(&self, mut x: Vec<f64>, slopes: &Conditions, stiff: f64, count: usize) -> Vec<f64> {
        let stiff = stiff * self.surest;
        for _ in 0..count {
            let now = self.system.conditions(&x);
            if now.lacking() <= REST * self.size {
                break;
            }
            let mut right = vec![0.0; x.len()];
            for (old, new) in slopes.rows.iter().zip(&now.rows) {
                old.terms.iter().for_each(|&(a, s)| right[self.place[a]] -= s * stiff * new.residual);
            }
            let Some(step) = self.solved(right) else { break };
            x = self.moved(&x, &step, 1.0);
        }
        x
    }

    /// The least sum of observations and conditions of one weight.
    fn approach(&mut self, mut x: Vec<f64>, stiff: f64) -> Vec<f64> {
        let (mut damp, mut before) = (0.0, self.sum(&x, stiff));
        for _ in 0..STEPS[0] {
            let slopes = self.system.conditions(&x);
            let next = self.step(&x, stiff, damp).map(|step| self.moved(&x, &step, 1.0));
            let next = next.map(|next| {
                let bent = self.bent(next.clone(), &slopes, stiff, 1);
                if self.sum(&bent, stiff) < self.sum(&next, stiff) { bent } else { next }
            });
            let after = next.as_ref().map_or(f64::INFINITY, |next| self.sum(next, stiff));
            if let Some(next) = next.filter(|_| after < before) {
                x = next;
                damp = if damp > DAMPED[0] { damp / DAMPING } else { 0.0 };
                if after > (1.0 - SINKS) * before {
                    break;
                }
                before = after;
            } else {
                damp = (damp * DAMPING).max(DAMPED[0]);
                if damp > DAMPED[1] {
                    break;
                }
            }
        }
        x
    }

    /// To where the conditions hold, by the shortest way.
    fn reach(&mut self, mut x: Vec<f64>) -> Vec<f64> {
        let stiff = STIFF[STIFF.len() - 1];
        let (mut best, mut least, mut worse) = (x.clone(), f64::INFINITY, 0);
        for _ in 0..STEPS[1] {
            let slopes = self.system.conditions(&x);
            let lacks = slopes.lacking();
            worse = if lacks < least { 0 } else { worse + 1 };
            if lacks < least {
                (least, best) = (lacks, x.clone());
            }
            if least <= REST * self.size || worse > PATIENCE || self.step(&x, stiff, 0.0).is_none() {
                break;
            }
            x = self.bent(x, &slopes, stiff, 1);
        }
        best
    }

    /// Along the conditions to the least sum of the observations.
    fn descend(&mut self, mut x: Vec<f64>) -> Vec<f64> {
        let stiff = STIFF[STIFF.len() - 1];
        let mut before = self.sum(&x, 0.0);
        for _ in 0..STEPS[2] {
            let slopes = self.system.conditions(&x);
            let Some(step) = self.step(&x, stiff, 0.0) else { break };
            let mut share = 1.0;
            let better = loop {
                let next = self.bent(self.moved(&x, &step, share), &slopes, stiff, BENDS);
                if self.holds(&next) && self.sum(&next, 0.0) < before {
                    break Some(next);
                }
                share *= 0.5;
                if share < SHORTEST {
                    break None;
                }
            };
            let Some(next) = better else { break };
            let greatest = x.iter().zip(&next).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            x = next;
            let after = self.sum(&x, 0.0);
            if greatest <= STILL * self.size || after > (1.0 - SINKS) * before {
                break;
            }
            before = after;
        }
        x
    }
}

/// Adds a row to the normal equations.
fn add(matrix: &mut Sparse, right: &mut [f64], place: &[usize], row: &Row, weight: f64) {
    for (k, &(a, slope)) in row.terms.iter().enumerate() {
        right[place[a]] -= slope * weight * row.residual;
        matrix.add(place[a], place[a], weight * slope * slope);
        for &(b, other) in &row.terms[..k] {
            let both = if a == b { 2.0 } else { 1.0 };
            matrix.add(place[a], place[b], both * weight * slope * other);
        }
    }
}
