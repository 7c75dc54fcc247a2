//! Borders around holes in the surface, which can be left out.

use crate::common::{cloud, found};
use lineament::shapes::{Sampling, Scan, Shape, sheet_with_hole, tube};
use lineament::{Cloud, NodeKind, StripKind, check};

fn scan(shape: Shape) -> Cloud {
    shape.sample(&Scan::new(Sampling::Area { count: 6000 }).seed(3)).cloud
}

/// The number of borders that are left without those around holes shorter than `length`.
#[track_caller]
fn borders(cloud: &Cloud, length: f64) -> usize {
    let mut found = found(cloud);
    found.choose_holes(&cloud.positions, length);
    check::network(&found.network).unwrap();
    found.network.strips.iter().filter(|strip| strip.kind == StripKind::Border).count()
}

#[test]
fn a_border_around_a_hole_is_left_out_if_it_is_short_and_the_rim_of_the_sheet_never() {
    // The hole is 4.4 around, the sheet 14.
    let sheet = scan(sheet_with_hole());
    assert_eq!([0.0, 4.0, 5.0, 100.0].map(|length| borders(&sheet, length)), [5, 5, 4, 4]);
    let moved = Cloud::new(sheet.positions.iter().map(|p| [p[0] + 4e6, 2.0 * p[2], p[1] - 3e5]).collect());
    assert_eq!([4.0, 5.0].map(|length| borders(&moved, length)), [5, 4]);
}

#[test]
fn the_rims_of_a_tube_are_no_holes() {
    let tube = scan(tube());
    let all = borders(&tube, 0.0);
    assert!(all >= 2);
    assert_eq!(borders(&tube, f64::MAX), all);
}

#[test]
fn a_hole_with_corners_is_left_out_with_them() {
    let grid = (0..60).flat_map(|x| (0..50).map(move |y| [f64::from(x), f64::from(y), 0.0]));
    let window = |p: &[f64; 3]| (20.0..35.0).contains(&p[0]) && (15.0..30.0).contains(&p[1]);
    let points: Vec<[f64; 3]> = grid.filter(|p| !window(p)).collect();
    let mut found = found(&cloud(&points));
    assert_eq!((found.network.strips.len(), found.network.count(NodeKind::Corner)), (8, 8));
    found.choose_holes(&points, 100.0);
    check::network(&found.network).unwrap();
    assert_eq!((found.network.strips.len(), found.network.count(NodeKind::Corner)), (4, 4));
    assert!(found.network.strips.iter().all(|strip| strip.length() > 40.0));
}
