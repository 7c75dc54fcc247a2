use super::*;
use crate::curve::pieces::{Piece, Shape, Sigma};
use crate::curve::{BSpline, Round};
use crate::network::{Strip, StripKind};
use crate::params::Params;
use crate::shapes::{self, Sampling, Scan};
use crate::{Class, extract};

fn of(shape: &shapes::Shape, count: usize) -> Inspection {
    let part = shape.sample(&Scan::new(Sampling::Area { count }).noise(0.05).seed(2));
    let found = extract(&part.cloud, &Params::default()).unwrap();
    let surface = part.cloud.positions.iter().zip(found.classes()).filter(|(_, c)| *c != Class::Clutter);
    let points: Vec<[f64; 3]> = surface.map(|(p, _)| *p).collect();
    inspect(&found.network, &points, found.report.spacing)
}

#[test]
fn the_bracket_has_one_hole_one_boss_and_its_straight_edges() {
    let found = of(&shapes::bracket(), 30_000);
    let named: Vec<&RoundFeature> =
        found.rounds.iter().filter(|r| [RoundKind::Hole, RoundKind::Boss].contains(&r.kind)).collect();
    let [hole, boss] = named[..] else { panic!("{:?}", found.rounds) };
    assert_eq!([hole.kind, boss.kind], [RoundKind::Hole, RoundKind::Boss]);
    for (feature, diameter, depth, at, axis) in
        [(hole, 1.8, 1.2, [2.0, 4.0], [0.0, 0.0, 1.0]), (boss, 1.6, 1.0, [2.0, 3.3], [0.0, 1.0, 0.0])]
    {
        let sigma = feature.sigma.unwrap();
        assert!(feature.depth().is_some(), "{:?}", found.rounds);
        assert!((feature.diameter - diameter).abs() < (4.0 * sigma.diameter).max(0.01), "{feature:?}");
        assert!((feature.depth().unwrap() - depth).abs() < 0.03, "{feature:?}");
        let along = (0..3).map(|a| feature.axis[a] * axis[a]).sum::<f64>();
        assert!(along.abs() > 0.999, "{feature:?}");
        let across: Vec<f64> = (0..3).filter(|&a| axis[a] == 0.0).map(|a| feature.centres[0][a]).collect();
        assert!((across[0] - at[0]).abs() < 0.02 && (across[1] - at[1]).abs() < 0.02, "{feature:?}");
    }
    let long = found.edges.iter().filter(|e| e.length > 1.0).count();
    assert!((16..=18).contains(&long), "{long} {:?}", found.edges);
    assert!(found.edges.is_sorted_by(|a, b| a.length >= b.length));
    assert!(found.edges.iter().all(|e| e.kind == StripKind::Crease));
}

#[test]
fn without_points_circles_have_no_name() {
    let part = shapes::bracket().sample(&Scan::new(Sampling::Area { count: 10_000 }));
    let network = extract(&part.cloud, &Params::default()).unwrap().network;
    let found = inspect(&network, &[], part.spacing);
    assert!(!found.rounds.is_empty());
    assert!(found.rounds.iter().all(|r| matches!(r.kind, RoundKind::Circle | RoundKind::Arc)));
    assert_eq!(inspect(&Default::default(), &[], 1.0), Inspection::default());
}

/// An arc of a radius about the origin between two angles, radians, whose radius is known to `sigma`.
fn strip_of(radius: f64, [begin, end]: [f64; 2], sigma: f64) -> Strip {
    let round = Round { centre: [0.0; 3], normal: [0.0, 0.0, 1.0], radius };
    let points = round.samples([radius * begin.cos(), radius * begin.sin(), 0.0], end - begin, 9);
    let known = Sigma::Round { radius: sigma, normal: 0.01, covariance: [[0.0; 4]; 4] };
    let (from, to) = (points[0], points[8]);
    let shape = Shape::Arc { round, sweep: end - begin };
    let piece = Piece { shape, from, to, first: 0, last: 8, deviation: 0.0, sigma: Some(known) };
    let curve =
        BSpline { degree: 1, knots: vec![0.0, 0.0, 1.0, 1.0], controls: vec![from, to], periodic: false };
    Strip {
        kind: StripKind::Crease,
        closed: false,
        start: None,
        end: None,
        points,
        curve,
        curves: vec![piece],
        sources: Vec::new(),
        fold_deg: None,
        evidence: None,
        deviation: 0.0,
        confidence: 1.0,
        sigma: Vec::new(),
        blend: None,
    }
}

/// An arc of a few degrees may have any radius: it comes after those that are known.
#[test]
fn an_arc_whose_diameter_is_open_does_not_head_the_list() {
    let arc = |radius: f64, sigma: f64| strip_of(radius, [0.0, 0.2], sigma);
    let strips = vec![arc(5.0, 0.1), arc(621.0, 163.0), arc(9.0, 0.2)];
    let found = inspect(&Network { nodes: Vec::new(), strips }, &[], 1.0);
    let diameters: Vec<f64> = found.rounds.iter().map(|r| r.diameter).collect();
    assert_eq!(diameters, [18.0, 10.0, 1242.0]);
    assert_eq!(found.rounds.iter().map(RoundFeature::is_open).collect::<Vec<_>>(), [false, false, true]);
}

/// Nodes part the rim of a bore where other lines meet it: it is listed once all the same.
#[test]
fn arcs_of_one_circle_are_one_row_and_circles_that_lie_on_each_other_two() {
    let strips =
        vec![strip_of(5.0, [0.0, 2.0], 0.1), strip_of(9.0, [0.0, 2.0], 0.1), strip_of(5.1, [2.0, 6.2], 0.1)];
    let found = inspect(&Network { nodes: Vec::new(), strips }, &[], 1.0);
    let [circle, arc] = &found.rounds[..] else { panic!("{:?}", found.rounds) };
    assert_eq!((circle.kind, &circle.strips[..], arc.kind), (RoundKind::Circle, &[0, 2][..], RoundKind::Arc));
    assert!(
        circle.diameter > 10.0
            && circle.diameter < 10.2
            && (circle.sweep_deg - 6.2_f64.to_degrees()).abs() < 1e-9
    );
    let strips = vec![strip_of(5.0, [0.0, 6.0], 0.1), strip_of(5.0, [0.0, 6.0], 0.1)];
    assert_eq!(inspect(&Network { nodes: Vec::new(), strips }, &[], 1.0).rounds.len(), 2);
}
