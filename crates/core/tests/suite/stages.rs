//! The steps that an extraction keeps are those of the run that was asked for.

use lineament::detect::projection::scales::SCALES;
use lineament::params::{PenaltyForm, WedgeForm};
use lineament::shapes::{Sampled, Sampling, Scan, cuboid};
use lineament::{Extraction, LineGraph, Method, Params, extract, extract_staged};

fn scan() -> Sampled {
    cuboid([3.0, 2.0, 1.0]).sample(&Scan::new(Sampling::BlueNoise { count: 4000 }).noise(0.1).seed(1))
}

/// The staged extraction, the same as the plain one but for its stages.
fn staged(scan: &Sampled, params: &Params) -> Extraction {
    let found = extract_staged(&scan.cloud, &[], params, &|_| ()).unwrap();
    let plain = extract(&scan.cloud, params).unwrap();
    assert!(plain.stages.is_none());
    assert_eq!((&plain.network, &plain.pattern), (&found.network, &found.pattern));
    found
}

fn edges(lines: &LineGraph) -> Vec<[u32; 2]> {
    let of = |v: usize| lines.edges[v].iter().map(move |&w| [v as u32, w]);
    (0..lines.edges.len()).flat_map(of).filter(|[v, w]| v < w).collect()
}

#[test]
fn as_printed_each_graph_is_a_part_of_the_one_before_and_the_last_is_the_pattern() {
    let mut params = Params { method: Method::Penalty, ..Params::default() };
    params.penalty.form = PenaltyForm::Paper;
    let found = staged(&scan(), &params);
    let stages = found.stages.unwrap();
    assert_eq!((stages.lines.len(), stages.repaired, stages.recovery), (2, false, None));
    for steps in &stages.lines {
        assert_eq!(&steps.pruned, found.pattern.of(steps.kind));
        let [all, spanning, pruned] =
            [steps.edges.iter().map(|e| e.ends).collect(), edges(&steps.spanning), edges(&steps.pruned)]
                .map(|edges: Vec<[u32; 2]>| edges.into_iter().collect::<std::collections::BTreeSet<_>>());
        assert!(all.is_superset(&spanning) && spanning.is_superset(&pruned));
        assert!(all.len() > spanning.len() && spanning.len() > pruned.len(), "{:?}", steps.kind);
        assert!(steps.edges.is_sorted_by(|a, b| a.weight <= b.weight));
        // The length is the rest of the weight; the share stays below tau.
        assert!(steps.edges.iter().all(|e| (0.0..1.0).contains(&e.penalty) && e.weight > e.penalty));
    }
    // On a face the least axis of the ellipsoid is its normal, and the centre lies in it.
    assert_eq!(stages.ellipsoids.len(), found.source.len());
    let flat = stages.ellipsoids.iter().filter(|e| e.axes.values[0] < 0.02 * e.axes.values[1]).count();
    assert!(flat > 2000, "{flat}");
}

#[test]
fn recovered_places_lie_on_the_edges_and_groups_on_their_faces() {
    let scan = scan();
    let mut params = Params { method: Method::Penalty, ..Params::default() };
    params.recover.wedge = WedgeForm::Paper;
    let found = staged(&scan, &params);
    let recovery = found.stages.unwrap().recovery.unwrap();
    let truth = scan.truth.index(0.01 * scan.spacing);
    let off = |p: &lineament::RecoveredPlace| truth.distance(found.frame.to_world(p.at)) / scan.spacing;
    let far = recovery.places.iter().map(off).fold(0.0, f64::max);
    assert!(far < 0.3, "{far}");
    assert_eq!(recovery.places.iter().filter(|p| p.node.is_some()).count(), 8);
    let mut folds: Vec<f64> = recovery.places.iter().filter_map(|p| p.fold_deg).collect();
    folds.sort_by(f64::total_cmp);
    let median = folds[folds.len() / 2];
    assert!((median - 90.0).abs() < 3.0, "{median}");
    // The points of one group share a coordinate.
    let mut right = 0;
    for group in recovery.beside.chunk_by(|a, b| a.of == b.of) {
        for face in 0..2 {
            let of = group.iter().filter(|g| g.face == face);
            let at = |g: &lineament::Grouped| scan.cloud.positions[found.source[g.point as usize] as usize];
            let points: Vec<[f64; 3]> = of.map(at).collect();
            right += (0..3).map(|axis| most_alike(&points, axis, 0.5 * scan.spacing)).max().unwrap();
        }
    }
    assert!(right as f64 > 0.95 * recovery.beside.len() as f64, "{right} of {}", recovery.beside.len());
    assert!(recovery.around.iter().all(|g| g.face < 3));
}

/// The number of points that lie in one plane across an axis, within `width` of the median.
fn most_alike(points: &[[f64; 3]], axis: usize, width: f64) -> usize {
    let mut along: Vec<f64> = points.iter().map(|p| p[axis]).collect();
    along.sort_by(f64::total_cmp);
    let middle = along.get(along.len() / 2).copied().unwrap_or_default();
    along.iter().filter(|x| (*x - middle).abs() < width).count()
}

#[test]
fn the_score_of_the_method_projection_is_the_distance_at_the_best_scale_over_its_radius() {
    let scan = scan();
    let params = Params { method: Method::Projection, ..Params::default() };
    let found = staged(&scan, &params);
    let steps = found.stages.unwrap().projection.unwrap();
    for (i, (distance, radius)) in steps.distances.iter().zip(&steps.radii).enumerate() {
        let k = SCALES.iter().position(|&s| s == usize::from(steps.projection.scale[i])).unwrap();
        let value = f64::from(distance[k] / radius[k]) / steps.projection.marks.greatest;
        assert!((value - f64::from(found.measure.score[i])).abs() < 1e-5);
    }
    assert_eq!(steps.histogram.iter().sum::<u64>() as usize, found.source.len());
}
