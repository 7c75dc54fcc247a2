//! Sections of a file beside reading it and sorting its points: `cargo bench -p lineament-io --bench sections -- [N]`.
//!
//! A scan of N points (a million unless given) of the bracket, noise 0.1, is written as a PLY in random order. Then in
//! turn: the file is read and its points sorted by height, once by the standard library's stable sort and once by its
//! unstable one; and the file is read and cut in 100 slices with curves, as such, with the result written as JSON (which waits
//! until the disk has it), and with the names of the stack written too. Each has a process of its own, as whoever cuts a scan has:
//! in one process for all, what the allocator kept of the last makes the next faster by a fifth, or not. Medians of the
//! rounds.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

use lineament::Cloud;
use lineament::section::{Planes, SectionParams, section, section_observed};
use lineament::shapes::{Rng, Sampling, Scan, bracket};
use lineament_io::{ReadOptions, SectionContext, read, write_sections};

const ROUNDS: usize = 9;

/// What is timed, by the names that a process is told.
const TASKS: [(&str, &str); 5] = [
    ("sort", "read and sort by height"),
    ("sort-unstably", "read and sort unstably"),
    ("curves", "read, slices, curves"),
    ("written", "the same written"),
    ("named", "the same with the stack's names"),
];

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

fn main() -> Fallible<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [task, input, output] = arguments.as_slice() {
        let start = Instant::now();
        std::hint::black_box(run(task, Path::new(input), Path::new(output))?);
        println!("{}", start.elapsed().as_secs_f64());
        return Ok(());
    }
    let count = arguments.iter().find_map(|a| a.parse().ok()).unwrap_or(1_000_000);
    let folder = tempfile::tempdir()?;
    let (input, output) = (folder.path().join("scan.ply"), folder.path().join("sections.json"));
    write_scan(&input, count)?;
    let mut seconds = [const { Vec::new() }; TASKS.len()];
    for _ in 0..ROUNDS {
        for ((task, _), seconds) in TASKS.iter().zip(&mut seconds) {
            let mut own = Command::new(std::env::current_exe()?);
            // What goes wrong there is told here.
            let told = own.arg(task).args([&input, &output]).stderr(Stdio::inherit()).output()?.stdout;
            seconds.push(String::from_utf8(told)?.trim().parse::<f64>()?);
        }
    }
    let medians = seconds.map(|mut s| {
        s.sort_by(f64::total_cmp);
        s[s.len() / 2]
    });
    println!("{count} points, 100 slices, median of {ROUNDS}, times of the first in brackets");
    for ((_, name), seconds) in TASKS.iter().zip(medians) {
        println!("{name:32} {seconds:8.3} s ({:.2})", seconds / medians[0]);
    }
    Ok(())
}

/// Does what a task stands for; returns how much came of it.
fn run(task: &str, input: &Path, output: &Path) -> Fallible<usize> {
    let params = SectionParams { planes: Planes::Count(100), fit: true, ..SectionParams::default() };
    let mut cloud: Cloud = read(input, &ReadOptions { attributes: false, ..Default::default() })?.cloud;
    let mut context = SectionContext::default();
    let sections = match task {
        "sort" => {
            cloud.positions.sort_by(|a, b| a[2].total_cmp(&b[2]));
            return Ok(std::hint::black_box(cloud).len());
        }
        "sort-unstably" => {
            cloud.positions.sort_unstable_by(|a, b| a[2].total_cmp(&b[2]));
            return Ok(std::hint::black_box(cloud).len());
        }
        "named" => {
            let (sections, stack) = section_observed(&cloud, &params, &|_| ())?;
            context.stack = stack;
            sections
        }
        _ => section(&cloud, &params)?,
    };
    if task != "curves" {
        write_sections(output, &[], &sections, &context)?;
    }
    Ok(sections.contours().count())
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
