//! The tables of Tran 2013 on generated shapes, and what noise does:
//! `cargo bench -p lineament --bench projection -- [NOISE.svg]`.
//!
//! Tables 1 to 3 are the paper's; its fandisk and trim-star are replaced by brackets whose grid has as many points. Noise
//! goes from the paper's 1, 2 and 3 % of the spacing on to 50 %. Truth are the points that lie within one spacing of an edge
//! without noise, and for the paper's one cut (`projection.classes=2`) those on it.

mod plot;

use std::time::Instant;

use lineament::detect::baselines::{Detector, marks};
use lineament::detect::projection::scales::{SCALES, at_every_scale};
use lineament::detect::projection::{NOISE_LIMIT, project};
use lineament::neighbors::all_nearest;
use lineament::neighbors::riemannian::graph;
use lineament::params::ProjectionParams;
use lineament::shapes::{Sampled, Sampling, Scan, bracket, cube_386};
use lineament::{Frame, Localised, Params, Resolution};

/// Points nearer to an edge than this share of the spacing lie on it.
const ON_EDGE: f64 = 0.25;
/// Points nearer than this lie at it.
const AT_EDGE: f64 = 1.0;
/// Noise over spacing.
const NOISES: [f64; 12] = [0.0, 0.01, 0.02, 0.03, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5];

fn main() {
    table_1();
    table_2();
    table_3();
    let curves = noise();
    if let Some(path) = std::env::args().skip(1).find(|a| !a.starts_with("--")) {
        std::fs::write(&path, plot::svg(&curves, NOISE_LIMIT)).expect("the plot can be written");
        println!("wrote {path}");
    }
}

/// A sampled shape as a detector sees it.
struct Scene {
    local: Localised,
    resolution: Resolution,
    /// Distances from the nearest edge in spacings, in canonical order.
    distances: Vec<f64>,
}

impl Scene {
    fn new(sampled: &Sampled) -> Scene {
        let local = Frame::localise(&sampled.cloud).expect("the shape has a surface");
        let nearest = all_nearest(&local.positions, Params::default().neighbors.k);
        let resolution = Resolution::estimate(&local.positions, &nearest, &graph(&local.positions, &nearest));
        let world = sampled.distances();
        let distances = local.source.iter().map(|&i| world[i as usize] / sampled.spacing).collect();
        Scene { local, resolution, distances }
    }

    /// F1 of a detector's marks against the points nearer than `reach` spacings to an edge.
    fn f1(&self, detector: Detector, params: &ProjectionParams, reach: f64) -> f64 {
        let marks = marks(&self.local.positions, self.resolution, params, detector);
        let truth = self.distances.iter().filter(|d| **d < reach).count();
        let hits = (0..self.distances.len()).filter(|&i| self.distances[i] < reach && marks.is_marked(i));
        2.0 * hits.count() as f64 / (truth + marks.count()).max(1) as f64
    }
}

/// A bracket on a grid of about `count` points.
fn bracket_of(count: usize, noise: f64) -> Sampled {
    let shape = bracket();
    let step = (shape.area() / count as f64).sqrt();
    shape.sample(&Scan::new(Sampling::Grid { step }).noise(noise).seed(1))
}

fn table_1() {
    println!(
        "\nTable 1: projected distance in spacings at a smooth, a near-sharp and a sharp point of a bracket"
    );
    let scene = Scene::new(&bracket_of(6475, 0.0));
    let rows = at_every_scale(&scene.local.positions, |_, _, scales| scales.map(|s| s.distance));
    // The last of its kind in canonical order lies away from the bore, where no face is plane.
    let last = |from: f64, to: f64| scene.distances.iter().rposition(|d| (from..to).contains(d));
    let points = [last(5.0, 9.0), last(1.2, 1.6), last(0.0, 0.01)].map(|i| i.expect("there is such a point"));
    println!("| k | smooth | near-sharp | sharp |\n|---|---|---|---|");
    for (k, size) in SCALES.iter().enumerate() {
        let cells = points.map(|i| format!("{:.3e}", rows[i][k] / scene.resolution.spacing));
        println!("| {size} | {} |", cells.join(" | "));
    }
    let chosen = project(&scene.local.positions, scene.resolution, &Params::default().projection).scale;
    println!("| chosen | {} |", points.map(|i| chosen[i].to_string()).join(" | "));
}

fn table_2() {
    println!("\nTable 2: points marked on the cube of 386, 92 of them on edges");
    println!("| detector | marked | on edges |\n|---|---|---|");
    let scene = Scene::new(&cube_386());
    for detector in Detector::ALL {
        let marks = marks(&scene.local.positions, scene.resolution, &Params::default().projection, detector);
        let right = (0..386).filter(|&i| marks.is_marked(i) && scene.distances[i] < ON_EDGE).count();
        println!("| {} | {} | {right} |", detector.name(), marks.count());
    }
}

/// Times alternate between the search alone and the whole, and the best of each counts.
fn table_3() {
    println!("\nTable 3: times on one thread, ms, best of 15, search and whole in turn");
    println!("| points | search, k = 32 | whole method | ratio |\n|---|---|---|---|");
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    for sampled in [cube_386(), bracket_of(5192, 0.0), bracket_of(6475, 0.0), bracket_of(50_000, 0.0)] {
        let scene = Scene::new(&sampled);
        let points = &scene.local.positions;
        let mut best = [f64::INFINITY; 2];
        for _ in 0..15 {
            let start = Instant::now();
            std::hint::black_box(one.install(|| all_nearest(points, 32)));
            let search = start.elapsed().as_secs_f64() * 1e3;
            let start = Instant::now();
            std::hint::black_box(
                one.install(|| project(points, scene.resolution, &Params::default().projection)),
            );
            let whole = start.elapsed().as_secs_f64() * 1e3;
            best = [best[0].min(search), best[1].min(whole)];
        }
        println!("| {} | {:.2} | {:.2} | {:.2} |", points.len(), best[0], best[1], best[1] / best[0]);
    }
}

/// F1 of every detector over the noise, and of the projected distance with one cut: a curve each.
fn noise() -> Vec<plot::Curve> {
    println!(
        "\nNoise: F1 of the marks within one spacing of an edge, last column on it; bracket of about 6475 points"
    );
    let three = Params::default().projection;
    let two = ProjectionParams { classes: 2, ..three.clone() };
    let own = Detector::ALL.map(|d| (d.name(), d, &three, AT_EDGE));
    let all: Vec<_> =
        own.into_iter().chain([("on the edge".into(), Detector::Projection, &two, ON_EDGE)]).collect();
    let mut curves: Vec<plot::Curve> =
        all.iter().map(|(name, ..)| plot::Curve { name: name.clone(), points: Vec::new() }).collect();
    let names: Vec<&str> = all.iter().map(|(name, ..)| name.as_str()).collect();
    println!("| noise, spacings | estimated | {} |", names.join(" | "));
    println!("|{}", "---|".repeat(all.len() + 2));
    for noise in NOISES {
        let scene = Scene::new(&bracket_of(6475, noise));
        let scores: Vec<f64> = all.iter().map(|(_, d, params, reach)| scene.f1(*d, params, *reach)).collect();
        let cells: Vec<String> = scores.iter().map(|f| format!("{f:.3}")).collect();
        let estimate = scene.resolution.noise / scene.resolution.spacing;
        println!("| {noise} | {estimate:.3} | {} |", cells.join(" | "));
        curves.iter_mut().zip(scores).for_each(|(curve, score)| curve.points.push([noise, score]));
    }
    curves
}
