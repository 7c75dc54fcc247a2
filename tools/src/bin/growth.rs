//! Growth of the processor time with the size of the input: `cargo run --release -p lineament-tools --bin growth -- [KIND]...`.
//!
//! Kinds of `extract`: `gauss` (noise about a point), `volume` (a filled cube) and `trees` (ground with crowns), with few lines or
//! none, by points; `lattice` (square windows in a wall, four corners each), by windows. Kinds of `section`: `plate` (round
//! holes, four slices, fitted and named), by holes. Each size is run once on one thread. The column before the last is the time over
//! n log n, n being the number of points, in nanoseconds: it stays level where the time grows like n log n.

use lineament::section::{Axis, Planes, SectionParams, section, stack};
use lineament::shapes::Rng;
use lineament::{Cloud, Params, extract};
use std::error::Error;
use std::time::Instant;

/// A kind of input.
struct Kind {
    name: &'static str,
    /// Sizes that are run.
    sizes: &'static [usize],
    /// The cloud of a size.
    cloud: fn(usize, &mut Rng) -> Vec<[f64; 3]>,
    /// The work.
    run: fn(&Cloud) -> Result<String, Box<dyn Error>>,
}

const KINDS: [Kind; 5] = [
    Kind { name: "gauss", sizes: &[10_000, 50_000, 200_000], cloud: gauss, run: lines },
    Kind { name: "volume", sizes: &[10_000, 50_000, 200_000], cloud: volume, run: lines },
    Kind { name: "trees", sizes: &[10_000, 50_000, 200_000], cloud: trees, run: lines },
    Kind { name: "lattice", sizes: &[100, 1_000, 10_000, 25_000], cloud: lattice, run: lines },
    Kind { name: "plate", sizes: &[25, 100, 400], cloud: plate, run: slices },
];

fn main() -> Result<(), Box<dyn Error>> {
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global()?;
    println!("{:8} {:>8} {:>9} {:>8} {:>11}  result", "kind", "size", "points", "s", "ns/(n ln n)");
    for kind in KINDS.iter().filter(|k| wanted.is_empty() || wanted.iter().any(|w| w == k.name)) {
        for &size in kind.sizes {
            let cloud = Cloud::new((kind.cloud)(size, &mut Rng::new(1)));
            let (before, n) = (seconds(), cloud.len() as f64);
            let result = (kind.run)(&cloud)?;
            let took = seconds() - before;
            let share = 1e9 * took / (n * n.ln());
            println!("{:8} {size:8} {:9} {took:8.2} {share:11.1}  {result}", kind.name, cloud.len());
        }
    }
    Ok(())
}

/// Processor time of this process in user mode where Linux tells it, else the time of day.
fn seconds() -> f64 {
    static START: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    let start = START.get_or_init(Instant::now);
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // The name of the program stands in parentheses; user time is the fourteenth number, in hundredths.
    let user = stat.rsplit(')').next().and_then(|rest| rest.split_whitespace().nth(11)?.parse::<f64>().ok());
    user.map_or_else(|| start.elapsed().as_secs_f64(), |ticks| 0.01 * ticks)
}

fn lines(cloud: &Cloud) -> Result<String, Box<dyn Error>> {
    let network = extract(cloud, &Params::default())?.network;
    Ok(format!("{} strips, {} nodes", network.strips.len(), network.nodes.len()))
}

fn slices(cloud: &Cloud) -> Result<String, Box<dyn Error>> {
    let params = SectionParams {
        axis: Axis::Coordinate(2),
        planes: Planes::At(vec![0.1, 0.2, 0.3, 0.4]),
        fit: true,
        ..SectionParams::default()
    };
    let sections = section(cloud, &params)?;
    let stack = stack(cloud, &sections, &params)?;
    Ok(format!("{} runs, {} mirrors", stack.runs.len(), stack.mirrors.len()))
}

fn gauss(count: usize, rng: &mut Rng) -> Vec<[f64; 3]> {
    (0..count).map(|_| [0; 3].map(|_| rng.gaussian())).collect()
}

fn volume(count: usize, rng: &mut Rng) -> Vec<[f64; 3]> {
    (0..count).map(|_| [0; 3].map(|_| rng.uniform())).collect()
}

/// Ground of one point a square unit, half of it under crowns of radius 4: balls of leaves, as many as points of the ground.
fn trees(count: usize, rng: &mut Rng) -> Vec<[f64; 3]> {
    let side = (0.5 * count as f64).sqrt();
    let crowns = (side * side / 100.0).ceil() as u64;
    let crown: Vec<[f64; 3]> = (0..crowns)
        .map(|_| [rng.between(0.0, side), rng.between(0.0, side), rng.between(7.0, 12.0)])
        .collect();
    let point = |k: usize| {
        if k.is_multiple_of(2) {
            let [x, y] = [0; 2].map(|_| rng.between(0.0, side));
            return [x, y, 2.0 * (0.05 * x).sin() + 0.05 * rng.gaussian()];
        }
        let middle = crown[rng.below(crowns) as usize];
        let leaf = loop {
            let leaf = [0; 3].map(|_| rng.between(-4.0, 4.0));
            if leaf.iter().map(|x| x * x).sum::<f64>() <= 16.0 {
                break leaf;
            }
        };
        [0, 1, 2].map(|c| middle[c] + leaf[c])
    };
    (0..count).map(point).collect()
}

/// A wall with square windows in rows and columns, each of 12 by 12 points left out of 24 by 24.
fn lattice(windows: usize, rng: &mut Rng) -> Vec<[f64; 3]> {
    let side = 24 * (windows as f64).sqrt().round() as usize;
    let wall = |k: usize| k % 24 < 6 || k % 24 >= 18;
    let cells = (0..side).flat_map(|x| (0..side).map(move |y| (x, y)));
    let solid = cells.filter(|&(x, y)| wall(x) || wall(y));
    solid.map(|(x, y)| [x as f64 + 0.2 * rng.uniform(), y as f64 + 0.2 * rng.uniform(), 0.0]).collect()
}

/// A plate of height .5 with round holes of radius .3 in rows and columns, one a unit square, 440 points on the wall of each.
fn plate(holes: usize, rng: &mut Rng) -> Vec<[f64; 3]> {
    let side = (holes as f64).sqrt().round() as usize;
    let mut points = Vec::new();
    for (x, y) in (0..side).flat_map(|x| (0..side).map(move |y| (x as f64 + 0.5, y as f64 + 0.5))) {
        for k in 0..440 {
            let angle = std::f64::consts::TAU * rng.uniform();
            points.push([x + 0.3 * angle.cos(), y + 0.3 * angle.sin(), 0.5 * rng.uniform()]);
            let [a, b] = [0; 2].map(|_| rng.between(-0.5, 0.5));
            if a * a + b * b >= 0.09 {
                points.push([x + a, y + b, if k % 2 == 0 { 0.0 } else { 0.5 }]);
            }
        }
    }
    let side = side as f64;
    for _ in 0..(4.0 * side * 230.0) as usize {
        let (along, z) = (side * rng.uniform(), 0.5 * rng.uniform());
        let wall = [[along, 0.0, z], [along, side, z], [0.0, along, z], [side, along, z]];
        points.push(wall[rng.below(4) as usize]);
    }
    points
}
