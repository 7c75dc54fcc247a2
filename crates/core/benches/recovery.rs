//! Recovery of creases and corners (Gumhold 2001, sections 4.1 and 4.2) over many seeds:
//! `cargo bench -p lineament --bench recovery -- [cube | shapes | coverage]`, all without an argument.
//!
//! `cube`: the paper's random cube against the box through the truth's faces, before recovery and after it in both forms. `shapes`:
//! boxes, wedges and a bracket under noise, the mean distance of creases from the truth beside .15 of the noise plus .02 spacings.
//! `coverage`: how many of the 95 % intervals of recovered crease points and corners hold the truth.

use lineament::params::{Method, WedgeForm};
use lineament::shapes::{Sampled, Sampling, Scan, Shape, bracket, cuboid, random_cube, wedge};
use lineament::{Network, NodeKind, Params, Strip, StripKind, evaluate, extract};

const FORMS: [(&str, WedgeForm); 3] =
    [("none", WedgeForm::None), ("paper", WedgeForm::Paper), ("quadric", WedgeForm::Quadric)];

fn main() {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let runs: [(&str, fn()); 3] = [("cube", cube), ("shapes", shapes), ("coverage", coverage)];
    for (name, run) in runs {
        if wanted.is_empty() || wanted.iter().any(|w| w == name) {
            run();
        }
    }
}

fn network(scan: &Sampled, form: WedgeForm) -> Network {
    let mut params = Params { method: Method::Penalty, ..Params::default() };
    params.recover.wedge = form;
    extract(&scan.cloud, &params).expect("the shape has a surface").network
}

fn creases(network: &Network) -> impl Iterator<Item = &Strip> {
    network.strips.iter().filter(|s| s.kind == StripKind::Crease)
}

/// Distance from the nearest edge, and from the nearest corner, of the cube of edge 1.8.
fn off_cube(p: [f64; 3]) -> [f64; 2] {
    let mut off = p.map(|x| (x.abs() - 0.9).abs());
    let corner = off.iter().map(|x| x * x).sum::<f64>().sqrt();
    off.sort_by(f64::total_cmp);
    [off[0].hypot(off[1]), corner]
}

fn cube() {
    println!(
        "random cube, 20 seeds: 12 creases and 8 corners; greatest distances of crease points and corners"
    );
    for (name, form) in FORMS {
        let (mut whole, mut close) = (0, 0);
        let (mut edges, mut corners) = (Vec::new(), Vec::new());
        for seed in 1..=20 {
            let scan = random_cube(seed, 10_000);
            let network = network(&scan, form);
            if !evaluate::isomorphic(&network, &scan.truth) {
                continue;
            }
            let edge = creases(&network).flat_map(|s| &s.points).map(|&p| off_cube(p)[0]).fold(0.0, f64::max);
            let corner = network.nodes.iter().map(|n| off_cube(n.position)[1]).fold(0.0, f64::max);
            whole += 1;
            close += usize::from(edge <= 0.02 && corner <= 0.03);
            edges.push(edge);
            corners.push(corner);
        }
        let median = |v: &mut Vec<f64>| {
            v.sort_by(f64::total_cmp);
            v.get(v.len() / 2).copied().unwrap_or(f64::NAN)
        };
        let (edge, corner) = (median(&mut edges), median(&mut corners));
        println!("{name:8} whole {whole}, within .02 and .03 {close}; median {edge:.4} and {corner:.4}");
    }
}

fn shapes() {
    println!("mean distance of crease points from the truth, spacings; the bound in brackets");
    let mut all: Vec<(String, Shape)> =
        vec![("box".into(), cuboid([3.0, 2.0, 1.0])), ("bracket".into(), bracket())];
    all.extend([20.0, 40.0, 60.0, 90.0, 120.0, 160.0].map(|f| (format!("wedge {f}"), wedge(f))));
    for (name, shape) in &all {
        for noise in [0.1, 0.25, 0.5] {
            let scan = shape.sample(&Scan::new(Sampling::BlueNoise { count: 20_000 }).noise(noise).seed(1));
            let truth = scan.truth.index(0.01 * scan.spacing);
            let row = FORMS.map(|(_, form)| {
                let network = network(&scan, form);
                let off: Vec<f64> = creases(&network)
                    .flat_map(|s| &s.points)
                    .map(|&p| truth.distance(p) / scan.spacing)
                    .collect();
                off.iter().sum::<f64>() / off.len() as f64
            });
            let [none, paper, ours] = row;
            println!("{name:10} {noise:4}  {none:.3} {paper:.3} {ours:.3}  [{:.3}]", 0.15 * noise + 0.02);
        }
    }
}

fn coverage() {
    println!("95 % intervals that hold the truth, on each axis across the crease");
    for noise in [0.1, 0.25, 0.5] {
        let (mut points, mut nodes) = ([0usize; 2], [0usize; 2]);
        for seed in 0..40 {
            let shape = cuboid([3.0, 2.0, 1.0]);
            let scan = shape.sample(&Scan::new(Sampling::BlueNoise { count: 6000 }).noise(noise).seed(seed));
            let network = network(&scan, WedgeForm::Quadric);
            let half = [1.5, 1.0, 0.5];
            let count =
                |to: &mut [usize; 2], p: [f64; 3], sigma: [f64; 3], axes: &mut dyn Iterator<Item = usize>| {
                    for k in axes {
                        to[0] += usize::from((p[k].abs() - half[k]).abs() <= 1.96 * sigma[k]);
                        to[1] += 1;
                    }
                };
            for strip in creases(&network).filter(|s| !s.sigma.is_empty()) {
                // One point for a window: neighbours err alike.
                let middle = strip.points.len() / 2;
                let ends = [strip.points[0], strip.points[strip.points.len() - 1]];
                let along = (0..3).max_by(|&a, &b| {
                    (ends[1][a] - ends[0][a]).abs().total_cmp(&(ends[1][b] - ends[0][b]).abs())
                });
                let mut across = (0..3).filter(|&k| Some(k) != along);
                count(&mut points, strip.points[middle], strip.sigma[middle], &mut across);
            }
            for node in network.nodes.iter().filter(|n| n.kind == NodeKind::Junction) {
                if let Some(sigma) = node.sigma {
                    count(&mut nodes, node.position, sigma, &mut (0..3));
                }
            }
        }
        let share = |[held, all]: [usize; 2]| 100.0 * held as f64 / all.max(1) as f64;
        println!(
            "noise {noise}: crease points {:.1} % of {}, corners {:.1} % of {}",
            share(points),
            points[1],
            share(nodes),
            nodes[1]
        );
    }
}
