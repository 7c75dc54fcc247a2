mod lines;

use super::*;
use crate::check::perfect::{perfect, strip};
use crate::network::{Network, Strip, StripKind};
use crate::shapes::{self, Rng, Sampling, Scan, Truth};

#[test]
fn the_truth_itself_scores_full_marks() {
    for shape in [shapes::bracket(), shapes::brick(), shapes::cylinders(1.0, 1.0), shapes::bent_sheet(60.0)] {
        let score = against(&perfect(&shape.network), &shape.network, 0.05);
        assert_eq!([score.at_1h.precision, score.at_1h.recall, score.at_1h.f1], [1.0; 3], "{}", shape.name);
        assert!(score.to_truth.max < 1.0 && score.from_truth.max < 0.11, "{} {score:?}", shape.name);
        assert_eq!(score.loops[0], score.loops[1]);
        assert_eq!(score.curves_found[0], score.curves_found[1]);
        assert_eq!(score.junctions_hit[0], score.junctions_hit[1]);
    }
}

#[test]
fn scores_are_the_shares_of_what_is_near() {
    // Of a cube's twelve edges six are left, and one of these lies 1.5 spacings off.
    let (truth, h) = (shapes::cube(1.0).network, 0.02);
    let mut n = perfect(&truth);
    n.strips.truncate(6);
    for p in &mut n.strips[0].points {
        let outwards = p.map(|x| 2.0 * x * 1.5 * h / 3f64.sqrt());
        *p = crate::math::vec3::add(*p, outwards);
    }
    let score = against(&n, &truth, h);
    assert!((score.at_1h.precision - 5.0 / 6.0).abs() < 0.01, "{score:?}");
    assert_eq!(score.at_2h.precision, 1.0);
    assert_eq!(score.curves_found, [5, 12]);
    assert!((score.at_2h.recall - 0.5).abs() < 0.04, "{score:?}");
    assert!((score.length_spacings - 300.0).abs() < 3.0);
}

#[test]
fn nothing_against_something_scores_nothing() {
    let score = against(&Network::default(), &shapes::cube(1.0).network, 0.1);
    assert_eq!([score.at_2h.precision, score.at_2h.recall, score.at_2h.f1], [0.0; 3]);
    assert!(score.to_truth.mean.is_nan() && score.from_truth.mean.is_nan());
    assert_eq!(score.junctions_hit, [0, 8]);
    let none = against(&perfect(&shapes::tube().network), &Truth::default(), 0.1);
    assert_eq!(none.at_1h.f1, 0.0);
}

#[test]
fn a_line_missing_or_found_where_a_crease_fades_is_neither_good_nor_bad() {
    let truth = shapes::cylinders(1.0, 1.0).network;
    let mut cut = perfect(&truth);
    for s in cut.strips.iter_mut().filter(|s| !s.closed) {
        s.points.retain(|p| p[2].abs() < 0.935);
    }
    let score = against(&cut, &truth, 0.03);
    assert_eq!(score.at_1h.f1, 1.0, "{score:?}");
    // Two spacings beside the pole: far from the sharp stretch, near to the weak.
    let mut beside = perfect(&truth);
    beside.strips.truncate(1);
    beside.strips[0].points = vec![[0.0, 0.05, 1.0], [0.0, 0.0, 1.0], [0.05, 0.0, 1.0]];
    assert_eq!(against(&beside, &truth, 0.03).at_1h.precision, 0.0);
    assert!(against(&beside, &truth, 0.03).to_truth.mean.is_nan());
}

#[test]
fn a_network_is_isomorphic_to_its_own_truth_under_any_numbering() {
    for shape in [
        shapes::cube(1.0),
        shapes::bracket(),
        shapes::brick(),
        shapes::star_prism(5),
        shapes::bent_sheet(60.0),
    ] {
        let mut n = perfect(&shape.network);
        let mut rng = Rng::new(4);
        let count = n.nodes.len();
        let mut order: Vec<u32> = (0..count as u32).collect();
        for i in (1..count).rev() {
            order.swap(i, rng.below(i as u64 + 1) as usize);
            let strips = n.strips.len();
            n.strips.swap(rng.below(strips as u64) as usize, 0);
        }
        for s in &mut n.strips {
            (s.start, s.end) = (s.end.map(|i| order[i as usize]), s.start.map(|i| order[i as usize]));
        }
        assert!(isomorphic(&n, &shape.network), "{}", shape.name);
    }
}

#[test]
fn another_graph_is_not_isomorphic() {
    let cube = shapes::cube(1.0).network;
    let change = |f: fn(&mut Network)| {
        let mut n = perfect(&cube);
        f(&mut n);
        isomorphic(&n, &cube)
    };
    assert!(!change(|n| drop(n.strips.pop())));
    assert!(!change(|n| n.strips[0].kind = StripKind::Border));
    assert!(!change(|n| n.strips.push(strip(&shapes::tube().network.curves[0]))));
    // Two opposite edges of one side exchange an end: still 8 nodes of degree 3 and 12 strips.
    let twisted = change(|n| {
        let across = |s: &Strip| s.start.into_iter().chain(s.end).collect::<Vec<_>>();
        let (first, other) = (
            across(&n.strips[0]),
            1 + n.strips[1..]
                .iter()
                .position(|s| {
                    let e = across(s);
                    !e.contains(&n.strips[0].start.unwrap()) && !e.contains(&n.strips[0].end.unwrap())
                })
                .unwrap(),
        );
        let swapped = n.strips[other].end;
        n.strips[other].end = Some(first[1]);
        n.strips[0].end = swapped;
    });
    assert!(!twisted);
    assert!(!isomorphic(&Network::default(), &cube));
    assert!(isomorphic(&Network::default(), &shapes::sphere(1.0).network));
}

#[test]
fn corners_between_like_strips_are_dissolved() {
    // The sheet's four borders with corners are one loop with the hole's: as a detector may say that sees no corner.
    let truth = shapes::sheet_with_hole().network;
    let mut n = perfect(&truth);
    let round = n.strips.pop().unwrap();
    n = Network { nodes: Vec::new(), strips: vec![round.clone(), round] };
    assert!(isomorphic(&n, &truth));
    n.strips[0].kind = StripKind::Crease;
    assert!(!isomorphic(&n, &truth));
    // Two border halves of a bent sheet, corners dissolved, hang on the crease's ends.
    let bent = shapes::bent_sheet(60.0).network;
    let mut theta = perfect(&bent);
    let crease = theta.strips.iter().position(|s| s.kind == StripKind::Crease).unwrap();
    let mut strips = vec![theta.strips[crease].clone(); 3];
    strips[1].kind = StripKind::Border;
    strips[2].kind = StripKind::Border;
    theta.strips = strips;
    assert!(isomorphic(&theta, &bent));
    theta.strips[2].kind = StripKind::Crease;
    assert!(!isomorphic(&theta, &bent));
}

#[test]
fn samples_score_well_against_the_network_that_made_them() {
    let part = shapes::bracket().sample(&Scan::new(Sampling::BlueNoise { count: 5000 }));
    let score = against(&perfect(&part.truth), &part.truth, part.spacing);
    assert_eq!(score.at_1h.f1, 1.0);
    assert_eq!(score.curves_found, [22, 22]);
}
