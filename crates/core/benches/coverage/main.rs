//! How often intervals of 95 % by the standard deviations of typed curves hold the truth: `cargo bench --bench coverage -- [SEEDS [COUNT]]`.
//!
//! Parts of known edges with several noises and seeds; each line, arc and circle of the extraction that lies along an edge of its kind gives a trial
//! for each parameter. The table has the trials, the share of those within 1.96 standard deviations, their root mean square in
//! standard deviations (1 where these are right), and the same of the middle nine tenths, which single bad fits leave alone.

mod truth;

use lineament::curve::pieces::{Piece, Shape, Sigma};
use lineament::math::vec3::{add_scaled, cross, dot, norm, perpendicular, scale, sub, unit};
use lineament::shapes::{Sampling, Scan, bracket, cube, flange, stepped_shaft};
use lineament::{Params, extract};
use std::collections::BTreeMap;
use truth::{Edge, edges};

/// Standard deviations about the middle of a normal distribution that hold 95 % of it.
const INTERVAL: f64 = 1.96;

fn main() {
    let numbers: Vec<usize> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    let (seeds, count) = (numbers.first().copied().unwrap_or(20), numbers.get(1).copied().unwrap_or(20_000));
    println!("part            noise parameter          trials  within   rms  middle");
    let mut all: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for shape in [cube(1.0), bracket(), flange(), stepped_shaft()] {
        for noise in [0.0, 0.05, 0.1, 0.2] {
            let mut found: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
            for seed in 1..=seeds as u64 {
                let scan = shape.sample(&Scan::new(Sampling::BlueNoise { count }).noise(noise).seed(seed));
                let known = edges(&scan.truth.curves);
                let network =
                    extract(&scan.cloud, &Params::default()).expect("the part has a surface").network;
                for piece in network.strips.iter().flat_map(|s| &s.curves) {
                    trials(piece, &known, scan.spacing, &mut found);
                }
            }
            for (name, deviations) in &mut found {
                row(&format!("{:15} {noise:5} {name}", shape.name), deviations);
                all.entry(name).or_default().extend(deviations.iter());
            }
        }
    }
    for (name, deviations) in &mut all {
        row(&format!("all                   {name}"), deviations);
    }
}

fn row(name: &str, deviations: &mut [f64]) {
    let n = deviations.len();
    deviations.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
    let within = deviations.iter().filter(|d| d.abs() <= INTERVAL).count() as f64 / n as f64;
    let rms = |of: &[f64]| (of.iter().map(|d| d * d).sum::<f64>() / of.len().max(1) as f64).sqrt();
    // Of nine tenths of a normal distribution it is .79.
    let middle = rms(&deviations[..n * 9 / 10]) / 0.79;
    println!("{name:40} {n:7}  {within:.4}  {:.2}   {middle:.2}", rms(deviations));
}

/// The deviations of a piece from the edge it lies along, in standard deviations.
fn trials(piece: &Piece, known: &[Edge], spacing: f64, found: &mut BTreeMap<&'static str, Vec<f64>>) {
    let mut take = |name, deviation: f64| found.entry(name).or_default().push(deviation);
    match (&piece.shape, piece.sigma) {
        (Shape::Line, Some(Sigma::Line { offset, direction })) => {
            let Some((at, along)) = truth::line(piece, known, spacing) else { return };
            let middle = scale(add_scaled(piece.from, piece.to, 1.0), 0.5);
            let way = unit(sub(piece.to, piece.from));
            let u = perpendicular(along);
            for axis in [u, cross(along, u)] {
                take("line offset", dot(axis, sub(middle, at)) / offset);
                take("line direction", dot(axis, way) / direction);
            }
        }
        (
            Shape::Arc { round, .. } | Shape::Circle(round),
            Some(Sigma::Round { radius, normal, covariance }),
        ) => {
            let Some(wanted) = truth::circle(round, known, spacing) else { return };
            let whole = matches!(piece.shape, Shape::Circle(_));
            let name = |circle, arc| if whole { circle } else { arc };
            take(name("circle radius", "arc radius"), (round.radius - wanted.radius) / radius);
            let off = sub(round.centre, wanted.centre);
            for k in 0..3 {
                take(name("circle centre", "arc centre"), off[k] / covariance[k][k].sqrt());
            }
            let tilt = cross(round.normal, wanted.normal);
            let u = perpendicular(wanted.normal);
            for axis in [u, cross(wanted.normal, u)] {
                // The deviation is the root of the sum of both squares.
                take(
                    name("circle normal", "arc normal"),
                    dot(tilt, axis) / normal * std::f64::consts::SQRT_2,
                );
            }
            debug_assert!(norm(wanted.normal) > 0.9);
        }
        _ => {}
    }
}
