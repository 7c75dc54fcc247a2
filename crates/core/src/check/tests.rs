use super::*;
use crate::curve::BSpline;
use crate::math::vec3::distance;
use crate::network::{Node, NodeKind, Strip, StripKind};
use crate::shapes::{self, Rng, Sampling, Scan, Shape, Truth, TruthCurve};

/// A truth as the network that a perfect extraction would give: the polylines as curves of degree 1, a loop's as the
/// control points of a cubic.
fn perfect(truth: &Truth) -> Network {
    let node =
        |n: &shapes::TruthNode| Node { position: n.position, kind: n.kind, degree: n.degree, source: 0 };
    Network {
        nodes: truth.nodes.iter().map(node).collect(),
        strips: truth.curves.iter().map(strip).collect(),
    }
}

fn strip(curve: &TruthCurve) -> Strip {
    let degree = if curve.closed { 3 } else { 1 };
    let mut knots = vec![0.0];
    for [a, b] in curve.segments() {
        knots.push(knots[knots.len() - 1] + distance(a, b));
    }
    if !curve.closed {
        knots.insert(0, 0.0);
        knots.push(knots[knots.len() - 1]);
    }
    Strip {
        kind: curve.kind,
        closed: curve.closed,
        start: curve.start,
        end: curve.end,
        points: curve.points.clone(),
        curve: BSpline { degree, knots, controls: curve.points.clone(), periodic: curve.closed },
        sources: vec![0, 1],
        fold_deg: None,
        evidence: 0.0,
        deviation: 0.0,
        confidence: 1.0,
    }
}

/// The fault that a change of the bracket's network (18 open strips first, then 4 loops) brings.
fn fault(change: fn(&mut Network)) -> String {
    let mut changed = perfect(&shapes::bracket().network);
    network(&changed).unwrap();
    change(&mut changed);
    network(&changed).unwrap_err().join("\n")
}

#[test]
fn true_networks_of_all_shapes_hold() {
    let part = |s: Shape| perfect(&s.network);
    for n in [
        part(shapes::bracket()),
        part(shapes::brick()),
        part(shapes::cylinders(1.0, 1.0)),
        part(shapes::pipe_cross()),
        part(shapes::bent_sheet(60.0)),
        part(shapes::cone(1.0, 2.0)),
        part(shapes::sphere(1.0)),
    ] {
        network(&n).unwrap();
        sources(&n, 2).unwrap();
    }
}

#[test]
fn a_node_that_does_not_exist_is_named() {
    assert!(fault(|n| n.strips[3].end = Some(99)).contains("strip 3: end is node 99 of 12"));
}

#[test]
fn a_loop_with_a_node_and_an_open_strip_without_are_named() {
    assert!(fault(|n| n.strips[20].start = Some(0)).contains("strip 20: closed is true, start is Some(0)"));
    assert!(fault(|n| n.strips[2].end = None).contains("strip 2: closed is false, end is None"));
}

#[test]
fn an_end_beside_its_node_is_named() {
    assert!(fault(|n| n.strips[5].points[0][1] += 1e-12).contains("strip 5: start point"));
    assert!(fault(|n| n.strips[5].points.reverse()).contains("is not on its node"));
}

#[test]
fn a_wrong_degree_and_a_wrong_kind_are_named() {
    assert!(fault(|n| n.nodes[4].degree = 2).contains("node 4: degree 2 but 3 strip ends"));
    assert!(fault(|n| n.nodes[4].kind = NodeKind::Corner).contains("node 4: kind corner with 3 strip ends"));
    assert!(fault(|n| drop(n.strips.remove(0))).contains("kind junction with 2 strip ends"));
}

#[test]
fn each_kind_goes_with_its_degree_alone() {
    let ends = |degree: u32| {
        let mut n = perfect(&shapes::bracket().network);
        n.strips.retain(|s| !s.closed);
        let at = n.strips[0].start.unwrap();
        let touches = |s: &Strip| s.start == Some(at) || s.end == Some(at);
        let mut left = degree;
        n.strips.retain(|s| !touches(s) || (left > 0, left = left.saturating_sub(1)).0);
        let joined =
            |i: u32| n.strips.iter().flat_map(|s| [s.start, s.end]).filter(|&e| e == Some(i)).count();
        for i in 0..n.nodes.len() {
            n.nodes[i].degree = joined(i as u32) as u32;
        }
        let kinds = [NodeKind::Apex, NodeKind::End, NodeKind::Corner, NodeKind::Junction];
        for i in 0..n.nodes.len() {
            n.nodes[i].kind = kinds[n.nodes[i].degree.min(3) as usize];
        }
        network(&n).unwrap();
        for kind in kinds {
            n.nodes[at as usize].kind = kind;
            assert_eq!(network(&n).is_ok(), kind == kinds[degree as usize]);
        }
    };
    (0..4).for_each(ends);
}

