//! How exactly relations hold in a network, and how far its curves are from the truth.

use lineament::curve::pieces::{Piece, Shape};
use lineament::math::vec3::{add_scaled, cross, dot, norm, scale, sub, unit};
use lineament::relation::Member;
use lineament::shapes::LineIndex;
use lineament::{Network, Relation, RelationKind};

/// Greatest sine between parallels, cosine of right angles, and relative difference of radii.
#[derive(Clone, Copy, Debug, Default)]
pub struct Exactness {
    pub parallel: f64,
    pub perpendicular: f64,
    pub radii: f64,
}

impl Exactness {
    pub fn max(self, other: Self) -> Self {
        Self {
            parallel: self.parallel.max(other.parallel),
            perpendicular: self.perpendicular.max(other.perpendicular),
            radii: self.radii.max(other.radii),
        }
    }
}

fn direction(network: &Network, member: Member) -> [f64; 3] {
    let piece = &network.strips[member.strip as usize].curves[member.curve as usize];
    match &piece.shape {
        Shape::Arc { round, .. } | Shape::Circle(round) => round.normal,
        _ => unit(sub(piece.to, piece.from)),
    }
}

fn radius(network: &Network, member: Member) -> Option<f64> {
    match &network.strips[member.strip as usize].curves[member.curve as usize].shape {
        Shape::Arc { round, .. } | Shape::Circle(round) => Some(round.radius),
        _ => None,
    }
}

/// How exactly the imposed relations hold.
pub fn exactness(network: &Network, relations: &[Relation]) -> Exactness {
    let mut worst = Exactness::default();
    for relation in relations.iter().filter(|r| r.imposed) {
        let first = direction(network, relation.members[0]);
        let sine = |d| norm(cross(first, d));
        match relation.kind {
            RelationKind::Parallel => {
                for &m in &relation.members {
                    worst.parallel = worst.parallel.max(sine(direction(network, m)));
                }
            }
            RelationKind::Perpendicular => {
                for (&a, &b) in
                    relation.members.iter().flat_map(|a| relation.others.iter().map(move |b| (a, b)))
                {
                    let cosine = dot(direction(network, a), direction(network, b)).abs();
                    worst.perpendicular = worst.perpendicular.max(cosine);
                }
            }
            RelationKind::EqualRadius => {
                let radii: Vec<f64> = relation.members.iter().filter_map(|&m| radius(network, m)).collect();
                for r in &radii {
                    worst.radii = worst.radii.max((r / radii[0] - 1.0).abs());
                }
            }
            _ => {}
        }
    }
    worst
}

/// Mean and greatest distance of the typed curves from the truth, in spacings.
pub fn distances(network: &Network, truth: &LineIndex, spacing: f64) -> [f64; 2] {
    let (mut sum, mut count, mut most) = (0.0, 0.0, 0.0_f64);
    for piece in network.strips.iter().flat_map(|s| &s.curves) {
        for p in samples(piece, 0.5 * spacing) {
            let d = truth.distance(p) / spacing;
            (sum, count, most) = (sum + d, count + 1.0, most.max(d));
        }
    }
    [sum / count, most]
}

/// Points of a curve about `step` apart.
fn samples(piece: &Piece, step: f64) -> Vec<[f64; 3]> {
    let many = |length: f64| (length / step).ceil().max(1.0) as usize;
    match &piece.shape {
        Shape::Line => {
            let chord = sub(piece.to, piece.from);
            let n = many(norm(chord));
            (0..=n).map(|k| add_scaled(piece.from, chord, k as f64 / n as f64)).collect()
        }
        Shape::Arc { round, .. } | Shape::Circle(round) => {
            let sweep = match piece.shape {
                Shape::Arc { sweep, .. } => sweep,
                _ => std::f64::consts::TAU,
            };
            let zero = unit(sub(piece.from, round.centre));
            let other = cross(round.normal, zero);
            let n = many(sweep * round.radius);
            let at = |k: usize| {
                let (sin, cos) = (sweep * k as f64 / n as f64).sin_cos();
                add_scaled(round.centre, add_scaled(scale(zero, cos), other, sin), round.radius)
            };
            (0..=n).map(at).collect()
        }
        Shape::Ellipse { ellipse, sweep } => {
            let first = ellipse.angle(piece.from);
            let n = many(sweep * norm(ellipse.major));
            (0..=n).map(|k| ellipse.at(first + sweep * k as f64 / n as f64)).collect()
        }
        Shape::Spline(curve) => {
            let (from, to) = curve.domain();
            let n = many(to - from);
            (0..=n).map(|k| curve.point(from + (to - from) * k as f64 / n as f64)).collect()
        }
    }
}
