//! The round features of a network: holes and bosses with one rim or two, other circles, arcs.

use super::rims::{Rim, RimSide};
use super::ring::{Ring, RoundSigma, rings};
use crate::math::vec3::{add, add_scaled, distance, dot, norm, scale, sub, unit};
use crate::network::Network;
use crate::relation::OPEN;

/// Spacings, beside three standard deviations, within which two rims of one wall have one axis and one radius.
const SAME: f64 = 0.5;
/// Standard deviations within which they do.
const DEVIATIONS: f64 = 3.0;
/// Turn from which on an arc is a whole circle, degrees: what is left is where its strip begins.
const WHOLE_DEG: f64 = 330.0;
/// Sine of the angle between the axes of two rims of one wall.
const ALONG: f64 = 0.1;

/// A round feature.
#[derive(Clone, Debug, PartialEq)]
pub struct RoundFeature {
    /// Its kind.
    pub kind: RoundKind,
    /// The strips that it consists of: those of its circle, which nodes may part, or of the two rims of a hole or a boss.
    pub strips: Vec<usize>,
    /// The centre of the circle, or of each of the two rims, world frame.
    pub centres: Vec<[f64; 3]>,
    /// Unit vector along the axis: from the first centre to the second, or with its greatest component above 0.
    pub axis: [f64; 3],
    /// The diameter.
    pub diameter: f64,
    /// The angle of an arc, degrees; 360 for whole circles.
    pub sweep_deg: f64,
    /// How well it is known; `None` where that is not.
    pub sigma: Option<RoundSigma>,
}

/// The kind of a round feature.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum RoundKind {
    /// An opening, through or blind.
    Hole,
    /// What stands out of a face.
    Boss,
    /// A whole circle of which the points do not tell what it bounds.
    Circle,
    /// Part of a circle, such as a rounded corner.
    Arc,
}

impl RoundKind {
    /// The name in tables: `hole`, `boss`, `circle` or `arc`.
    pub fn name(self) -> &'static str {
        match self {
            RoundKind::Hole => "hole",
            RoundKind::Boss => "boss",
            RoundKind::Circle => "circle",
            RoundKind::Arc => "arc",
        }
    }
}

impl RoundFeature {
    /// Whether it is an arc whose points leave its diameter open: it is known to no better than 5 %, as of arcs that are in no relation.
    pub fn is_open(&self) -> bool {
        let known = |s: &RoundSigma| s.diameter <= OPEN * self.diameter;
        self.kind == RoundKind::Arc && !self.sigma.as_ref().is_some_and(known)
    }

    /// The distance from rim to rim of a hole or boss; `None` where one rim alone is known.
    pub fn depth(&self) -> Option<f64> {
        match self.centres[..] {
            [a, b] => Some(distance(a, b)),
            _ => None,
        }
    }
}

/// All round features: by their kind, then by their diameter, greatest first, arcs whose points leave it open after the others. `sides` says of each strip what it is the rim of.
pub(super) fn rounds(network: &Network, sides: &[Option<RimSide>], spacing: f64) -> Vec<RoundFeature> {
    let rings = rings(network, sides, spacing);
    let partner = partners(&rings, spacing);
    let mut all: Vec<RoundFeature> = Vec::new();
    for (i, ring) in rings.iter().enumerate() {
        match partner[i] {
            Some(other) if other < i => {}
            Some(other) => all.push(pair(ring, &rings[other])),
            None => all.push(alone(ring)),
        }
    }
    all.sort_by(|a, b| {
        let known = a.kind.cmp(&b.kind).then(a.is_open().cmp(&b.is_open()));
        known.then(b.diameter.total_cmp(&a.diameter)).then(a.strips.cmp(&b.strips))
    });
    all
}

/// For each rim the one at the other end of its wall: the nearest along it whose wall leads back, or of which it is not known what it
/// is. The shortest walls choose first.
fn partners(rings: &[Ring], spacing: f64) -> Vec<Option<usize>> {
    let mut walls: Vec<(f64, usize, usize)> = Vec::new();
    for i in 0..rings.len() {
        let to = (0..rings.len()).filter(|&j| j != i);
        walls.extend(to.filter_map(|j| Some((depth(&rings[i], &rings[j], spacing)?, i, j))));
    }
    walls.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut partner = vec![None; rings.len()];
    for (_, i, j) in walls {
        if partner[i].is_none() && partner[j].is_none() {
            (partner[i], partner[j]) = (Some(j), Some(i));
        }
    }
    partner
}

