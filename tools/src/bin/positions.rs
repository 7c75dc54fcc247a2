//! Reads point clouds and prints their format, size, columns and omissions: `cargo run -p lineament-io --example positions --
//! FILE... [--to OUT.f64]`. `--to` writes the coordinates of all points as little endian f64, for comparison with other
//! programs.

use lineament_io::{ReadOptions, read};
use std::io::Write;
use std::path::Path;
use std::time::Instant;

fn main() -> std::process::ExitCode {
    match run() {
        Ok(()) => std::process::ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            std::process::ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn std::error::Error>> {
    let mut inputs: Vec<String> = std::env::args().skip(1).collect();
    let to = inputs.iter().position(|a| a == "--to").map(|at| inputs.split_off(at));
    let mut positions = Vec::new();
    for input in &inputs {
        let start = Instant::now();
        let scan = read(Path::new(input), &ReadOptions::default())?;
        let seconds = start.elapsed().as_secs_f64();
        let names: Vec<&str> = scan.cloud.attributes.iter().map(|a| a.name.as_str()).collect();
        println!("{input}: {}, {} points in {seconds:.4} s", scan.format, scan.cloud.len());
        println!("  columns: {}; left out: {}", names.join(", "), scan.ignored.join("; "));
        positions.extend(scan.cloud.positions);
    }
    if let Some(out) = to.as_ref().and_then(|to| to.get(1)) {
        let mut file = std::io::BufWriter::new(std::fs::File::create(out)?);
        for coordinate in positions.iter().flatten() {
            file.write_all(&coordinate.to_le_bytes())?;
        }
        file.flush()?;
    }
    Ok(())
}
