//! Features that the stack of slices names.

use super::{cut, scanned};

use lineament::Cloud;
use lineament::section::{Feature, Run, SectionParams, Stack, stack};
use lineament::shapes::{self, Shape};

fn features(cloud: &Cloud, axis: usize, count: usize) -> (Stack, f64) {
    let sections = cut(cloud, axis, count);
    (stack(cloud, &sections, &SectionParams::default()).unwrap(), sections.spacing)
}

fn radius(run: &Run) -> Option<f64> {
    match run.feature {
        Feature::Extrusion { radius } => radius,
        _ => None,
    }
}

fn near(found: f64, truth: f64, spacing: f64) {
    assert!((found - truth).abs() <= 0.1 * spacing, "{found} for {truth}, spacing {spacing}");
}

#[test]
fn the_bracket_has_a_bore_in_its_foot_and_a_boss_on_its_wall() {
    let cloud = scanned(&shapes::bracket(), 40_000, 0.1);
    let (stack_z, h) = features(&cloud, 2, 50);
    let bores: Vec<&Run> = stack_z.runs.iter().filter(|r| r.hole).collect();
    assert_eq!(bores.len(), 1, "{:?}", stack_z.runs);
    near(radius(bores[0]).unwrap(), 0.9, h);
    near(bores[0].from, 0.0, h);
    near(bores[0].to, 1.2, h);

    let (stack_y, h) = features(&cloud, 1, 60);
    let bosses: Vec<&Run> = stack_y.runs.iter().filter(|r| radius(r).is_some()).collect();
    assert_eq!(bosses.len(), 1, "{:?}", stack_y.runs);
    near(radius(bosses[0]).unwrap(), 0.8, h);
    near(bosses[0].from, 1.2, h);
    near(bosses[0].to, 2.2, h);
}

#[test]
fn the_stepped_shaft_is_a_row_of_round_extrusions() {
    let cloud = scanned(&shapes::stepped_shaft(), 40_000, 0.1);
    let (found, h) = features(&cloud, 2, 70);
    let truth = [(0.6, 0.0, 1.5), (1.0, 1.5, 3.0), (1.4, 3.0, 3.6), (1.0, 3.6, 4.2), (0.8, 4.2, 4.8)];
    let steps: Vec<&Run> = found.runs.iter().filter(|r| radius(r).is_some()).collect();
    assert_eq!(steps.len(), truth.len() + 1, "{:?}", found.runs);
    for (step, (r, from, to)) in steps.iter().zip(truth) {
        near(radius(step).unwrap(), r, h);
        near(step.from, from, h);
        near(step.to, to, h);
        assert!(!step.hole);
    }
    near(radius(steps[5]).unwrap(), 1.0, h);
    near(steps[5].from, 4.8, h);
    near(steps[5].to, 6.7, h);
    // The chamfer is all that is not an extrusion.
    assert!(found.runs.len() <= truth.len() + 2, "{:?}", found.runs);
}

#[test]
fn nothing_is_named_that_the_bracket_does_not_have() {
    let cloud = scanned(&shapes::bracket(), 40_000, 0.1);
    // The foot, the wall under and over the boss, along y the foot before and behind the bore as well.
    let along_z = [(0.0, 1.2), (1.2, 2.5), (4.1, 5.0)];
    let along_y = [(0.0, 1.2), (1.2, 3.1), (1.2, 2.2), (4.9, 6.0)];
    for count in [25, 40, 50] {
        for (axis, truth) in [(2, &along_z[..]), (1, &along_y[..])] {
            let (found, h) = features(&cloud, axis, count);
            for run in &found.runs {
                assert!(matches!(run.feature, Feature::Extrusion { .. }), "{run:?}");
                // Where a bore or a boss begins or ends, slices touch it and faces are seen from their edge.
                let same = |&(from, to): &(f64, f64)| {
                    let within =
                        |found: f64, truth: f64, error: f64| (found - truth).abs() <= (0.25 * h).max(error);
                    within(run.from, from, run.range_error[0]) && within(run.to, to, run.range_error[1])
                };
                assert!(truth.iter().any(same), "{count} along {axis}: {run:?}");
            }
        }
    }
}

#[test]
fn a_sphere_is_no_extrusion_and_no_taper_however_close_the_slices() {
    for (noise, counts) in [(0.0, [8, 30, 31]), (0.1, [9, 20, 50])] {
        let cloud = scanned(&shapes::sphere(3.0), 20_000, noise);
        for count in counts {
            let (found, _) = features(&cloud, 2, count);
            for run in &found.runs {
                assert!(matches!(run.feature, Feature::Revolution { .. }), "{noise} {count}: {run:?}");
            }
        }
    }
}

#[test]
fn a_torus_is_two_revolutions_one_of_them_the_hole() {
    let cloud = scanned(&shapes::torus(3.0, 1.0), 20_000, 0.1);
    let (found, h) = features(&cloud, 2, 20);
    let mut holes: Vec<bool> = found.runs.iter().map(|r| r.hole).collect();
    holes.sort_unstable();
    assert_eq!(holes, [false, true], "{:?}", found.runs);
    for run in &found.runs {
        let Feature::Revolution { least, most } = run.feature else { panic!("{run:?}") };
        let reached = if run.hole { least - 2.0 } else { most - 4.0 };
        assert!(reached.abs() <= 0.2 * h, "{run:?}");
    }
}

#[test]
fn walls_tell_their_draft() {
    let draft = |shape: &Shape| {
        let sections = cut(&scanned(shape, 20_000, 0.1), 2, 9);
        sections.sections[4].contours[0].draft_deg.unwrap()
    };
    let cone = -0.5f64.atan().to_degrees();
    assert!((draft(&shapes::cone(1.0, 2.0)) - cone).abs() < 1.0);
    assert!(draft(&shapes::star_prism(5)).abs() < 1.0);
}

#[test]
fn the_tube_is_one_round_extrusion_as_long_as_it_is() {
    let cloud = scanned(&shapes::tube(), 20_000, 0.1);
    let (found, h) = features(&cloud, 2, 30);
    assert_eq!(found.runs.len(), 1, "{:?}", found.runs);
    near(radius(&found.runs[0]).unwrap(), 1.0, h);
    assert!((found.runs[0].from - 0.0).abs() < 0.3 * h && (found.runs[0].to - 4.0).abs() < 0.3 * h);
}

#[test]
fn the_tapered_block_is_one_taper() {
    let cloud = scanned(&shapes::tapered_block(), 30_000, 0.1);
    let (found, h) = features(&cloud, 2, 20);
    assert_eq!(found.runs.len(), 1, "{:?}", found.runs);
    assert!(
        matches!(found.runs[0].feature, Feature::Taper { radius: None, angle_deg, .. } if angle_deg < -5.0)
    );
    near(found.runs[0].from, 0.0, h);
    near(found.runs[0].to, 2.0, h);
}

#[test]
fn the_star_prism_is_one_extrusion_with_a_mirror_through_every_point() {
    let cloud = scanned(&shapes::star_prism(5), 30_000, 0.1);
    let (found, h) = features(&cloud, 2, 20);
    assert_eq!(found.runs.len(), 1, "{:?}", found.runs);
    assert_eq!(radius(&found.runs[0]), None);
    near(found.runs[0].from, 0.0, h);
    near(found.runs[0].to, 2.0, h);
    assert_eq!(found.mirrors.len(), 5, "{:?}", found.mirrors);
}