/// The depth of the wall that leads from a rim to a circle, if one may.
fn depth(a: &Ring, b: &Ring, spacing: f64) -> Option<f64> {
    let side = a.side?;
    let wall = side.wall?;
    let from = sub(b.centre, a.centre);
    let depth = dot(from, wall);
    let aside = norm(sub(from, scale(wall, depth)));
    let sigma = |r: &Ring| r.sigma.map_or(0.0, |s| s.diameter / 2.0 + norm(s.centre));
    let same = SAME * spacing + DEVIATIONS * (sigma(a) + sigma(b));
    let across = norm(sub(b.normal, scale(wall, dot(wall, b.normal))));
    let coaxial = across <= ALONG && aside <= same.max(ALONG * depth);
    let fits = match b.side {
        Some(other) => other.rim == side.rim && other.wall.is_some_and(|back| dot(wall, back) < 0.0),
        None => b.whole,
    };
    let one = depth > 0.0 && coaxial && (a.radius - b.radius).abs() <= same;
    (one && fits).then_some(depth)
}

fn alone(ring: &Ring) -> RoundFeature {
    let kind = match ring.side {
        Some(RimSide { rim: Rim::Hole, .. }) => RoundKind::Hole,
        Some(RimSide { rim: Rim::Boss, .. }) => RoundKind::Boss,
        None if ring.turn_deg >= WHOLE_DEG => RoundKind::Circle,
        None => RoundKind::Arc,
    };
    RoundFeature {
        kind,
        strips: ring.strips.clone(),
        centres: vec![ring.centre],
        axis: upright(ring.normal),
        diameter: 2.0 * ring.radius,
        sweep_deg: ring.turn_deg,
        sigma: ring.sigma,
    }
}

/// The axis whose greatest component is above 0.
fn upright(axis: [f64; 3]) -> [f64; 3] {
    let greatest = axis.iter().copied().fold(0.0, |most: f64, c| if c.abs() > most.abs() { c } else { most });
    if greatest < 0.0 { scale(axis, -1.0) } else { axis }
}

/// Both rims as one: diameter and axis by the means of least variance.
fn pair(a: &Ring, b: &Ring) -> RoundFeature {
    let kind = alone(if a.side.is_some() { a } else { b }).kind;
    let between = unit(sub(b.centre, a.centre));
    let [a, b] = if upright(between) == between { [a, b] } else { [b, a] };
    let from = sub(b.centre, a.centre);
    let turned = |axis: [f64; 3]| if dot(axis, from) < 0.0 { scale(axis, -1.0) } else { axis };
    let [first, second] = [a, b].map(|r| turned(r.normal));
    let diameters = [a, b].map(|r| 2.0 * r.radius);
    let (diameter, axis, sigma) = match a.sigma.zip(b.sigma) {
        Some((s, t)) => {
            let (diameter, of_diameter) = mean(diameters, [s.diameter, t.diameter]);
            let (share, of_axis) = mean([0.0, 1.0], [s.axis_deg, t.axis_deg]);
            let axis = unit(add_scaled(scale(first, 1.0 - share), second, share));
            let sigma = RoundSigma { centre: s.centre, axis_deg: of_axis, diameter: of_diameter };
            (diameter, axis, Some(sigma))
        }
        None => ((diameters[0] + diameters[1]) / 2.0, unit(add(first, second)), None),
    };
    RoundFeature {
        kind,
        strips: [&a.strips[..], &b.strips].concat(),
        centres: vec![a.centre, b.centre],
        axis,
        diameter,
        sigma,
        ..alone(a)
    }
}

/// The mean of two values by their variances, and its standard deviation; their plain mean where a deviation is 0.
fn mean([a, b]: [f64; 2], [s, t]: [f64; 2]) -> (f64, f64) {
    let [u, v] = [s, t].map(|sigma| 1.0 / (sigma * sigma));
    if !(u + v).is_finite() {
        return ((a + b) / 2.0, s.max(t));
    }
    ((a * u + b * v) / (u + v), (1.0 / (u + v)).sqrt())
}
