//! Relations imposed on extracted parts under noise; `cargo bench -p lineament --bench relations` has more parts and seeds.

use crate::common::checked;
use lineament::curve::pieces::Shape;
use lineament::math::vec3::{add_scaled, cross, dot, norm, scale, sub, unit};
use lineament::relation::Member;
use lineament::shapes::{LineIndex, Sampling, Scan, bracket, revolve};
use lineament::{Extraction, Network, Params, RelationKind, Strip};

fn direction(network: &Network, m: &Member) -> [f64; 3] {
    let piece = &network.strips[m.strip as usize].curves[m.curve as usize];
    match &piece.shape {
        Shape::Arc { round, .. } | Shape::Circle(round) => round.normal,
        _ => unit(sub(piece.to, piece.from)),
    }
}

fn radius(network: &Network, m: &Member) -> f64 {
    match &network.strips[m.strip as usize].curves[m.curve as usize].shape {
        Shape::Arc { round, .. } | Shape::Circle(round) => round.radius,
        _ => panic!("no radius"),
    }
}

/// The greatest error of imposed directions and radii.
fn worst(found: &Extraction) -> f64 {
    let mut worst: f64 = 0.0;
    for relation in found.related.relations.iter().filter(|r| r.kind != RelationKind::Symmetric) {
        assert!(relation.imposed);
        let first = &relation.members[0];
        let along = direction(&found.network, first);
        for m in &relation.members {
            worst = worst.max(match relation.kind {
                RelationKind::Parallel => norm(cross(along, direction(&found.network, m))),
                RelationKind::EqualRadius => {
                    (radius(&found.network, m) / radius(&found.network, first) - 1.0).abs()
                }
                _ => 0.0,
            });
        }
        if relation.kind == RelationKind::Perpendicular {
            let cosines = relation.others.iter().map(|m| dot(along, direction(&found.network, m)).abs());
            worst = cosines.fold(worst, f64::max);
        }
    }
    worst
}

/// Median distance of the typed curves from the truth, over lines and circles.
fn away(strips: &[Strip], truth: &LineIndex) -> f64 {
    let mut all = Vec::new();
    for piece in strips.iter().flat_map(|s| &s.curves) {
        let at = |t: f64| match &piece.shape {
            Shape::Circle(round) => {
                let zero = unit(sub(piece.from, round.centre));
                let (sin, cos) = (std::f64::consts::TAU * t).sin_cos();
                let out = add_scaled(scale(zero, cos), cross(round.normal, zero), sin);
                add_scaled(round.centre, out, round.radius)
            }
            _ => add_scaled(piece.from, sub(piece.to, piece.from), t),
        };
        all.extend((0..50).map(|k| truth.distance(at(f64::from(k) / 50.0))));
    }
    all.sort_by(f64::total_cmp);
    all[all.len() / 2]
}

#[test]
fn imposed_relations_hold_to_rounding_and_bring_noisy_parts_nearer_the_truth() {
    let profile =
        [[0.0, 0.0], [0.6, 0.0], [0.6, 1.5], [1.1, 1.5], [1.1, 3.0], [0.6, 3.0], [0.6, 4.5], [0.0, 4.5]];
    let shaft = || revolve("shaft", &profile);
    for (shape, noise, classes) in [(bracket(), 0.1, 3), (bracket(), 0.25, 3), (shaft(), 0.25, 1)] {
        let scan = shape.sample(&Scan::new(Sampling::BlueNoise { count: 6000 }).noise(noise).seed(2));
        let truth = scan.truth.index(0.01 * scan.spacing);
        let mut params = Params::default();
        let found = checked(&scan.cloud, &params).unwrap();
        params.relations.regularise = true;
        let regular = checked(&scan.cloud, &params).unwrap();
        let parallel = regular.related.count(RelationKind::Parallel);
        assert_eq!(parallel, classes, "{} {noise}", shape.name);
        assert!(regular.related.count(RelationKind::EqualRadius) > 0, "{} {noise}", shape.name);
        assert!(worst(&regular) < 1e-9, "{} {noise}: {:e}", shape.name, worst(&regular));
        let [before, after] = [&found, &regular].map(|e| away(&e.network.strips, &truth) / scan.spacing);
        assert!(after < 0.8 * before, "{} {noise}: {after} of {before}", shape.name);
        assert!(found.related.regularised.is_none() && !found.related.relations.iter().any(|r| r.imposed));
    }
}

#[test]
fn relations_follow_the_choice_of_lines() {
    let scan = bracket().sample(&Scan::new(Sampling::BlueNoise { count: 6000 }).noise(0.1).seed(2));
    let mut params = Params::default();
    params.relations.regularise = true;
    let mut found = checked(&scan.cloud, &params).unwrap();
    found.choose(|strip| strip.closed);
    let circles = found.network.strips.len();
    assert_eq!(circles, 4);
    let strips = found.related.relations.iter().flat_map(|r| &r.members).map(|m| m.strip as usize);
    assert!(strips.clone().count() > 0 && strips.clone().all(|s| s < circles));
    assert_eq!(found.related.regularised.unwrap().curves.len(), circles);
}
