//! Names in the stack of slices, compared with the features of each part: `cargo run --release -p lineament-tools --bin
//! naming_table -- [PART] [-v] [-q] [-u|-n] [-a]`.
//!
//! Each part of `crates/core/tests/suite/naming/parts.rs` is scanned with several seeds and noise levels, turned or not, and
//! cut in several numbers of slices. A row is a part, a view and a noise level: features named, share of ends within 0.1
//! spacing, the worst end, share of ends within twice their stated error, share of sizes (radii, apexes) within 0.1 spacing,
//! the worst size, missing features and false ones, over all clouds. `-v` lists them, `-q` takes one seed, `-u` takes the
//! parts kept out while the methods were made, `-n` the parts that came last, `-a` compares the three rules for an automatic
//! axis on turned parts.

#[path = "../../../crates/core/tests/suite/naming/judge.rs"]
mod judge;
#[path = "../../../crates/core/tests/suite/naming/parts.rs"]
mod parts;

use judge::{Off, Verdict, judge};
use lineament::section::{Axis, Planes, SectionParams, section_observed};
use lineament::shapes::{Sampled, Sampling, Scan};
use parts::Part;
use parts::known::View;
use rayon::prelude::*;

const NOISES: [f64; 3] = [0.0, 0.1, 0.25];
const SEEDS: [u64; 3] = [1, 2, 3];
const COUNTS: [usize; 4] = [23, 37, 50, 81];

/// Rotates about (1, 2, 3) by 40 degrees, and moves.
fn turned(p: [f64; 3]) -> [f64; 3] {
    let q = rotated(p);
    [q[0] + 3.0, q[1] - 5.0, q[2] + 7.0]
}

fn rotated(p: [f64; 3]) -> [f64; 3] {
    let k = [1.0, 2.0, 3.0].map(|x| x / 14.0f64.sqrt());
    let (s, c) = 40.0f64.to_radians().sin_cos();
    let dot = k[0] * p[0] + k[1] * p[1] + k[2] * p[2];
    let cross = [k[1] * p[2] - k[2] * p[1], k[2] * p[0] - k[0] * p[2], k[0] * p[1] - k[1] * p[0]];
    [0, 1, 2].map(|i| p[i] * c + cross[i] * s + k[i] * dot * (1.0 - c))
}

/// Cuts a scan and judges it.
fn case(sampled: &Sampled, view: &View, tilted: bool, count: usize) -> (Verdict, usize) {
    let mut unit = [0.0; 3];
    unit[view.axis] = 1.0;
    let (cloud, axis, shift) = if tilted {
        let axis = rotated(unit);
        let origin = turned([0.0; 3]);
        let shift = (0..3).map(|k| origin[k] * axis[k]).sum();
        (sampled.map(1.0, turned).cloud, Axis::Vector(axis), shift)
    } else {
        (sampled.cloud.clone(), Axis::Coordinate(view.axis), 0.0)
    };
    let params = SectionParams { axis, planes: Planes::Count(count), fit: true, ..SectionParams::default() };
    let Ok((sections, stack)) = section_observed(&cloud, &params, &|_| ()) else { return Default::default() };
    (judge(&view.features, shift, &sections, &stack), stack.repeats.len())
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let has = |flag: &str| arguments.iter().any(|a| a == flag);
    let wanted = arguments.iter().find(|a| !a.starts_with('-'));
    let parts = match (has("-n"), has("-u")) {
        (true, _) => parts::newest(),
        (_, true) => parts::held_out(),
        _ => parts::parts(),
    };
    let of_name = |p: &Part| wanted.is_none_or(|w| p.shape.name.contains(w.as_str()));
    let parts: Vec<Part> = parts.into_iter().filter(of_name).collect();
    if has("-a") {
        return parts.iter().for_each(automatic);
    }
    table(&parts, if has("-q") { &SEEDS[..1] } else { &SEEDS }, has("-v"));
}

/// Prints the table of these parts, scanned with these seeds.
fn table(parts: &[Part], seeds: &[u64], verbose: bool) {
    println!(
        "{:20} {:4} {:5} {:>5} {:>9} {:>7} {:>7} {:>9} {:>7} {:>7} {:>5} {:>7}",
        "part",
        "axis",
        "noise",
        "named",
        "ends<.1h",
        "worst",
        "stated",
        "sizes<.1h",
        "worst",
        "missing",
        "extra",
        "repeats"
    );
    let mut total = Sum::default();
    for part in parts {
        for noise in NOISES {
            let scan = Scan::new(Sampling::BlueNoise { count: part.count }).noise(noise);
            let scans: Vec<Sampled> =
                seeds.par_iter().map(|&seed| part.shape.sample(&scan.seed(seed))).collect();
            for view in &part.views {
                let sum = row(&scans, view, verbose);
                println!("{:20} {:4} {noise:5} {sum}", part.shape.name, ["x", "y", "z"][view.axis]);
                total.add(sum);
            }
        }
    }
    println!("{:31} {total}", "all");
}

