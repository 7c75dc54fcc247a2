//! Damaged inputs under a limit on address space: each is read or refused, with a message that names it and a place, in
//! bounded time and memory.
#![cfg(target_os = "linux")]

use crate::common::{example, seeds, shared};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

/// Address space of the program itself: code, libraries, stacks of threads, and the allocator's reserves.
const PROGRAM: u64 = 96 << 20;

/// Runs the reader on a file with 64 MiB + 8 x its size, and tells what it should not have done.
fn offence(reader: &Path, path: &Path) -> Option<String> {
    let length = std::fs::metadata(path).unwrap().len();
    let kilobytes = (PROGRAM + (64 << 20) + 8 * length) / 1024;
    let start = Instant::now();
    let run = Command::new("sh")
        .arg("-c")
        .arg(format!("ulimit -v {kilobytes}; exec \"$0\" \"$1\""))
        .args([reader, path])
        .env("RAYON_NUM_THREADS", "2")
        .env("MALLOC_ARENA_MAX", "1")
        .output()
        .unwrap();
    let message = String::from_utf8_lossy(&run.stderr).into_owned();
    let named = message.contains(&path.display().to_string());
    let placed = ["byte ", "line ", "cannot open"].iter().any(|place| message.contains(place));
    match run.status.code() {
        Some(0) if start.elapsed() < Duration::from_secs(10) => None,
        Some(1)
            if named
                && placed
                && !message.contains("panicked")
                && start.elapsed() < Duration::from_secs(10) =>
        {
            None
        }
        code => Some(format!("{}: {code:?} after {:?}: {message}", path.display(), start.elapsed())),
    }
}

fn check(paths: &[PathBuf]) {
    let Some(reader) = example("positions") else { return };
    let offences: Vec<String> = paths.iter().filter_map(|path| offence(&reader, path)).collect();
    assert!(offences.is_empty(), "{} of {}:\n{}", offences.len(), paths.len(), offences.join("\n"));
    println!("{} files read or refused in bounds", paths.len());
}

#[test]
fn files_that_broke_other_readers_are_read_or_refused_in_bounds() {
    let Some(folder) = shared("malformed") else { return };
    let mut paths: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    check(&paths);
}

/// Numbers that files lie with.
const LIES: [u64; 6] = [0, 1, 1 << 31, 1 << 32, 1 << 63, u64::MAX];

/// A file with a number at a place: as text where text is, otherwise as 4 and as 8 bytes.
fn lied(bytes: &[u8], at: usize, lie: u64) -> Vec<Vec<u8>> {
    let digits = bytes[at..].iter().take_while(|b| b.is_ascii_digit()).count();
    let mut files = Vec::new();
    if digits > 0 {
        files.push([&bytes[..at], lie.to_string().as_bytes(), &bytes[at + digits..]].concat());
    }
    for width in [4, 8] {
        let mut changed = bytes.to_vec();
        if let Some(place) = changed.get_mut(at..at + width) {
            place.copy_from_slice(&lie.to_le_bytes()[..width]);
            files.push(changed);
        }
    }
    files
}

#[test]
fn a_thousand_damaged_files_are_read_or_refused_in_bounds() {
    let folder = tempfile::tempdir().unwrap();
    let mut paths = Vec::new();
    let mut add = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(format!("{:04}-{name}", paths.len()));
        std::fs::write(&path, bytes).unwrap();
        paths.push(path);
    };
    for (name, bytes) in seeds() {
        add(&name, &bytes);
        for part in 0..24 {
            add(&name, &bytes[..bytes.len() * part / 24]);
        }
        let starts = |i: usize| bytes[i].is_ascii_digit() && (i == 0 || !bytes[i - 1].is_ascii_digit());
        let numbers: Vec<usize> = (0..bytes.len()).filter(|&i| starts(i)).collect();
        // The counts of binary headers: LAS at 94 to 112 and 247, STL at 80.
        let binary = [80, 94, 96, 100, 105, 107, 247].into_iter().filter(|&at| at + 8 < bytes.len());
        let step = numbers.len().div_ceil(10).max(1);
        for at in numbers.iter().copied().step_by(step).chain(binary) {
            for lie in LIES.into_iter().skip(at % 2).step_by(2) {
                lied(&bytes, at, lie).iter().for_each(|file| add(&name, file));
            }
        }
    }
    assert!(paths.len() >= 1000, "{}", paths.len());
    check(&paths);
}

#[test]
fn one_long_line_and_millions_of_properties_take_memory_in_proportion() {
    let folder = tempfile::tempdir().unwrap();
    let line = folder.path().join("line.off");
    std::fs::write(&line, format!("OFF 1000000 0 0 {}", "1 2 3 ".repeat(1_000_000))).unwrap();
    let properties: String = (0..2_000_000).map(|i| format!("property uchar {i:x}\n")).collect();
    let header = format!("ply\nformat ascii 1.0\nelement vertex 1\n{properties}end_header\n");
    let ply = folder.path().join("properties.ply");
    std::fs::write(&ply, header).unwrap();
    check(&[line, ply]);
}