#[test]
fn two_nodes_at_one_place_are_named() {
    let apex = |p| Node { position: p, kind: NodeKind::Apex, degree: 0, source: 0 };
    let n = Network { nodes: vec![apex([1.0, 0.0, 2.0]), apex([1.0, -0.0, 2.0])], strips: Vec::new() };
    assert!(network(&n).unwrap_err()[0].contains("nodes 0 and 1"));
}

#[test]
fn too_few_points_are_named() {
    assert!(fault(|n| n.strips[1].points.truncate(1)).contains("strip 1: 1 points, at least 2"));
    assert!(fault(|n| n.strips[21].points.truncate(2)).contains("strip 21: 2 points, at least 3"));
    assert!(fault(|n| n.strips[21].points.clear()).contains("strip 21: 0 points"));
}

#[test]
fn repeated_points_and_a_repeated_seam_are_named() {
    assert!(
        fault(|n| n.strips[18].points[7] = n.strips[18].points[6]).contains("strip 18: point 6 is repeated")
    );
    assert!(
        fault(|n| n.strips[18].points[719] = n.strips[18].points[0]).contains("its first point is repeated")
    );
    let both = fault(|n| n.strips[0].points[1] = n.strips[0].points[0]);
    assert!(both.contains("strip 0: no length"));
}

#[test]
fn numbers_that_are_not_finite_are_named() {
    assert!(fault(|n| n.nodes[0].position[2] = f64::NAN).contains("node 0: position"));
    assert!(fault(|n| n.strips[19].points[5][0] = f64::INFINITY).contains("strip 19: a point is not finite"));
    assert!(fault(|n| n.strips[19].curve.controls[5][0] = f64::NAN).contains("strip 19: a control point"));
    assert!(fault(|n| n.strips[19].curve.knots[5] = f64::NAN).contains("strip 19: a knot is not finite"));
}

#[test]
fn a_deviation_below_zero_and_a_confidence_beyond_one_are_named() {
    assert!(fault(|n| n.strips[2].deviation = -1e-9).contains("strip 2: deviation"));
    assert!(fault(|n| n.strips[2].deviation = f64::NAN).contains("strip 2: deviation"));
    assert!(fault(|n| n.strips[2].confidence = 1.5).contains("strip 2: confidence 1.5"));
    assert!(fault(|n| n.strips[2].confidence = f64::NAN).contains("strip 2: confidence"));
}

#[test]
fn a_source_twice_in_a_row_none_and_one_beyond_the_cloud_are_named() {
    assert!(fault(|n| n.strips[4].sources = vec![3, 8, 8, 1]).contains("strip 4: source 8 twice"));
    assert!(fault(|n| n.strips[4].sources.clear()).contains("strip 4: no source"));
    let mut n = perfect(&shapes::bracket().network);
    n.strips[4].sources = vec![3, 8, 3];
    n.nodes[2].source = 12;
    let faults = sources(&n, 8).unwrap_err();
    assert_eq!(faults, ["node 2: source 12 of 8 points", "strip 4: source 8 of 8 points"]);
}

#[test]
fn knots_that_do_not_fit_are_named() {
    assert!(fault(|n| n.strips[0].curve.knots.truncate(3)).contains("strip 0: 3 knots, 4 needed"));
    assert!(fault(|n| n.strips[18].curve.knots.push(1e9)).contains("strip 18: 722 knots, 721 needed"));
    assert!(fault(|n| n.strips[18].curve.knots.swap(3, 4)).contains("strip 18: the knots fall after knot 3"));
    assert!(fault(|n| n.strips[0].curve.knots.fill(2.0)).contains("strip 0: the knots span nothing"));
    assert!(
        fault(|n| n.strips[0].curve.knots[0] -= 1.0).contains("strip 0: the first or last 2 knots differ")
    );
}

#[test]
fn a_curve_that_does_not_fit_its_strip_is_named() {
    assert!(fault(|n| n.strips[0].curve = BSpline::default()).contains("strip 0: curve of degree 0"));
    assert!(
        fault(|n| n.strips[0].curve.controls.truncate(1)).contains("strip 0: 1 control points, at least 2")
    );
    assert!(fault(|n| n.strips[20].curve.periodic = false).contains("strip 20: closed is true but"));
    assert!(fault(|n| n.strips[7].curve.controls[1][0] += 1e-6).contains("strip 7: the curve's end is"));
    let mut near = perfect(&shapes::bracket().network);
    near.strips[7].curve.controls[1][0] += 1e-10;
    network(&near).unwrap();
}

#[test]
fn a_strip_given_twice_is_named_from_either_end_and_any_start() {
    let again = fault(|n| {
        let mut twin = n.strips[6].clone();
        twin.points.reverse();
        twin.curve.controls.reverse();
        std::mem::swap(&mut twin.start, &mut twin.end);
        n.strips.push(twin);
    });
    assert!(again.contains("strips 6 and 22: the same points"), "{again}");
    let around = fault(|n| {
        let mut twin = n.strips[19].clone();
        twin.points.rotate_left(100);
        twin.points.reverse();
        n.strips.push(twin);
    });
    assert_eq!(around, "strips 19 and 22: the same points");
}

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
