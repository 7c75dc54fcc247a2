//! The steps to the sections of a cloud are those of the sections themselves.

use lineament::math::vec3::distance;
use lineament::section::{Axis, Outline, Planes, SectionParams, SliceSteps, section, steps};
use lineament::shapes::{Rng, Sampled, Sampling, Scan, cylinders};

fn params(outline: Outline) -> SectionParams {
    let planes = Planes::Count(3);
    SectionParams { axis: Axis::Coordinate(2), planes, outline, carry: false, ..SectionParams::default() }
}

fn scan() -> Sampled {
    cylinders(1.0, 0.6).sample(&Scan::new(Sampling::BlueNoise { count: 6000 }).noise(0.2).seed(2))
}

/// The largest round of a slice.
fn rounds(steps: &SliceSteps) -> u32 {
    steps.features.iter().map(|f| f.round).max().unwrap()
}

#[test]
fn slabs_hold_the_points_counted_and_these_lie_beside_the_plane() {
    let scan = scan();
    let params = params(Outline::Hull);
    let (sections, steps) = (section(&scan.cloud, &params).unwrap(), steps(&scan.cloud, &params).unwrap());
    assert_eq!(steps.len(), sections.sections.len());
    for (section, steps) in sections.sections.iter().zip(&steps) {
        assert_eq!((section.plane, section.points), (steps.plane, steps.slab.len()));
        let off = |&i: &u32| (scan.cloud.positions[i as usize][2] - section.height).abs();
        assert!(steps.slab.iter().all(|i| off(i) < 3.0 * scan.spacing));
        assert!(steps.projected.iter().all(|p| (p.at[2] - section.height).abs() < 1e-9));
        let of_a_contour = steps.projected.iter().filter(|p| p.contour.is_some()).count();
        assert!(of_a_contour as f64 > 0.9 * steps.projected.len() as f64);
        // Without a cut, every contour of the result has its feature points for vertices.
        assert_eq!(section.contours.len(), steps.closed.len());
        let vertices: usize = section.contours.iter().map(|c| c.points.len()).sum();
        assert_eq!(vertices, steps.features.len());
    }
}

#[test]
fn circles_touch_the_feature_points_that_they_gave() {
    let scan = scan();
    let all = steps(&scan.cloud, &params(Outline::Voronoi)).unwrap();
    let mut circles = 0;
    for steps in &all {
        for circle in &steps.circles {
            let touched =
                |at| (distance(at, circle.centre) - circle.radius).abs() < 1e-9 * circle.radius.max(1.0);
            let found =
                steps.features.iter().filter(|f| f.contour == circle.contour && touched(f.at)).count();
            assert!(found >= 3, "{circle:?} gave {found} feature points");
            circles += 1;
        }
        assert!(rounds(steps) > 0);
    }
    assert!(circles > 20, "{circles}");
}

#[test]
fn steps_do_not_depend_on_the_order_of_the_points() {
    let scan = scan();
    let params = params(Outline::Hull);
    let mut order: Vec<usize> = (0..scan.cloud.len()).collect();
    let mut rng = Rng::new(5);
    (1..order.len()).rev().for_each(|i| order.swap(i, rng.between(0.0, i as f64 + 1.0) as usize));
    let turned: Vec<[f64; 3]> = order.iter().map(|&i| scan.cloud.positions[i]).collect();
    let [there, here] = [steps(&scan.cloud, &params).unwrap(), steps(&turned, &params).unwrap()];
    for (a, b) in there.iter().zip(&here) {
        assert_eq!((&a.features, &a.projected), (&b.features, &b.projected));
        let mut rows: Vec<u32> = b.slab.iter().map(|&i| order[i as usize] as u32).collect();
        rows.sort_unstable();
        assert_eq!(a.slab, rows);
    }
}
