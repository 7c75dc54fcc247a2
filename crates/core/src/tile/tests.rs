//! The whole cloud against the same in tiles, bit by bit.

mod findings;
mod reach;

use super::*;
use crate::shapes::Rng;
use crate::{Class, Error, Extraction, Method, Params};

/// A flight of steps 16 wide, up and down by turns, of treads 32 long: one point for each square unit, moved by up to `noise`
/// along the normal. Treads and risers meet at multiples of 32, where plans like to cut.
fn stairs(steps: i32, noise: f64) -> Vec<[f64; 3]> {
    let mut rng = Rng::new(7);
    let mut points = Vec::new();
    for x in 0..=32 * steps {
        let (step, on) = (x / 32, x % 32 == 0 && x < 32 * steps);
        let height = 6.0 * f64::from(step % 2);
        for y in 0..=16 {
            let mut jitter = || 0.3 * (rng.uniform() - 0.5);
            let (x, y) = (f64::from(x), f64::from(y));
            let along = if on { 0.0 } else { jitter() };
            points.push([x + along, y + jitter(), height + noise * jitter()]);
            if on && step > 0 {
                points.extend((1..6).map(|z| [x + noise * jitter(), y + jitter(), f64::from(z)]));
                points.push([x, y + jitter(), 6.0 - height]);
            }
        }
    }
    points
}

fn penalty() -> Params {
    Params { method: Method::Penalty, ..Params::default() }
}

/// The plan of a cloud by tiles of at most `most` points, of which each cut leaves a share below.
fn plan(points: &[[f64; 3]], most: u64, share: f64) -> Plan {
    Plan::cut(&Histogram::of(points, 1 << 12).unwrap(), most, share)
}

/// Extracts in tiles, where the measure of every point, the network and the resolution must be those of the whole cloud.
fn same(points: &[[f64; 3]], params: &Params, plan: &Plan, whole: &Extraction) -> Tiled {
    let mut seen = 0;
    let all = &whole.measure;
    let mut tiles = Vec::new();
    let tiled = extract(&points, params, plan, |found| {
        seen += found.source.len();
        for (k, &i) in found.source.iter().enumerate() {
            let c = whole.canonical[i as usize] as usize;
            assert_eq!(whole.source.get(c), Some(&i), "point {i} is kept");
            let bits = |d: f32, s: f32, n: [f32; 3]| [d, s, n[0], n[1], n[2]].map(f32::to_bits);
            let own = bits(found.density[k], found.score[k], found.normal[k]);
            assert_eq!(own, bits(all.density[c], all.score[c], all.normal[c]), "point {i}");
        }
        for (own, all) in [(&found.crease, &all.crease), (&found.border, &all.border)] {
            for (i, row) in own {
                let c = all.points.binary_search(&whole.canonical[*i as usize]).unwrap();
                assert_eq!(format!("{row:?}"), format!("{:?}", all.row(c)), "candidate {i}");
            }
        }
        tiles.push(found);
    })
    .unwrap();
    assert_eq!((seen, tiled.points), (whole.source.len(), whole.source.len()));
    for found in &tiles {
        let of = |i: &u32| whole.class[whole.canonical[*i as usize] as usize];
        assert!(tiled.classes(found).into_iter().eq(found.source.iter().map(of)));
    }
    // The shortest decimals that give the same f64 back.
    assert_eq!(format!("{:?}", tiled.network), format!("{:?}", whole.network));
    assert_eq!(format!("{:?}", tiled.related), format!("{:?}", whole.related));
    let spacing = [tiled.resolution.spacing, tiled.resolution.noise];
    assert_eq!(spacing, [whole.report.spacing, whole.report.noise]);
    tiled
}

#[test]
fn a_network_is_that_of_the_whole_cloud_in_two_tiles_eight_and_unequal_ones() {
    let points = stairs(14, 0.6);
    let whole = crate::extract(&points, &penalty()).unwrap();
    assert!(whole.network.strips.len() > 40);
    for (most, share, tiles) in [(5000, 0.5, 2), (1300, 0.5, 8), (5000, 0.04, 16)] {
        let plan = plan(&points, most, share);
        assert_eq!(plan.tiles().len(), tiles);
        let tiled = same(&points, &penalty(), &plan, &whole);
        let most = tiled.held.iter().max().copied();
        assert!(most < Some(points.len() * 4 / 5), "{:?}", tiled.held);
    }
}