/// Slices a turned part by each rule, and prints the angle between its axis and the nearest axis of features, with the
/// features named there.
fn automatic(part: &Part) {
    let scan = Scan::new(Sampling::BlueNoise { count: part.count }).noise(0.1).seed(1);
    let cloud = part.shape.sample(&scan).map(1.0, turned).cloud;
    for (rule, axis) in [("faces", Axis::Faces), ("principal", Axis::Principal), ("thinnest", Axis::Thinnest)]
    {
        let params = SectionParams { axis, planes: Planes::Count(37), fit: true, ..SectionParams::default() };
        let Ok((sections, stack)) = section_observed(&cloud, &params, &|_| ()) else { continue };
        let found = sections.frame.axes[2];
        let cosine = |view: &&View| {
            let mut unit = [0.0; 3];
            unit[view.axis] = 1.0;
            (0..3).map(|k| rotated(unit)[k] * found[k]).sum::<f64>()
        };
        let all = part.views.iter();
        let Some(view) = all.max_by(|a, b| cosine(a).abs().total_cmp(&cosine(b).abs())) else { continue };
        let off = cosine(&view).abs().min(1.0).acos().to_degrees();
        print!("{:20} {rule:9} {off:5.2} degrees off {}", part.shape.name, ["x", "y", "z"][view.axis]);
        let features: Vec<_> = view.features.iter().map(|k| k.along(cosine(&view).signum())).collect();
        let origin = turned([0.0; 3]);
        let shift = (0..3).map(|k| origin[k] * found[k]).sum();
        let verdict = judge(&features, shift, &sections, &stack);
        println!(
            ": {} named, {} missing, {} extra",
            verdict.named,
            verdict.missing.len(),
            verdict.extra.len()
        );
    }
}

fn row(scans: &[Sampled], view: &View, verbose: bool) -> Sum {
    let mut sum = Sum::default();
    let cases: Vec<(usize, usize)> =
        (0..scans.len()).flat_map(|k| (0..COUNTS.len()).map(move |c| (k, c))).collect();
    let tilted = |k: usize, c: usize| (k + c) % 3 == 2;
    let found: Vec<(Verdict, usize)> =
        cases.par_iter().map(|&(k, c)| case(&scans[k], view, tilted(k, c), COUNTS[c])).collect();
    for (&(k, c), (verdict, repeats)) in cases.iter().zip(&found) {
        if verbose {
            let way = if tilted(k, c) { " tilted" } else { "" };
            tell(verdict, &format!("{} of {}{way}", SEEDS[k], COUNTS[c]));
        }
        sum.count(verdict, *repeats >= view.repeats);
    }
    sum
}

fn tell(verdict: &Verdict, cloud: &str) {
    for (what, off) in [("end", &verdict.ends), ("size", &verdict.sizes)] {
        for Off { error, text, .. } in off.iter().filter(|o| o.error.abs() > 0.1) {
            println!("    seed {cloud}: {what} {error:+.2} at {text}");
        }
    }
    verdict.missing.iter().for_each(|m| println!("    seed {cloud}: missing {m}"));
    verdict.extra.iter().for_each(|e| println!("    seed {cloud}: extra {e}"));
}

/// Sums over clouds.
#[derive(Clone, Copy, Default)]
struct Sum {
    named: usize,
    ends: Share,
    sizes: Share,
    missing: usize,
    extra: usize,
    clouds: usize,
    repeats: usize,
}

#[derive(Clone, Copy, Default)]
struct Share {
    all: usize,
    within: usize,
    stated: usize,
    worst: f64,
}

impl Share {
    fn take(&mut self, offs: &[Off]) {
        for Off { error, stated, .. } in offs {
            self.all += 1;
            self.within += usize::from(error.abs() <= 0.1);
            self.stated += usize::from(error.abs() <= 2.0 * stated);
            self.worst = self.worst.max(error.abs());
        }
    }

    fn add(&mut self, other: Share) {
        self.all += other.all;
        self.within += other.within;
        self.stated += other.stated;
        self.worst = self.worst.max(other.worst);
    }
}

impl Sum {
    fn count(&mut self, verdict: &Verdict, repeats: bool) {
        self.named += verdict.named;
        self.ends.take(&verdict.ends);
        self.sizes.take(&verdict.sizes);
        self.missing += verdict.missing.len();
        self.extra += verdict.extra.len();
        self.clouds += 1;
        self.repeats += usize::from(repeats);
    }

    fn add(&mut self, other: Sum) {
        self.named += other.named;
        self.ends.add(other.ends);
        self.sizes.add(other.sizes);
        self.missing += other.missing;
        self.extra += other.extra;
        self.clouds += other.clouds;
        self.repeats += other.repeats;
    }
}

impl std::fmt::Display for Sum {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let share = |some: usize, s: Share| if s.all > 0 { some as f64 / s.all as f64 } else { 1.0 };
        write!(
            f,
            "{:5} {:9.3} {:7.2} {:7.3} {:9.3} {:7.2} {:7} {:5} {:>7}",
            self.named,
            share(self.ends.within, self.ends),
            self.ends.worst,
            share(self.ends.stated, self.ends),
            share(self.sizes.within, self.sizes),
            self.sizes.worst,
            self.missing,
            self.extra,
            format!("{}/{}", self.repeats, self.clouds)
        )
    }
}
