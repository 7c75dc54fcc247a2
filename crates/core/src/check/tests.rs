use super::perfect::perfect;
use super::*;
use crate::curve::BSpline;
use crate::network::{Network, Node, NodeKind, Strip};
use crate::shapes::{self, Shape};

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
    let apex = |p| Node { position: p, kind: NodeKind::Apex, degree: 0, source: 0, sigma: None };
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
