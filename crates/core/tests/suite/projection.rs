//! The projected distance (Tran 2013) and its comparison measures, on shapes with known edges.

use lineament::detect::baselines::Detector;
use lineament::detect::points::mark;
use lineament::shapes::{Sampled, Sampling, Scan, bracket, cube_386, sheet, sphere};
use lineament::{Class, Cloud, Error, Method, Params, StripKind, check, evaluate, extract};

fn by_projection() -> Params {
    Params { method: Method::Projection, ..Params::default() }
}

/// Marks of a detector in the order of the cloud.
fn marked(cloud: &Cloud, detector: Detector) -> Vec<bool> {
    marked_with(cloud, &Params::default(), detector)
}

fn marked_with(cloud: &Cloud, params: &Params, detector: Detector) -> Vec<bool> {
    let found = mark(cloud, params, &[detector]).unwrap();
    found.classes(0).into_iter().map(|class| !matches!(class, Class::Smooth | Class::Clutter)).collect()
}

fn on_edges(sampled: &Sampled) -> Vec<bool> {
    sampled.distances().iter().map(|d| *d < 0.25 * sampled.spacing).collect()
}

fn count(side: &[bool]) -> usize {
    side.iter().filter(|x| **x).count()
}

fn f1(found: &[bool], truth: &[bool]) -> f64 {
    let hits = found.iter().zip(truth).filter(|(f, t)| **f && **t).count();
    2.0 * hits as f64 / (count(found) + count(truth)) as f64
}

#[test]
fn the_cube_of_386_has_exactly_its_92_edge_and_corner_points_marked() {
    let cube = cube_386();
    let truth = on_edges(&cube);
    assert_eq!(count(&truth), 92);
    assert_eq!(marked(&cube.cloud, Detector::Projection), truth);
}

#[test]
fn every_comparison_measure_marks_the_cubes_92_and_more() {
    let cube = cube_386();
    let truth = on_edges(&cube);
    for detector in Detector::ALL.into_iter().filter(|d| *d != Detector::Projection) {
        let found = marked(&cube.cloud, detector);
        assert!(truth.iter().zip(&found).all(|(t, f)| *f || !*t), "{detector:?} misses an edge point");
        assert!((100..=260).contains(&count(&found)), "{detector:?} marks {}", count(&found));
    }
}

#[test]
fn classes_of_the_method_are_the_papers_own_marks_and_not_the_vicinity_of_its_lines() {
    let cube = cube_386();
    let found = extract(&cube.cloud, &by_projection()).unwrap();
    let classes: Vec<bool> = found.classes().iter().map(|c| *c != Class::Smooth).collect();
    assert_eq!(classes, marked(&cube.cloud, Detector::Projection));
}

#[test]
fn the_cube_has_12_creases_and_8_junctions_by_projection() {
    let cube = cube_386();
    let network = extract(&cube.cloud, &by_projection()).unwrap().network;
    check::network(&network).unwrap();
    assert!(evaluate::isomorphic(&network, &cube.truth), "{} strips", network.strips.len());
}

#[test]
fn one_cut_marks_the_edges_of_a_bracket_better_than_any_other_measure() {
    let part = bracket().sample(&Scan::new(Sampling::Grid { step: 0.1 }));
    let truth = on_edges(&part);
    let mut params = Params::default();
    params.projection.classes = 2;
    let scores = Detector::ALL.map(|detector| f1(&marked_with(&part.cloud, &params, detector), &truth));
    assert!(scores[0] > 0.9, "{scores:?}");
    assert!(scores[1..].iter().all(|other| *other < scores[0]), "{scores:?}");
}

#[test]
fn three_classes_mark_what_lies_within_a_spacing_of_an_edge() {
    let part = bracket().sample(&Scan::new(Sampling::Grid { step: 0.1 }));
    let at_edges: Vec<bool> = part.distances().iter().map(|d| *d < part.spacing).collect();
    let found = f1(&marked(&part.cloud, Detector::Projection), &at_edges);
    assert!(found > 0.85, "{found}");
}

#[test]
fn a_noisy_sphere_is_hardly_marked_at_all() {
    let ball = sphere(1.0).sample(&Scan::new(Sampling::Area { count: 8000 }).noise(0.2).seed(3));
    let share = count(&marked(&ball.cloud, Detector::Projection)) as f64 / 8000.0;
    assert!(share < 0.1, "{share}");
}

#[test]
fn scores_do_not_depend_on_the_order_of_the_points_nor_on_the_number_of_threads() {
    let part = bracket().sample(&Scan::new(Sampling::Area { count: 3000 }).noise(0.05).seed(4));
    let turned = Cloud::new(part.cloud.positions.iter().rev().copied().collect());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let all = mark(&part.cloud, &Params::default(), &Detector::ALL).unwrap();
    let other = pool.install(|| mark(&turned, &Params::default(), &Detector::ALL).unwrap());
    for which in 0..Detector::ALL.len() {
        let mut scores = other.scores(which);
        scores.reverse();
        assert_eq!(all.scores(which), scores, "{:?}", Detector::ALL[which]);
    }
}

#[test]
fn an_exact_plane_has_no_mark_by_any_measure_and_no_crease() {
    let flat = sheet().sample(&Scan::new(Sampling::Area { count: 2000 }));
    for detector in Detector::ALL {
        assert_eq!(count(&marked(&flat.cloud, detector)), 0, "{detector:?}");
    }
    let network = extract(&flat.cloud, &by_projection()).unwrap().network;
    check::network(&network).unwrap();
    assert!(network.strips.iter().all(|s| s.kind == StripKind::Border));
}

#[test]
fn noise_above_the_limit_is_told_and_noise_below_is_not() {
    let notes = |noise: f64| {
        let part = bracket().sample(&Scan::new(Sampling::Area { count: 8000 }).noise(noise).seed(2));
        let by_detector = mark(&part.cloud, &Params::default(), &[Detector::Projection]).unwrap();
        let by_method = extract(&part.cloud, &by_projection()).unwrap();
        assert_eq!(by_detector.report.notes, by_method.report.notes);
        by_method.report.notes
    };
    assert!(notes(0.02).is_empty());
    let loud = notes(0.4);
    assert!(loud.len() == 1 && loud[0].contains("noise"), "{loud:?}");
}

#[test]
fn few_points_are_marked_or_refused_by_name() {
    let corner = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let by =
        |points: &[[f64; 3]], detector| mark(&Cloud::new(points.to_vec()), &Params::default(), &[detector]);
    for detector in Detector::ALL {
        assert_eq!(by(&corner, detector).unwrap().classes(0).len(), 4);
        let few = by(&corner[..3], detector);
        assert!(matches!(few, Err(Error::TooFewPoints { .. })), "{few:?}");
    }
    let mut holed = cube_386().cloud.positions;
    holed.push([f64::NAN; 3]);
    let found = by(&holed, Detector::Projection).unwrap();
    assert_eq!(found.classes(0)[386], Class::Smooth);
    assert!(found.scores(0)[386].is_nan());
}
