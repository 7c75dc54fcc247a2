//! Share of closed contours of solid parts, all of which should be closed: `cargo run --release -p lineament-tools --bin
//! closed_table -- [PART] [-v]`.
//!
//! Each part of `crates/core/tests/suite/naming/parts.rs` except the tube is scanned with points strewn at random, which leave
//! bare patches, at two seeds and three noise levels, and cut in 37 slices along each coordinate axis. Slices with half as many
//! points again as the median of their axis are left out: their planes run within a few spacings of a face. The rest are
//! walls cut at any angle, and bores and bosses that a plane grazes. `-v` lists the slices with open contours.

#[path = "../../../crates/core/tests/suite/naming/parts.rs"]
#[allow(dead_code, reason = "the features of the parts are for the table of names")]
mod parts;

use lineament::section::{Axis, Planes, Section, SectionParams, section};
use lineament::shapes::{Sampling, Scan};
use parts::Part;
use rayon::prelude::*;

const NOISES: [f64; 3] = [0.0, 0.1, 0.25];
const SEEDS: [u64; 2] = [1, 2];

/// Contours in all, and those that are open.
type Count = (usize, usize);

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let verbose = arguments.iter().any(|a| a == "-v");
    let wanted = arguments.iter().find(|a| !a.starts_with('-'));
    let parts: Vec<Part> = [parts::parts(), parts::held_out(), parts::newest()]
        .into_iter()
        .flatten()
        .filter(|p| p.shape.name != "tube" && wanted.is_none_or(|w| p.shape.name.contains(w.as_str())))
        .collect();
    println!("{:20} {:>15} {:>15} {:>15}", "open of all, noise", NOISES[0], NOISES[1], NOISES[2]);
    let mut totals = [(0, 0); 3];
    for part in &parts {
        let counts = NOISES.map(|noise| of_part(part, noise, verbose));
        show(part.shape.name, &counts);
        totals.iter_mut().zip(counts).for_each(|(total, count)| *total = add(*total, count));
    }
    show("all", &totals);
}

fn show(name: &str, counts: &[Count; 3]) {
    let [a, b, c] = counts.map(|(all, open)| format!("{open} of {all}"));
    println!("{name:20} {a:>15} {b:>15} {c:>15}");
}

fn add(a: Count, b: Count) -> Count {
    (a.0 + b.0, a.1 + b.1)
}

fn of_part(part: &Part, noise: f64, verbose: bool) -> Count {
    let scan = |seed| {
        let scan = Scan::new(Sampling::Area { count: part.count }).noise(noise).seed(seed);
        let cloud = part.shape.sample(&scan).cloud;
        let along = |axis| {
            let params = SectionParams {
                axis: Axis::Coordinate(axis),
                planes: Planes::Count(37),
                ..SectionParams::default()
            };
            let sections = section(&cloud, &params).map_or_else(|_| Vec::new(), |s| s.sections);
            let name = format!("{} noise {noise} seed {seed} axis {axis}", part.shape.name);
            of_sections(&sections, if verbose { &name } else { "" })
        };
        (0..3).into_par_iter().map(along).reduce(|| (0, 0), add)
    };
    SEEDS.map(scan).into_iter().fold((0, 0), add)
}

fn of_sections(sections: &[Section], name: &str) -> Count {
    let mut points: Vec<usize> = sections.iter().map(|s| s.points).collect();
    points.sort_unstable();
    let most = points.get(points.len() / 2).map_or(0, |median| median * 3 / 2);
    let mut count = (0, 0);
    for section in sections.iter().filter(|s| s.points <= most) {
        let open = section.contours.iter().filter(|c| !c.closed).count();
        if open > 0 && !name.is_empty() {
            println!("    {name} slice {}: {open} open of {}", section.plane, section.contours.len());
        }
        count = add(count, (section.contours.len(), open));
    }
    count
}
