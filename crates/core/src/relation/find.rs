//! All relations of a network.

use super::axes::{Axis, axes};
use super::coplanar::{Plane, planes};
use super::feature::Feature;
use super::joints::Joints;
use super::mirror::{Drawn, Mirror, mirrors};
use super::parallel::{Class, classes};
use super::perpendicular::{Perpendicular, perpendicular};
use super::radii::{Radius, radii};
use super::relations::Member;
use super::tangent::{Meeting, Tangent, tangents};
use crate::curve::pieces::{Observed, Piece, Shape};
use crate::math::vec3::{add_scaled, cross, distance, scale, sub, unit};
use crate::network::Network;
use crate::params::RelationParams;
use std::collections::BTreeSet;

/// Most curves of one joint that are compared with each other.
const CROWD: usize = 8;

/// Standard deviation of a radius, as a share of it, beyond which an arc is in no relation.
pub(crate) const OPEN: f64 = 0.05;

/// The relations as found.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(super) features: Vec<Feature>,
    /// For each strip and curve its feature.
    pub(super) of: Vec<Vec<Option<usize>>>,
    pub(super) joints: Joints,
    pub(super) classes: Vec<Class>,
    pub(super) right: Vec<Perpendicular>,
    pub(super) planes: Vec<Plane>,
    pub(super) axes: Vec<Axis>,
    pub(super) radii: Vec<Radius>,
    pub(super) tangents: Vec<Tangent>,
    pub(super) mirrors: Vec<Mirror>,
}

/// The relations between the curves of a network, each of which was `observed` where points are `spacing` (of its strip) apart.
pub(crate) fn find(
    network: &Network,
    observed: &[Vec<Option<Observed>>],
    spacing: &[f64],
    params: &RelationParams,
) -> Found {
    let least = params.likelihood;
    let (mut features, mut of) = (Vec::new(), Vec::new());
    for (s, curves) in observed.iter().enumerate() {
        let mut row = Vec::new();
        for (c, seen) in curves.iter().enumerate() {
            let seen = seen.filter(|s| s.covariance.iter().flatten().all(|x| x.is_finite()) && is_known(s));
            row.push(seen.map(|_| features.len()));
            let member = Member { strip: s as u32, curve: c as u32 };
            features.extend(seen.map(|seen| Feature::new(member, seen, spacing[s])));
        }
        of.push(row);
    }
    let joints = Joints::of(network);
    let meetings = meetings(network, &joints, &of);
    let classes = classes(&features, least);
    let mut class_of = vec![0; features.len()];
    classes.iter().enumerate().for_each(|(c, class)| class.members.iter().for_each(|&i| class_of[i] = c));
    let pairs: BTreeSet<[usize; 2]> = meetings
        .iter()
        .map(|m| m.features.map(|i| class_of[i]))
        .map(|[a, b]| [a.min(b), a.max(b)])
        .filter(|[a, b]| a != b)
        .collect();
    let right = perpendicular(&classes, &pairs.into_iter().collect::<Vec<_>>(), least);
    let touching: BTreeSet<[usize; 2]> = meetings.iter().map(|m| m.features).collect();
    let touch = |a, b| touching.contains(&[a, b]) || touching.contains(&[b, a]);
    let planes = planes(&features, &classes, &right, touch, least);
    let axes = axes(&features, &classes, least);
    let drawn: Vec<Drawn> = features.iter().map(|f| drawn(network, f)).collect();
    let widest = spacing.iter().copied().fold(0.0, f64::max);
    let (radii, tangents) = (radii(&features, half(&drawn), least), tangents(&features, &meetings, least));
    let mirrors = mirrors(&features, &drawn, &classes, widest);
    Found { features, of, joints, classes, right, planes, axes, radii, tangents, mirrors }
}

/// Whether the points of a curve determine it: of a short arc they leave radius and centre open together.
fn is_known(seen: &Observed) -> bool {
    seen.round().is_none_or(|round| seen.covariance[4][4].sqrt() <= OPEN * round.radius)
}

/// Half the greatest extent of the curves: the greatest radius that a part has room for.
fn half(drawn: &[Drawn]) -> f64 {
    let along = |k: usize| {
        let all = || drawn.iter().flat_map(|d| d.ends).map(|p| p[k]);
        all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
    };
    (0..3).map(along).fold(0.0, f64::max) / 2.0
}

/// The pairs of features that end at one joint.
fn meetings(network: &Network, joints: &Joints, of: &[Vec<Option<usize>>]) -> Vec<Meeting> {
    let mut ends: Vec<Vec<(usize, [f64; 3])>> = vec![Vec::new(); joints.places.len()];
    for (s, strip) in network.strips.iter().enumerate() {
        for (c, piece) in strip.curves.iter().enumerate() {
            if let (Some([a, b]), Some(feature)) = (joints.ends[s][c], of[s][c]) {
                ends[a].push((feature, leaves(piece, true)));
                ends[b].push((feature, leaves(piece, false)));
            }
        }
    }
    let mut found = Vec::new();
    for (joint, ends) in ends.iter().enumerate().filter(|(_, e)| e.len() <= CROWD) {
        for (k, a) in ends.iter().enumerate() {
            let at = joints.places[joint];
            let with =
                |b: &(usize, [f64; 3])| Meeting { features: [a.0, b.0], joint, at, leaves: [a.1, b.1] };
            found.extend(ends[k + 1..].iter().filter(|b| b.0 != a.0).map(with));
        }
    }
    found
}

/// The unit direction in which a piece leaves its first or its last end.
fn leaves(piece: &Piece, first: bool) -> [f64; 3] {
    let sign = if first { 1.0 } else { -1.0 };
    match &piece.shape {
        Shape::Arc { round, .. } | Shape::Circle(round) => {
            let at = if first { piece.from } else { piece.to };
            scale(unit(cross(round.normal, sub(at, round.centre))), sign)
        }
        _ => scale(unit(sub(piece.to, piece.from)), sign),
    }
}

fn drawn(network: &Network, feature: &Feature) -> Drawn {
    let Member { strip, curve } = feature.member;
    let piece = &network.strips[strip as usize].curves[curve as usize];
    match &piece.shape {
        Shape::Arc { round, .. } | Shape::Circle(round) => {
            let out = scale(unit(sub(piece.from, round.centre)), round.radius);
            let ends = [add_scaled(round.centre, out, 1.0), add_scaled(round.centre, out, -1.0)];
            let turn = if let Shape::Arc { sweep, .. } = piece.shape { sweep } else { std::f64::consts::TAU };
            Drawn { middle: round.centre, ends, length: turn * round.radius }
        }
        _ => {
            let ends = [piece.from, piece.to];
            let middle = scale(add_scaled(piece.from, piece.to, 1.0), 0.5);
            Drawn { middle, ends, length: distance(piece.from, piece.to) }
        }
    }
}
