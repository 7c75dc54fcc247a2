//! How conditions pull on the curves, and how these would give way without some of them.
//!
//! Where conditions have a finite weight `w`, each pulls with `w` times what it lacks. Without a set of them, which pull with `m`, the unknowns give way by
//! `V (1 - w V)^-1 m`, where `V = C M^-1 C^T` and `M` are the normal equations with all conditions: what says the same as others does not give way.

use super::conditions::Conditions;
use super::row::Row;
use super::rows::System;
use super::solve::{SOFT, Work};
use crate::math::least_squares::inverse;

/// How conditions pull, and how they would give way.
pub(super) struct Forces<'a> {
    work: Work<'a>,
    conditions: Conditions,
}

impl<'a> Forces<'a> {
    /// Where conditions have the weight of the surest observation; `None` where the equations are singular.
    pub(super) fn new(system: &'a System<'a>, soft: &[f64]) -> Option<Self> {
        let mut work = Work::new(system);
        work.step(soft, SOFT, 0.0)?;
        Some(Self { conditions: system.conditions(soft), work })
    }

    pub(super) fn conditions(&self) -> &Conditions {
        &self.conditions
    }

    /// By how much the squares of the observations would sink if conditions, at most six, were no more (to first order).
    pub(super) fn gain(&self, of: &[usize]) -> f64 {
        let weight = SOFT * self.work.surest;
        let of = &of[..of.len().min(6)];
        let rows: Vec<&Row> = of.iter().map(|&k| &self.conditions.rows[k]).collect();
        let mut gives = [[0.0; 6]; 6];
        for (j, row) in rows.iter().enumerate() {
            let mut right = vec![0.0; self.work.place.len()];
            row.terms.iter().for_each(|&(a, slope)| right[self.work.place[a]] += slope);
            let Some(x) = self.work.solved(right) else { return 0.0 };
            for (i, other) in rows.iter().enumerate() {
                gives[i][j] = other.terms.iter().map(|&(a, slope)| slope * x[a]).sum();
            }
        }
        // What gives way with the others in place: V / (1 - w V), V that of all of them.
        let left = std::array::from_fn(|i| {
            std::array::from_fn(|j| f64::from(u8::from(i == j)) - weight * gives[i][j])
        });
        let Some(left) = inverse::<6>(left) else { return 0.0 };
        let pull: [f64; 6] = std::array::from_fn(|k| rows.get(k).map_or(0.0, |r| weight * r.residual));
        let dot = |a: &[f64; 6], b: &[f64; 6]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let freed: [f64; 6] = std::array::from_fn(|i| dot(&left[i], &pull));
        let way: [f64; 6] = std::array::from_fn(|i| dot(&gives[i], &freed));
        dot(&pull, &way)
    }
}
