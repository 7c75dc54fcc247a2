//! Runs that show the same outline at several places.

use super::result::{Feature, Repeat, Run};
use super::runs::Found;

/// Groups of runs with the same outline, laid over each other by their centroids.
pub(super) fn repeats(runs: &[Found], tolerance: f64) -> Vec<Repeat> {
    let mut grouped = vec![false; runs.len()];
    let mut found = Vec::new();
    for i in 0..runs.len() {
        if grouped[i] {
            continue;
        }
        let mut repeat = Repeat { runs: vec![i], residual: 0.0 };
        for j in i + 1..runs.len() {
            if let Some(off) = same(&runs[i], &runs[j], tolerance).filter(|_| !grouped[j]) {
                grouped[j] = true;
                repeat.runs.push(j);
                repeat.residual = repeat.residual.max(off);
            }
        }
        if repeat.runs.len() > 1 {
            found.push(repeat);
        }
    }
    found
}

fn same(a: &Found, b: &Found, tolerance: f64) -> Option<f64> {
    let extruded = |r: &Run| matches!(r.feature, Feature::Extrusion { .. });
    let alike = a.run.hole == b.run.hole && extruded(&a.run) && extruded(&b.run);
    let size = (a.middle().area.sqrt() - b.middle().area.sqrt()).abs();
    if !alike || size > 4.0 * tolerance {
        return None;
    }
    let off = a.middle().apart(b.middle(), a.middle().onto(b.middle()));
    off.same(tolerance).then_some(off.mean)
}
