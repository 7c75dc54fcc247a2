//! Parts of many kinds are named as what they are: `examples/naming_table.rs` tells more of each.

#[path = "naming/judge.rs"]
mod judge;
#[path = "naming/parts.rs"]
mod parts;

use judge::{Verdict, judge};
use lineament::section::{Axis, Planes, SectionParams, section_observed};
use lineament::shapes::{Sampling, Scan};

/// All parts along all their axes, at one noise and number of slices.
fn verdicts(noise: f64, count: usize) -> Vec<(String, Verdict)> {
    let mut found = Vec::new();
    for part in parts::parts() {
        let scan = Scan::new(Sampling::BlueNoise { count: part.count }).noise(noise).seed(1);
        let cloud = part.shape.sample(&scan).cloud;
        for view in &part.views {
            let params = SectionParams {
                axis: Axis::Coordinate(view.axis),
                planes: Planes::Count(count),
                fit: true,
                ..SectionParams::default()
            };
            let (sections, stack) = section_observed(&cloud, &params, &|_| ()).unwrap();
            assert!(stack.repeats.len() >= view.repeats, "{}", part.shape.name);
            let verdict = judge(&view.features, 0.0, &sections, &stack);
            found.push((format!("{} along {}", part.shape.name, ["x", "y", "z"][view.axis]), verdict));
        }
    }
    found
}

#[test]
fn every_feature_is_named_and_nothing_else() {
    let verdicts = verdicts(0.1, 37);
    for (view, verdict) in &verdicts {
        assert!(verdict.missing.is_empty(), "{view}: {:?} missing", verdict.missing);
        assert!(verdict.extra.is_empty(), "{view}: {:?} are not there", verdict.extra);
        for off in &verdict.sizes {
            assert!(off.error.abs() <= 0.25, "{view}: {} spacings off: {}", off.error, off.text);
        }
    }
    // What is left: ends at a cut rim or a tangent bore, and folds of chamfers.
    let ends: Vec<f64> = verdicts.iter().flat_map(|v| &v.1.ends).map(|e| e.error.abs()).collect();
    let within = ends.iter().filter(|e| **e <= 0.1).count();
    assert!(ends.len() > 150 && within * 100 >= ends.len() * 90, "{within} of {}", ends.len());
}
