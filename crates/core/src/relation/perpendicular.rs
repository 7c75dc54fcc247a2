//! Right angles between classes of directions.

use super::feature::between;
use super::odds;
use super::parallel::Class;
use crate::math::vec3::dot;

/// Classes, those with most members, each of which is compared with every other.
pub(super) const COMPARED: usize = 48;
/// Density of the cosine between two directions that have nothing to do with each other.
const CHANCE: f64 = 0.5;

/// Two classes at a right angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Perpendicular {
    /// The classes.
    pub classes: [usize; 2],
    /// Its probability.
    pub likelihood: f64,
    /// What the angle lacks or has too much, radians.
    pub deviation: f64,
}

/// The right angles between the first classes, and between the `pairs` of others, classes whose curves meet.
pub(super) fn perpendicular(classes: &[Class], pairs: &[[usize; 2]], least: f64) -> Vec<Perpendicular> {
    let first = classes.len().min(COMPARED);
    let all = (0..first).flat_map(|a| (a + 1..first).map(move |b| [a, b]));
    let others = pairs.iter().copied().filter(|p| p[1] >= first);
    let judged = |[a, b]: [usize; 2]| {
        let (one, other) = (&classes[a], &classes[b]);
        let cosine = dot(one.direction, other.direction);
        let variance = between(other.direction, &one.turn, other.direction)
            + between(one.direction, &other.turn, one.direction);
        let likelihood = odds::of_number(cosine, variance, CHANCE * first as f64);
        Perpendicular { classes: [a, b], likelihood, deviation: cosine.abs().min(1.0).asin() }
    };
    all.chain(others).map(judged).filter(|p| p.likelihood >= least).collect()
}
