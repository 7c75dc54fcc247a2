//! What the tests of this crate share.

use lineament_io::{Error, ReadOptions, Scan, read_from};
use std::io::{Cursor, Read};
use std::path::PathBuf;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

pub mod copc;
pub mod e57;
pub mod e57_raw;
pub mod gps;
pub mod las;
pub mod parquet;
mod seeds;
pub use seeds::{network, seeds};

/// Reads bytes as an input of unknown length, a few bytes a call, as a pipe might give them.
pub fn from_pipe(bytes: &[u8], name: &str, options: &ReadOptions) -> Result<Scan, Error> {
    struct Trickle(Cursor<Vec<u8>>);
    impl Read for Trickle {
        fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
            let some = out.len().min(1 + (self.0.position() as usize * 7) % 1000);
            self.0.read(&mut out[..some])
        }
    }
    read_from(Box::new(Trickle(Cursor::new(bytes.to_vec()))), name, options)
}

/// Reads bytes as a file, and as a pipe, which must agree.
pub fn from_bytes(bytes: &[u8], name: &str, options: &ReadOptions) -> Result<Scan, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).unwrap();
    let file = lineament_io::read(&path, options);
    let pipe = from_pipe(bytes, name, options);
    match (&file, &pipe) {
        (Ok(file), Ok(pipe)) => {
            assert_eq!(bits(file), bits(pipe));
            // As text, since NaN differs from itself.
            assert_eq!(format!("{:?}", file.cloud.attributes), format!("{:?}", pipe.cloud.attributes));
            assert_eq!((&file.ignored, &file.missing), (&pipe.ignored, &pipe.missing));
        }
        (Err(file), Err(pipe)) => {
            assert_eq!(file.to_string().replace(&path.display().to_string(), name), pipe.to_string());
        }
        _ => panic!("a file gives {file:?}, a pipe {pipe:?}"),
    }
    file
}

/// Coordinates as bits, so that NaN equals itself.
pub fn bits(scan: &Scan) -> Vec<[u64; 3]> {
    scan.cloud.positions.iter().map(|p| p.map(f64::to_bits)).collect()
}

/// Processor time that this thread has taken, which other programs do not add to; the time of day where the system does not tell it.
pub fn spent() -> Duration {
    static START: OnceLock<Instant> = OnceLock::new();
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|numbers| numbers.split(' ').next()?.parse().ok());
    nanoseconds.map_or_else(|| START.get_or_init(Instant::now).elapsed(), Duration::from_nanos)
}

/// A file of the evaluation data, or `None` with a note where they are absent.
pub fn shared(path: &str) -> Option<PathBuf> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data").join(path);
    if root.exists() {
        return Some(root);
    }
    println!("skipped: there is no {}", root.display());
    None
}

/// An example program of this crate, which cargo builds beside the tests; `None`, with a note, if it did not.
pub fn example(name: &str) -> Option<PathBuf> {
    let test = std::env::current_exe().unwrap();
    let path = test.parent()?.parent()?.join("examples").join(name);
    if path.exists() {
        return Some(path);
    }
    println!("skipped: {} is not built; `cargo test -p lineament-io` builds it", path.display());
    None
}
