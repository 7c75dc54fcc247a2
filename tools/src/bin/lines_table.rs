//! Lines of each method on parts of many kinds: `cargo run --release -p lineament-tools --bin lines_table -- [PART] [-s]`.
//!
//! Each part of `crates/core/tests/suite/naming/parts.rs` is scanned at three noise levels, and its lines are compared with its
//! edges: F1 within one spacing, curves found, junctions hit within two spacings. Nothing in the methods was chosen by these figures. `-s`
//! takes a third of the points, so that faces are few spacings wide.

#[path = "../../../crates/core/tests/suite/naming/parts.rs"]
#[allow(dead_code, reason = "the features of the parts are for the table of names")]
mod parts;

use lineament::shapes::{Sampling, Scan};
use lineament::{Method, Params, evaluate, extract};
use parts::Part;

const NOISES: [f64; 3] = [0.0, 0.1, 0.25];
const METHODS: [Method; 2] = [Method::Auto, Method::Penalty];
/// Share of the points that `-s` takes.
const SPARSE: usize = 3;

/// Sums over scans: F1, curves found and all, junctions hit and all, scans.
#[derive(Clone, Copy, Default)]
struct Sums {
    f1: f64,
    curves: [usize; 2],
    junctions: [usize; 2],
    scans: usize,
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let sparse = arguments.iter().any(|a| a == "-s");
    let wanted = arguments.iter().find(|a| !a.starts_with('-'));
    let parts: Vec<Part> = [parts::parts(), parts::held_out(), parts::newest()]
        .into_iter()
        .flatten()
        .filter(|p| wanted.is_none_or(|w| p.shape.name.contains(w.as_str())))
        .collect();
    println!(
        "{:22} {:5}  {}",
        "part",
        "noise",
        METHODS.map(|m| format!("{m:?} F1, curves, junctions")).join("   ")
    );
    let mut totals = [[Sums::default(); METHODS.len()]; NOISES.len()];
    for part in &parts {
        let count = if sparse { part.count / SPARSE } else { part.count };
        for (noise, totals) in NOISES.into_iter().zip(&mut totals) {
            let sums = METHODS.map(|method| of_scan(part, count, noise, method));
            show(part.shape.name, noise, &sums);
            totals.iter_mut().zip(sums).for_each(|(total, sum)| *total = total.with(sum));
        }
    }
    NOISES.into_iter().zip(&totals).for_each(|(noise, sums)| show("all", noise, sums));
}

fn of_scan(part: &Part, count: usize, noise: f64, method: Method) -> Sums {
    let scan = part.shape.sample(&Scan::new(Sampling::Area { count }).noise(noise).seed(1));
    let params = Params { method, ..Params::default() };
    let Ok(found) = extract(&scan.cloud, &params) else { return Sums::default() };
    let score = evaluate::against(&found.network, &scan.truth, scan.spacing);
    // A part without edges has nothing to find: right if nothing is found.
    let f1 = match score.curves_found[1] {
        0 => f64::from(u8::from(found.network.strips.is_empty())),
        _ => score.at_1h.f1,
    };
    Sums { f1, curves: score.curves_found, junctions: score.junctions_hit, scans: 1 }
}

impl Sums {
    fn with(self, other: Sums) -> Sums {
        let both = |a: [usize; 2], b: [usize; 2]| [a[0] + b[0], a[1] + b[1]];
        Sums {
            f1: self.f1 + other.f1,
            curves: both(self.curves, other.curves),
            junctions: both(self.junctions, other.junctions),
            scans: self.scans + other.scans,
        }
    }
}

fn show(name: &str, noise: f64, sums: &[Sums]) {
    let one = |s: &Sums| {
        let share = |[some, all]: [usize; 2]| format!("{some}/{all}");
        format!("{:.3} {:>9} {:>9}", s.f1 / s.scans.max(1) as f64, share(s.curves), share(s.junctions))
    };
    println!("{name:22} {noise:5}  {}", sums.iter().map(one).collect::<Vec<_>>().join("   "));
}
