//! Circles and arcs of strips: those of one circle are one, whether a strip has several or nodes part it into several strips.

use super::rims::{MOST_OF_A_TURN, RimSide};
use crate::curve::Round;
use crate::curve::pieces::{Piece, Shape, Sigma};
use crate::math::vec3::{add_scaled, distance, dot, norm, unit};
use crate::network::Network;

/// Spacings within which centres and radii of arcs are those of one circle.
const SAME: f64 = 0.5;

/// Standard deviations of a round feature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundSigma {
    /// Of the first centre on each axis.
    pub centre: [f64; 3],
    /// Of the axis, degrees.
    pub axis_deg: f64,
    /// Of the diameter.
    pub diameter: f64,
}

/// Degrees beyond a full turn that arcs of one circle may sweep together: no more than their ends overlap.
const OVERLAP_DEG: f64 = 5.0;

/// A circle, or arcs of one.
pub(super) struct Ring {
    /// The strips that it lies on, ascending.
    pub strips: Vec<usize>,
    pub centre: [f64; 3],
    pub normal: [f64; 3],
    pub radius: f64,
    /// The angle that it sweeps, degrees.
    pub turn_deg: f64,
    /// Whether it is most of a turn.
    pub whole: bool,
    pub side: Option<RimSide>,
    pub sigma: Option<RoundSigma>,
}

/// All of a network, in the order of its strips. `sides` says of each strip what it is the rim of.
pub(super) fn rings(network: &Network, sides: &[Option<RimSide>], spacing: f64) -> Vec<Ring> {
    let mut all: Vec<Ring> = Vec::new();
    for (strip, of) in network.strips.iter().enumerate() {
        for ring in of.curves.iter().filter_map(|piece| ring(strip, piece)) {
            match all.iter_mut().find(|other| other.goes_on(&ring) && same(other, &ring, spacing)) {
                Some(other) => other.join(&ring),
                None => all.push(ring),
            }
        }
    }
    for ring in &mut all {
        ring.whole = ring.turn_deg > MOST_OF_A_TURN;
        let named = ring.strips.iter().find_map(|&s| sides.get(s).copied().flatten());
        ring.side = named.filter(|_| ring.whole);
    }
    all
}

fn ring(strip: usize, piece: &Piece) -> Option<Ring> {
    let (round, turn_deg) = match &piece.shape {
        Shape::Circle(round) => (round, 360.0),
        Shape::Arc { round, sweep } => (round, sweep.to_degrees()),
        _ => return None,
    };
    let Round { centre, normal, radius } = *round;
    let sigma = match piece.sigma {
        Some(Sigma::Round { radius, normal, covariance }) => Some(RoundSigma {
            centre: [0, 1, 2].map(|a| covariance[a][a].max(0.0).sqrt()),
            axis_deg: normal.to_degrees(),
            diameter: 2.0 * radius,
        }),
        _ => None,
    };
    Some(Ring { strips: vec![strip], centre, normal, radius, turn_deg, whole: false, side: None, sigma })
}

/// Whether two arcs are of one circle.
fn same(a: &Ring, b: &Ring, spacing: f64) -> bool {
    let near = SAME * spacing;
    let turned = norm(add_scaled(a.normal, b.normal, -dot(a.normal, b.normal).signum()));
    distance(a.centre, b.centre) <= near && (a.radius - b.radius).abs() <= near && turned * a.radius <= near
}

impl Ring {
    /// Whether another arc can be a further part of it: two whole circles of two strips are two.
    fn goes_on(&self, other: &Ring) -> bool {
        self.strips.contains(&other.strips[0]) || self.turn_deg + other.turn_deg <= 360.0 + OVERLAP_DEG
    }

    /// With another arc of its circle: the means by their angles, and the deviations of these means.
    fn join(&mut self, other: &Ring) {
        let turn_deg = self.turn_deg + other.turn_deg;
        let [s, t] = [self.turn_deg, other.turn_deg].map(|turn| turn / turn_deg);
        let mean = |a: f64, b: f64| s * a + t * b;
        let sense = dot(self.normal, other.normal).signum();
        let spread = |a: f64, b: f64| (s * a).hypot(t * b);
        self.sigma = self.sigma.zip(other.sigma).map(|(a, b)| RoundSigma {
            centre: [0, 1, 2].map(|k| spread(a.centre[k], b.centre[k])),
            axis_deg: spread(a.axis_deg, b.axis_deg),
            diameter: spread(a.diameter, b.diameter),
        });
        self.centre = [0, 1, 2].map(|k| mean(self.centre[k], other.centre[k]));
        self.normal = unit([0, 1, 2].map(|k| mean(self.normal[k], sense * other.normal[k])));
        self.radius = mean(self.radius, other.radius);
        self.turn_deg = turn_deg;
        self.strips.extend_from_slice(&other.strips);
        self.strips.dedup();
    }
}
