//! Parts of many kinds are named as what they are. Some of the parts, to keep the tests short: `naming_table` in `tools/` takes all,
//! with several seeds, noises and numbers of slices.

#[path = "naming/judge.rs"]
mod judge;
#[path = "naming/parts.rs"]
mod parts;

use judge::{Verdict, judge};
use lineament::Cloud;
use lineament::section::{Axis, Planes, SectionParams, Sections, Stack, section_observed};
use lineament::shapes::{Sampling, Scan};
use parts::Part;

/// All of some parts along all their axes, at one noise and number of slices.
fn verdicts(parts: Vec<Part>, noise: f64, count: usize) -> Vec<(String, Verdict)> {
    let mut found = Vec::new();
    for part in parts {
        let scan = Scan::new(Sampling::BlueNoise { count: part.count }).noise(noise).seed(1);
        let cloud = part.shape.sample(&scan).cloud;
        for view in &part.views {
            let (sections, stack) = cut(&cloud, Axis::Coordinate(view.axis), count);
            assert!(stack.repeats.len() >= view.repeats, "{}", part.shape.name);
            let verdict = judge(&view.features, 0.0, &sections, &stack);
            found.push((format!("{} along {}", part.shape.name, ["x", "y", "z"][view.axis]), verdict));
        }
    }
    found
}

fn cut(cloud: &Cloud, axis: Axis, count: usize) -> (Sections, Stack) {
    let params = SectionParams { axis, planes: Planes::Count(count), fit: true, ..SectionParams::default() };
    section_observed(cloud, &params, &|_| ()).unwrap()
}

#[test]
fn every_feature_is_named_and_nothing_else() {
    let verdicts = verdicts(parts::parts().into_iter().step_by(3).collect(), 0.1, 37);
    for (view, verdict) in &verdicts {
        assert!(verdict.missing.is_empty(), "{view}: {:?} missing", verdict.missing);
        assert!(verdict.extra.is_empty(), "{view}: {:?} are not there", verdict.extra);
        for off in &verdict.sizes {
            assert!(off.error.abs() <= 0.25, "{view}: {} spacings off: {}", off.error, off.text);
        }
    }
    // What is left: borders, folds and crests under noise.
    let ends: Vec<_> = verdicts.iter().flat_map(|v| &v.1.ends).collect();
    let within = ends.iter().filter(|e| e.error.abs() <= 0.1).count();
    let stated = ends.iter().filter(|e| e.error.abs() <= 2.0 * e.stated).count();
    assert!(ends.len() > 50 && within * 100 >= ends.len() * 95, "{within} of {}", ends.len());
    assert!(stated * 100 >= ends.len() * 85, "{stated} of {} within what is stated", ends.len());
}

#[test]
fn plain_parts_are_measured_to_a_tenth_of_a_spacing() {
    let plain = ["bracket", "stepped shaft", "tube", "tapered block", "star prism"];
    for (name, count) in plain.into_iter().zip([23, 50].into_iter().cycle()) {
        let part = parts::parts().into_iter().find(|p| p.shape.name.starts_with(name)).unwrap();
        for (view, verdict) in verdicts(vec![part], 0.0, count) {
            assert!(verdict.missing.is_empty() && verdict.extra.is_empty(), "{view}: {verdict:?}");
            for off in verdict.ends.iter().chain(&verdict.sizes) {
                assert!(off.error.abs() <= 0.1, "{view}: {} spacings off: {}", off.error, off.text);
            }
        }
    }
}

#[test]
fn a_chamfer_with_a_slice_beside_its_fold_is_named() {
    for part in parts::parts().into_iter().filter(|p| p.shape.name == "stepped shaft") {
        // The chamfer has two slices, the lower one .7 spacings from its fold.
        let scan = Scan::new(Sampling::BlueNoise { count: part.count }).noise(0.1).seed(3);
        let (sections, stack) = cut(&part.shape.sample(&scan).cloud, Axis::Coordinate(2), 37);
        let verdict = judge(&part.views[0].features, 0.0, &sections, &stack);
        assert_eq!(verdict.named, part.views[0].features.len(), "{:?} missing", verdict.missing);
        assert!(verdict.extra.is_empty(), "{:?} are not there", verdict.extra);
    }
}

#[test]
fn parts_kept_out_are_named_too() {
    // The wedges beside a dovetail's groove want more slices than two.
    let newest = verdicts(parts::newest().into_iter().step_by(3).collect(), 0.0, 81);
    let older = verdicts(parts::held_out().into_iter().step_by(3).collect(), 0.0, 37);
    for (view, verdict) in older.into_iter().chain(newest) {
        assert!(verdict.missing.is_empty(), "{view}: {:?} missing", verdict.missing);
        assert!(verdict.extra.is_empty(), "{view}: {:?} are not there", verdict.extra);
    }
}

#[test]
fn a_part_cut_against_its_axis_shows_the_same_features() {
    for part in parts::held_out().into_iter().filter(|p| p.shape.name == "tapered hub") {
        let cloud = part.shape.sample(&Scan::new(Sampling::BlueNoise { count: part.count }).seed(1)).cloud;
        let (sections, stack) = cut(&cloud, Axis::Vector([0.0, 0.0, -1.0]), 37);
        let features: Vec<_> = part.views[0].features.iter().map(|k| k.along(-1.0)).collect();
        let verdict = judge(&features, 0.0, &sections, &stack);
        assert_eq!((verdict.named, verdict.missing.len(), verdict.extra.len()), (features.len(), 0, 0));
        assert!(verdict.sizes.iter().all(|s| s.error.abs() < 0.1), "{:?}", verdict.sizes);
    }
}
