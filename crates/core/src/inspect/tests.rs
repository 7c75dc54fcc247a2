use super::*;
use crate::network::StripKind;
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
