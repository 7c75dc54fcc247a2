//! The truth of every shape: its faces, curves, folds, counts and areas.

use std::f64::consts::PI;

use super::super::*;
use super::{all, faces_at, touches};
use crate::math::vec3::dot;
use crate::network::{NodeKind, StripKind};

#[test]
fn creases_lie_on_two_faces_and_borders_on_one() {
    for shape in all() {
        for curve in &shape.network.curves {
            let inner = &curve.points[usize::from(!curve.closed)..];
            let inner = &inner[..inner.len() - usize::from(!curve.closed)];
            let middles: Vec<_> =
                curve.points.windows(2).map(|w| [0, 1, 2].map(|k| (w[0][k] + w[1][k]) / 2.0)).collect();
            let probes = if inner.is_empty() { &middles } else { inner };
            let wanted = if curve.kind == StripKind::Border { 1 } else { 2 };
            for &p in probes {
                assert_eq!(faces_at(&shape, p), wanted, "{} {p:?}", shape.name);
            }
        }
    }
}

#[test]
fn folds_are_the_angles_between_the_normals_of_the_faces() {
    for shape in all() {
        for curve in shape.network.curves.iter().filter(|c| c.kind == StripKind::Crease) {
            let m = curve.points.len();
            let (p, fold) = if m == 2 {
                ([0, 1, 2].map(|k| (curve.points[0][k] + curve.points[1][k]) / 2.0), curve.fold_deg[0])
            } else {
                (curve.points[m / 3], curve.fold_deg[m / 3])
            };
            let on = |f: &&Face| f.surface.distance(p) < 1e-9 && touches(f, p);
            let normals: Vec<_> = shape.faces.iter().filter(on).map(|f| f.normal(p)).collect();
            let angle = dot(normals[0], normals[1]).clamp(-1.0, 1.0).acos().to_degrees();
            assert!((angle - fold).abs() < 1e-5, "{}: {angle} {fold}", shape.name);
        }
    }
}

#[test]
fn networks_have_the_stated_counts() {
    let counts = |s: &Shape| {
        let t = &s.network;
        let borders = t.curves.iter().filter(|c| c.kind == StripKind::Border).count();
        let concave = t.curves.iter().filter(|c| c.fold == Fold::Concave).count();
        [t.curves.len(), t.loops(), borders, concave, t.count(NodeKind::Junction), t.count(NodeKind::Corner)]
    };
    let stated = [
        [12, 0, 0, 0, 8, 0],
        [12, 0, 0, 0, 8, 0],
        [15, 0, 0, 0, 10, 0],
        [12, 0, 0, 0, 8, 0],
        [30, 0, 0, 5, 20, 0],
        [22, 4, 0, 2, 12, 0],
        [22, 10, 8, 5, 8, 0],
        [6, 6, 0, 2, 0, 0],
        [8, 4, 0, 4, 2, 0],
        [12, 12, 0, 2, 0, 0],
        [4, 0, 4, 0, 0, 4],
        [5, 1, 5, 0, 0, 4],
        [7, 0, 6, 0, 2, 4],
        [2, 2, 2, 0, 0, 0],
        [1, 1, 0, 0, 0, 0],
        [13, 13, 0, 5, 0, 0],
        [0; 6],
        [0; 6],
    ];
    for (shape, stated) in all().iter().zip(stated) {
        assert_eq!(counts(shape), stated, "{}", shape.name);
    }
    assert_eq!(cone(1.0, 2.0).network.nodes[0].position, [0.0, 0.0, 2.0]);
    assert_eq!(cone(1.0, 2.0).network.count(NodeKind::Apex), 1);
}

#[test]
fn areas_are_right() {
    let exact = [
        (cube(1.0), 6.0),
        (sheet_with_hole(), 12.0 - PI * 0.49),
        (tube(), 8.0 * PI),
        (cone(1.0, 2.0), PI * (1.0 + 5f64.sqrt())),
        (sphere(2.0), 16.0 * PI),
        (torus(1.0, 0.4), 1.6 * PI * PI),
        (bent_sheet(60.0), 12.0),
        // The L has 6 + 5 - 1.2 by 1.2 of profile; the bore takes two discs, the boss none.
        (bracket(), 2.0 * 1.2 * 9.8 + 4.0 * 22.0 - 2.0 * PI * 0.81 + 1.8 * PI * 1.2 + 1.6 * PI),
        // Each of four half mantles loses the 4 r^2 that the other's quarter arcs cover: 8 r^2 a cylinder.
        (cylinders(1.0, 1.0), 2.0 * (10.0 * PI - 8.0) + 4.0 * PI),
        (counterbored_plate(), 30.0 + 16.0 * 1.2 + PI * (2.0 * 0.7 - 4.0 * 0.35 * 0.35 + 4.0 * 0.35 * 0.7)),
        (
            stepped_plate(),
            30.0 + 6.0 * 1.6 + 2.0 * (1.6 * 2.6 + 0.8 * 2.4) + PI * (1.2 * 0.4 + 0.6 * 1.2 - 0.18 + 0.5),
        ),
        // The rib hides two strips of 0.6 by 2, and shows two triangles and its slope.
        (ribbed_bracket(), 2.0 * 0.8 * 8.2 + 4.0 * 18.0 - 2.4 + 4.0 + 0.6 * 8f64.sqrt()),
        (slotted_plate(), 24.0 + 14.0 * 0.8 - 2.0 * (1.12 + PI * 0.16) + 0.8 * (2.8 + 0.8 * PI)),
    ];
    for (shape, area) in exact {
        assert!((shape.area() - area).abs() < 1e-4 * area, "{}: {} {area}", shape.name, shape.area());
    }
}
