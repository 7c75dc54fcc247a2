//! Times of the neighbour search: `cargo bench --bench knn -- [CLOUD.f32] [K]`.
//!
//! The cloud is a raw file of little-endian f32 triples; without one, a million points at random on the surface of
//! a cube are taken, in random order.

use std::time::Instant;

use lineament::neighbors::{Instructions, all_nearest_with, riemannian};
use lineament::{Cloud, Frame};

/// Rounds of which the best time counts.
const ROUNDS: usize = 5;

fn main() {
    let args: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let cloud = Cloud::new(args.first().map_or_else(|| cube(1_000_000), |path| read(path)));
    let k: usize = args.get(1).and_then(|k| k.parse().ok()).unwrap_or(16);
    let all = std::thread::available_parallelism().map_or(1, usize::from);
    println!("{} points, k = {k}, best of {ROUNDS}", cloud.len());
    println!("threads instructions   localise ms  nearest ms   graph ms   localise + nearest, ns a point");
    let choices = [Instructions::Detected, Instructions::Narrow, Instructions::Baseline];
    let mut best = [[[f64::INFINITY; 3]; 3]; 2];
    for _ in 0..ROUNDS {
        for (t, threads) in [1, all].into_iter().enumerate() {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            for (c, instructions) in choices.into_iter().enumerate() {
                let times = pool.install(|| measure(&cloud, k, instructions));
                (0..3).for_each(|i| best[t][c][i] = times[i].min(best[t][c][i]));
            }
        }
    }
    for (t, threads) in [1, all].into_iter().enumerate() {
        for (c, instructions) in choices.into_iter().enumerate() {
            let [localise, nearest, graph] = best[t][c];
            let point = (localise + nearest) * 1e6 / cloud.len() as f64;
            let name = format!("{instructions:?}");
            println!("{threads:7} {name:13} {localise:12.1} {nearest:11.1} {graph:10.1} {point:14.0}");
        }
    }
}

/// Milliseconds of the stages.
fn measure(cloud: &Cloud, k: usize, instructions: Instructions) -> [f64; 3] {
    let start = Instant::now();
    let lap = || start.elapsed().as_secs_f64() * 1e3;
    let local = Frame::localise(cloud).unwrap();
    let localise = lap();
    let lists = all_nearest_with(&local.positions, k, instructions);
    let nearest = lap();
    let graph = riemannian::graph(&local.positions, &lists);
    let end = lap();
    std::hint::black_box(graph);
    [localise, nearest - localise, end - nearest]
}

fn read(path: &str) -> Vec<[f64; 3]> {
    let bytes = std::fs::read(path).expect("the cloud can be read");
    let value = |b: &[u8]| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]]));
    bytes.chunks_exact(12).map(|p| [value(&p[..4]), value(&p[4..8]), value(&p[8..])]).collect()
}

fn cube(n: usize) -> Vec<[f64; 3]> {
    let mut state = 1u64;
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let point = |_| {
        let face = (next() * 6.0) as usize;
        let mut p = [next(), next(), next()];
        p[face % 3] = (face / 3) as f64;
        p
    };
    (0..n).map(point).collect()
}
