//! Sections of a file beside reading it and sorting its points: `cargo bench -p lineament-io --bench sections -- [N]`.
//!
//! A scan of N points (a million unless given) of the bracket, noise 0.1, is written as a PLY in random order. Then in
//! turn: the file is read and its points sorted by height, once by the standard library's stable sort and once by its
//! unstable one; and the file is read and cut in 100 slices with curves, as such, with the result written as JSON (which waits
//! until the disk has it), and with the names of the stack written too. Medians of the rounds.

use std::fs;
use std::path::Path;
use std::time::Instant;

use lineament::Cloud;
use lineament::section::{Planes, SectionParams, section, section_observed};
use lineament::shapes::{Rng, Sampling, Scan, bracket};
use lineament_io::{ReadOptions, SectionContext, read, write_sections};

const ROUNDS: usize = 5;

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

fn main() -> Fallible<()> {
    let count = std::env::args().skip(1).find_map(|a| a.parse().ok()).unwrap_or(1_000_000);
    let folder = tempfile::tempdir()?;
    let (input, output) = (folder.path().join("scan.ply"), folder.path().join("sections.json"));
    write_scan(&input, count)?;
    let params = SectionParams { planes: Planes::Count(100), fit: true, ..SectionParams::default() };
    let load = || -> Fallible<Cloud> {
        Ok(read(&input, &ReadOptions { attributes: false, ..Default::default() })?.cloud)
    };
    let mut seconds = [const { Vec::new() }; 5];
    for _ in 0..ROUNDS {
        time(&mut seconds[0], || {
            let mut cloud = load()?;
            cloud.positions.sort_by(|a, b| a[2].total_cmp(&b[2]));
            Ok(std::hint::black_box(cloud).len())
        })?;
        time(&mut seconds[1], || {
            let mut cloud = load()?;
            cloud.positions.sort_unstable_by(|a, b| a[2].total_cmp(&b[2]));
            Ok(std::hint::black_box(cloud).len())
        })?;
        time(&mut seconds[2], || Ok(section(&load()?, &params)?.contours().count()))?;
        time(&mut seconds[3], || {
            let sections = section(&load()?, &params)?;
            write_sections(&output, &[], &sections, &SectionContext::default())?;
            Ok(sections.contours().count())
        })?;
        time(&mut seconds[4], || {
            let (sections, stack) = section_observed(&load()?, &params, &|_| ())?;
            let context = SectionContext { stack, ..Default::default() };
            write_sections(&output, &[], &sections, &context)?;
            Ok(sections.contours().count())
        })?;
    }
    let [sorted, unstable, curves, written, named] = seconds.map(|mut s| {
        s.sort_by(f64::total_cmp);
        s[s.len() / 2]
    });
    println!("{count} points, 100 slices, median of {ROUNDS}, times of the first in brackets");
    println!("read and sort by height          {sorted:8.3} s");
    println!("read and sort unstably           {unstable:8.3} s");
    println!("read, slices, curves             {curves:8.3} s ({:.2})", curves / sorted);
    println!("the same written                 {written:8.3} s ({:.2})", written / sorted);
    println!("the same with the stack's names  {named:8.3} s ({:.2})", named / sorted);
    Ok(())
}

fn time(into: &mut Vec<f64>, work: impl FnOnce() -> Fallible<usize>) -> Fallible<()> {
    let start = Instant::now();
    std::hint::black_box(work()?);
    into.push(start.elapsed().as_secs_f64());
    Ok(())
}

fn write_scan(path: &Path, count: usize) -> std::io::Result<()> {
    let mut points =
        bracket().sample(&Scan::new(Sampling::Area { count }).noise(0.1).seed(1)).cloud.positions;
    shuffle(&mut points);
    let properties = ["x", "y", "z"].map(|name| format!("property float {name}\n")).concat();
    let head = format!("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", points.len());
    let mut bytes = format!("{head}{properties}end_header\n").into_bytes();
    for x in points.iter().flatten() {
        bytes.extend_from_slice(&(*x as f32).to_le_bytes());
    }
    fs::write(path, bytes)
}

/// A scan comes in no useful order.
fn shuffle(points: &mut [[f64; 3]]) {
    let mut random = Rng::new(7);
    for i in (1..points.len()).rev() {
        points.swap(i, random.below(i as u64 + 1) as usize);
    }
}
