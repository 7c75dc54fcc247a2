//! Relations and their imposition on parts with noise, over many seeds: `cargo bench -p lineament --bench relations -- [SEEDS [COUNT]]`.
//!
//! For each part and noise: relations found of each kind; the greatest error of the imposed ones; mean and greatest distance of the
//! typed curves from the truth, in spacings, as found and with the relations imposed; the greatest move; seconds of both.

mod judge;

use judge::{Exactness, distances, exactness};
use lineament::shapes::{Sampling, Scan, Shape, bracket, keyed_shaft, ribbed_bracket, stepped_shaft};
use lineament::{Params, RelationKind, extract};

fn main() {
    let numbers: Vec<usize> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    let (seeds, count) = (numbers.first().copied().unwrap_or(10), numbers.get(1).copied().unwrap_or(20_000));
    println!(
        "part noise: relations by kind; mean distance, greatest, as found | imposed; better on; parallel, perpendicular, radii; move"
    );
    for shape in [bracket(), ribbed_bracket(), stepped_shaft(), keyed_shaft()] {
        for noise in [0.0, 0.1, 0.25] {
            row(&shape, noise, seeds as u64, count);
        }
    }
}

fn row(shape: &Shape, noise: f64, seeds: u64, count: usize) {
    let mut kinds = [0.0; 8];
    let mut off = [[0.0; 2]; 2];
    let (mut worst, mut better, mut moved, mut released) = (Exactness::default(), 0, 0.0_f64, 0);
    for seed in 1..=seeds {
        let scan = shape.sample(&Scan::new(Sampling::BlueNoise { count }).noise(noise).seed(seed));
        let truth = scan.truth.index(0.01 * scan.spacing);
        let mut params = Params::default();
        let found = extract(&scan.cloud, &params).expect("the part has a surface");
        params.relations.regularise = true;
        let regular = extract(&scan.cloud, &params).expect("the part has a surface");
        for (k, kind) in RelationKind::ALL.into_iter().enumerate() {
            kinds[k] += regular.related.count(kind) as f64 / seeds as f64;
        }
        let both = [&found, &regular].map(|e| distances(&e.network, &truth, scan.spacing));
        for (sum, d) in off.iter_mut().zip(both) {
            *sum = [sum[0] + d[0] / seeds as f64, sum[1].max(d[1])];
        }
        better += u32::from(both[1][0] < both[0][0]);
        worst = worst.max(exactness(&regular.network, &regular.related.relations));
        let what = regular.related.regularised.as_ref().expect("it was asked for");
        moved = moved.max(what.greatest() / scan.spacing);
        released += what.released.len();
    }
    let kinds: Vec<String> = kinds.iter().map(|k| format!("{k:.1}")).collect();
    let Exactness { parallel, perpendicular, radii } = worst;
    println!(
        "{:14} {noise:4}: {}; {:.4} {:.3} | {:.4} {:.3}; {better}; {parallel:.0e} {perpendicular:.0e} {radii:.0e}; {moved:.2} h, {released} released",
        shape.name,
        kinds.join(" "),
        off[0][0],
        off[0][1],
        off[1][0],
        off[1][1],
    );
}
