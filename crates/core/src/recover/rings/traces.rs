//! Samples along all lines, to which circles are fitted.

use crate::curve::Round;
use crate::math::vec3::{add_scaled, cross, distance, dot, norm, perpendicular, sub, unit};
use crate::neighbors::Index;
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// Greatest distance of samples, in spacings.
const STEP: f64 = 0.5;
/// Distance from a circle within which lines count as its pieces, in spacings.
const BESIDE: f64 = 0.8;
/// Least cosine between the direction of a piece and the circle's.
const ALONG: f64 = 0.88;
/// Rounds of gathering the pieces and fitting the circle.
const ROUNDS: usize = 4;
/// Parts of a circle, of a spacing's length; at least so many.
const PARTS: usize = 8;
/// Least share of the circle beside which there are lines.
const LEAST: f64 = 0.25;

/// Samples with the unit directions of their lines and the spacings there.
pub(super) struct Traces {
    places: Vec<[f64; 3]>,
    along: Vec<[f64; 3]>,
    spacing: Vec<f64>,
    /// The greatest of these.
    widest: f64,
    index: Index,
}

/// A circle, the spacing beside it, and the share of it that lines follow.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trace {
    pub(super) round: Round,
    pub(super) spacing: f64,
    pub(super) share: f64,
}

impl Traces {
    pub(super) fn new(lines: &LineGraph, scales: Scales) -> Traces {
        let (mut places, mut along, mut spacing) = (Vec::new(), Vec::new(), Vec::new());
        for (a, list) in lines.edges.iter().enumerate() {
            for b in list.iter().map(|&b| b as usize).filter(|&b| a < b) {
                let h = scales.at(lines.points[a] as usize).spacing;
                let (from, to) = (lines.positions[a], lines.positions[b]);
                let step = sub(to, from);
                let count = (norm(step) / (STEP * h)).ceil().max(1.0);
                for k in 0..count as usize {
                    places.push(add_scaled(from, step, (k as f64 + 0.5) / count));
                    along.push(unit(step));
                    spacing.push(h);
                }
            }
        }
        let index = Index::build(&places);
        let widest = spacing.iter().copied().fold(0.0, f64::max);
        Traces { places, along, spacing, widest, index }
    }

    /// The circle fitted to all pieces of lines beside it; `None` where these are few.
    pub(super) fn trace(&self, mut round: Round) -> Option<Trace> {
        let mut near = Vec::new();
        for _ in 0..ROUNDS {
            self.beside(&round, &mut near);
            let places: Vec<[f64; 3]> = near.iter().map(|&i| self.places[i as usize]).collect();
            round = Round::fit(&places)?;
        }
        self.beside(&round, &mut near);
        let spacing = near.iter().map(|&i| self.spacing[i as usize]).reduce(f64::min)?;
        let share = self.share(&round, spacing, &near);
        (share >= LEAST).then_some(Trace { round, spacing, share })
    }

    /// The samples beside a circle, ascending.
    fn beside(&self, round: &Round, near: &mut Vec<u32>) {
        near.clear();
        let reach = round.radius + BESIDE * self.widest;
        self.index.around(round.centre, reach, |f| {
            let i = f.index as usize;
            let foot = round.foot(self.places[i]);
            let direction = cross(round.normal, sub(foot, round.centre));
            let aligned = dot(direction, self.along[i]).abs() >= ALONG * norm(direction);
            if aligned && distance(foot, self.places[i]) <= BESIDE * self.spacing[i] {
                near.push(f.index);
            }
        });
        near.sort_unstable();
    }

    /// The share of the circle's parts that have samples.
    fn share(&self, round: &Round, spacing: f64, near: &[u32]) -> f64 {
        let full = std::f64::consts::TAU;
        let parts = ((full * round.radius / spacing).ceil() as usize).max(PARTS);
        let mut met = vec![false; parts];
        let zero = perpendicular(round.normal);
        let other = cross(round.normal, zero);
        for &i in near {
            let d = sub(self.places[i as usize], round.centre);
            let angle = dot(d, other).atan2(dot(d, zero)).rem_euclid(full);
            met[(angle / full * parts as f64) as usize % parts] = true;
        }
        met.iter().filter(|m| **m).count() as f64 / parts as f64
    }
}