#[test]
fn edges_lie_exactly_on_seams() {
    let points = stairs(8, 0.0);
    let plan = plan(&points, 1300, 0.5);
    let on_edge = |t: &Tile| t.core.iter().any(|c| c[0] > 0.0 && c[0] % 32.0 == 0.0);
    assert!(plan.tiles().iter().filter(|t| on_edge(t)).count() >= 2, "{:?}", plan.tiles());
    same(&points, &penalty(), &plan, &crate::extract(&points, &penalty()).unwrap());
}

#[test]
fn crowds_strays_duplicates_and_lost_points_across_seams_are_those_of_the_whole_cloud() {
    let mut points = stairs(14, 0.6);
    let mut rng = Rng::new(4);
    let steps = points.len();
    let mut leaf = |at: f64, r: f64| at + r * (rng.uniform() + rng.uniform() - 1.0);
    // A crown that reaches over several tiles, and birds.
    points.extend((0..2500).map(|_| [leaf(220.0, 60.0), leaf(8.0, 8.0), leaf(24.0, 7.0)]));
    points.extend((0..12).map(|k| [leaf(30.0 * f64::from(k), 9.0), leaf(8.0, 8.0), leaf(12.0, 3.0)]));
    points.extend_from_within(100..140);
    points.push([f64::NAN, 0.0, 0.0]);
    let whole = crate::extract(&points, &penalty()).unwrap();
    let clutter = whole.classes()[steps..].iter().filter(|&&c| c == Class::Clutter).count();
    assert!(clutter > 2000, "{clutter}");
    let tiled = same(&points, &penalty(), &plan(&points, 1500, 0.5), &whole);
    assert!(tiled.held.iter().all(|&held| held < points.len() * 4 / 5), "{:?}", tiled.held);
}

#[test]
fn strays_far_out_do_not_widen_a_tile_to_the_whole_cloud() {
    let mut points = stairs(14, 0.6);
    // One opposite a straight edge, so that a plane holds it with its neighbours; two near each other.
    points.extend([[300.0, 2e5, 0.0], [120.0, 8.0, 900.0], [-4000.0, 0.0, 90.0], [-4000.0, 0.5, 91.0]]);
    let whole = crate::extract(&points, &penalty()).unwrap();
    let tiled = same(&points, &penalty(), &plan(&points, 2500, 0.5), &whole);
    assert!(tiled.held.iter().all(|&held| held < points.len() * 4 / 5), "{:?}", tiled.held);
}

/// The finding of `docs/scale.md`: each place that is thinned keeps the first of its points, and which is first depends on the one before.
#[test]
fn thinned_rows_are_those_of_the_whole_cloud_though_a_tile_needs_all_of_it() {
    let at = |k: i32| [f64::from(k % 260) + 0.03 * f64::from(k * 37 % 11), 7.0 * f64::from(k / 260), 0.0];
    let points: Vec<[f64; 3]> = (0..260 * 12).map(at).collect();
    let whole = crate::extract(&points, &penalty()).unwrap();
    assert!(whole.report.surface.thinned > 1000, "{:?}", whole.report.surface);
    let tiled = same(&points, &penalty(), &plan(&points, 1600, 0.5), &whole);
    assert!(tiled.held.contains(&points.len()), "{:?}", tiled.held);
}

#[test]
fn a_cloud_without_surface_has_no_network_and_too_few_points_are_refused() {
    let mut rng = Rng::new(2);
    let fog: Vec<[f64; 3]> = (0..3000).map(|_| [0; 3].map(|_: i32| rng.uniform())).collect();
    let whole = crate::extract(&fog, &penalty()).unwrap();
    assert!(whole.report.surface.none);
    let tiled = extract(&fog, &penalty(), &plan(&fog, 800, 0.5), |_| ()).unwrap();
    assert!(tiled.network.strips.is_empty());
    let few = [[0.0; 3], [1.0; 3], [1.0; 3]];
    let refused = extract(&few, &penalty(), &plan(&few, 1, 0.5), |_| ());
    assert_eq!(refused.unwrap_err(), Error::TooFewPoints { read: 3, distinct: 2, needed: 4 });
}

#[test]
fn what_does_not_run_over_tiles_is_refused_by_name() {
    let points = stairs(1, 0.0);
    for (key, value) in [("method", "projection"), ("recover.wedge", "quadric"), ("penalty.form", "paper")] {
        let mut params = penalty();
        params.set(key, value).unwrap();
        let message = extract(&points, &params, &plan(&points, 500, 0.5), |_| ()).unwrap_err().to_string();
        assert!(message.contains(key) && message.contains(value), "{message}");
    }
}
