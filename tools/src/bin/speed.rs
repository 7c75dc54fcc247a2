//! Seconds to read a cloud, and seconds to read its bytes: `cargo run --release -p lineament-tools --bin speed -- FILE [ROUNDS
//! [--bare]]`, where `--bare` reads positions alone. The two take turns, and the least time of each is printed.

use lineament_io::{ReadOptions, read};
use std::path::Path;
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let file = Path::new(arguments.first().ok_or("expected FILE [ROUNDS]")?);
    let rounds: usize = arguments.get(1).map_or(Ok(5), |rounds| rounds.parse())?;
    let attributes = arguments.iter().all(|a| a != "--bare");
    let options = ReadOptions { memory: Some(u64::MAX), attributes, ..ReadOptions::default() };
    let (mut of_bytes, mut of_points, mut count) = (f64::INFINITY, f64::INFINITY, 0);
    for _ in 0..rounds.max(1) {
        let start = Instant::now();
        let bytes = std::fs::read(file)?;
        of_bytes = of_bytes.min(start.elapsed().as_secs_f64());
        drop(bytes);
        let start = Instant::now();
        count = read(file, &options)?.cloud.len();
        of_points = of_points.min(start.elapsed().as_secs_f64());
    }
    println!(
        "{count} points in {of_points:.3} s, bytes in {of_bytes:.3} s, ratio {:.2}",
        of_points / of_bytes
    );
    Ok(())
}
