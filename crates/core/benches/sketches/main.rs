//! How often `section --fit` gives back the drawing of a part: `cargo bench --bench sketches -- [SEEDS] [PART] [NOISE]`.
//!
//! Parts of known outlines, scanned at five densities with noise of 0, .1 and .25 spacings, turned at random, are cut once each.
//! A section is exact if its contours have the edges of the outlines in their order and nothing else; then the distances of
//! parameters are taken: of centres and radii of arcs of a quarter turn and more, and of lines across themselves at both ends; apart from
//! them those of the ends of open outlines.

mod judge;
mod parts;

use judge::{Verdict, judge};
use lineament::section::{Axis, Planes, SectionParams, Sections, section};
use lineament::shapes::{Sampling, Scan};
use parts::{Part, parts};

/// Spacings, as shares of a part's size.
const SPACINGS: [f64; 5] = [1.0 / 40.0, 1.0 / 60.0, 1.0 / 80.0, 1.0 / 120.0, 1.0 / 160.0];
/// Noise, spacings.
const NOISES: [f64; 3] = [0.0, 0.1, 0.25];
/// Turn of the plane that cuts a cylinder aslant.
const ASLANT: [f64; 3] = [0.0, 0.6, 0.8];

fn main() {
    let args: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let seeds: u64 = args.first().and_then(|s| s.parse().ok()).unwrap_or(20);
    let wanted = args.get(1).map_or("", String::as_str);
    let noise: Option<f64> = args.get(2).and_then(|s| s.parse().ok());
    let verbose = args.get(3).is_some();
    println!(
        "part              noise  exact by density (of {seeds})   exact  within   off median, 95 %, most   ends median, 95 %"
    );
    for noise in NOISES.into_iter().filter(|n| noise.is_none_or(|own| own == *n)) {
        let (mut all, mut exact, mut within) = (0, 0, 0);
        for name in parts(SPACINGS[0]).iter().map(|p| p.name).filter(|n| n.contains(wanted)) {
            let mut found = Vec::new();
            for (d, &spacing) in SPACINGS.iter().enumerate() {
                let Some(part) = parts(spacing).into_iter().find(|p| p.name == name) else { continue };
                for seed in 0..seeds {
                    let verdict = trial(&part, spacing, noise, seed);
                    if verbose {
                        println!("{name} noise {noise} density {d} seed {seed}: {verdict:?}");
                    }
                    found.push((d, verdict));
                }
            }
            let (own, good) = row(name, noise, &found);
            (all, exact, within) = (all + found.len(), exact + own, within + good);
        }
        let share = |n: usize| n as f64 / all.max(1) as f64;
        println!("all               {noise:5} {:38.3} {:6.3}", share(exact), share(within));
    }
}

/// Prints a part's row: the exact ones, and those with all parameters within their bound.
fn row(name: &str, noise: f64, found: &[(usize, Verdict)]) -> (usize, usize) {
    let bound = if noise > 0.0 { 0.15 } else { 0.05 };
    let exact = |v: &Verdict| v.exact;
    let by_density: Vec<String> = (0..SPACINGS.len())
        .map(|d| format!("{:4}", found.iter().filter(|f| f.0 == d && exact(&f.1)).count()))
        .collect();
    let offs = sorted(found.iter().flat_map(|f| &f.1.offs));
    let ends = sorted(found.iter().flat_map(|f| &f.1.ends));
    let at = |all: &[f64], share: f64| {
        all.get((share * all.len() as f64) as usize).or(all.last()).copied().unwrap_or(f64::NAN)
    };
    let own = found.iter().filter(|f| exact(&f.1)).count();
    let good = found.iter().filter(|f| exact(&f.1) && f.1.offs.iter().all(|&o| o <= bound)).count();
    let share = |n: usize| n as f64 / found.len() as f64;
    println!(
        "{name:17} {noise:5} {} {:17.3} {:7.3}   {:.3} {:.3} {:.3}   {:.3} {:.3}",
        by_density.concat(),
        share(own),
        share(good),
        at(&offs, 0.5),
        at(&offs, 0.95),
        at(&offs, 1.0),
        at(&ends, 0.5),
        at(&ends, 0.95)
    );
    (own, good)
}

fn sorted<'a>(all: impl Iterator<Item = &'a f64>) -> Vec<f64> {
    let mut sorted: Vec<f64> = all.copied().collect();
    sorted.sort_by(f64::total_cmp);
    sorted
}

fn trial(part: &Part, spacing: f64, noise: f64, seed: u64) -> Verdict {
    let step = spacing * part.size;
    let count = (part.shape.area() / (step * step)) as usize;
    let sampled = part.shape.sample(&Scan::new(Sampling::BlueNoise { count }).noise(noise).seed(seed));
    let angle = 0.7 + 2.4 * seed as f64;
    let (s, c) = if part.aslant { (0.0, 1.0) } else { angle.sin_cos() };
    let turned = sampled.map(1.0, |[x, y, z]| [c * x - s * y, s * x + c * y, z]);
    let (axis, at) = if part.aslant {
        (Axis::Vector(ASLANT), 2.0 * ASLANT[2])
    } else {
        (Axis::Coordinate(2), part.shape.bounds()[1][2] * 0.5)
    };
    let params = SectionParams { axis, planes: Planes::At(vec![at]), fit: true, ..SectionParams::default() };
    let sections: Sections = section(&turned.cloud, &params).expect("a section");
    judge(part, &sections, (c, s))
}
