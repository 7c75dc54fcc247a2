//! Edges that are rounded, against the edges of their design.

use super::lines::{Lines, RoundedEdge};
use super::sides::length;
use crate::shapes::{Tree, densify};

/// Radii that are asked for, spacings.
const RADII: [f64; 2] = [1.0, 6.0];
/// Angle between the faces from which on an edge is asked for, degrees.
const LEAST_TURN_DEG: f64 = 40.0;
/// Length from which on an edge is asked for, spacings.
const SHORTEST: f64 = 6.0;
/// A sample counts within so many spacings and shares of the radius.
const NEAR: [f64; 2] = [0.5, 0.15];
/// Share of the greater radius by which two may differ.
const SAME_RADIUS: f64 = 0.25;

/// Rounded edges that were found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rounded {
    /// Share of the length found that lies on a design edge of its radius; NaN where none was found.
    pub precision: f64,
    /// Share of the length of the design edges that was found with its radius; NaN where none is asked for: those of 1 to 6
    /// spacings radius whose faces turn by 40 degrees or more.
    pub recall: f64,
}

/// Samples along edges, with the radius at each.
type Samples = Vec<([f64; 3], f64)>;

impl Rounded {
    pub(super) fn of(found: &Lines, known: &Lines, spacing: f64) -> Option<Self> {
        if known.rounded.is_empty() {
            return None;
        }
        let asked = |e: &&RoundedEdge| {
            (RADII[0] * spacing..=RADII[1] * spacing).contains(&e.radius)
                && e.turn_deg >= LEAST_TURN_DEG
                && length(&e.points) >= SHORTEST * spacing
        };
        let all = samples(known.rounded.iter(), spacing);
        let asked = samples(known.rounded.iter().filter(asked), spacing);
        let met = samples(found.rounded.iter(), spacing);
        Some(Self { precision: near(&met, &all, spacing), recall: near(&asked, &met, spacing) })
    }
}

fn samples<'a>(edges: impl Iterator<Item = &'a RoundedEdge>, spacing: f64) -> Samples {
    edges
        .filter(|e| e.points.len() > 1)
        .flat_map(|e| densify(&e.points, e.closed, spacing / 3.0).into_iter().map(|p| (p, e.radius)))
        .collect()
}

/// The share of samples near one of the others that has their radius; NaN without samples.
fn near(samples: &Samples, others: &Samples, spacing: f64) -> f64 {
    let tree = Tree::new(&others.iter().map(|s| s.0).collect::<Vec<_>>());
    let meets = |(p, radius): &&([f64; 3], f64)| {
        tree.nearest(*p).is_some_and(|(at, d2)| {
            let other = others[at as usize].1;
            d2.sqrt() <= NEAR[0] * spacing + NEAR[1] * radius.min(other)
                && (radius - other).abs() <= SAME_RADIUS * radius.max(other)
        })
    };
    if samples.is_empty() {
        return f64::NAN;
    }
    samples.iter().filter(meets).count() as f64 / samples.len() as f64
}
