//! The promise of every reader: on any bytes points or an error with name and place, in bounded memory, and the same
//! from a file and from a pipe.

use lineament_io::{Error, Format, ReadOptions, Scan, read, read_from};
use peak_alloc::PeakAlloc;
use std::io::Cursor;
use std::path::PathBuf;
use std::sync::OnceLock;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Bytes that reading may take beside eight times the input.
const BASE: usize = 64 << 20;

/// Reads the input as `format`, or as the format that it appears to have, from a file and from a pipe, whole and salvaged.
pub fn reads(format: Option<Format>, data: &[u8]) {
    let options = ReadOptions { format, attributes: data.len() % 4 != 1, ..ReadOptions::default() };
    let file = from_file(data, &options);
    let pipe = from_pipe(data, &options);
    same(&file, &pipe);
    let salvage = ReadOptions { salvage: true, ..options };
    if file.is_err() && data.len() % 2 == 0 {
        let _ = from_file(data, &salvage);
    }
}

/// Reads the input from a file, within bounds.
fn from_file(data: &[u8], options: &ReadOptions) -> Result<Scan, Error> {
    static PATH: OnceLock<PathBuf> = OnceLock::new();
    let path = PATH.get_or_init(|| {
        let memory = PathBuf::from("/dev/shm");
        let folder = if memory.is_dir() { memory } else { std::env::temp_dir() };
        folder.join(format!("lineament-fuzz-{}", std::process::id()))
    });
    std::fs::write(path, data).expect("a folder for temporary files");
    bounded(data, || read(path, options))
}

fn from_pipe(data: &[u8], options: &ReadOptions) -> Result<Scan, Error> {
    let copy = data.to_vec();
    bounded(data, || read_from(Box::new(Cursor::new(copy)), "pipe", options))
}

/// The promises of every read: columns of one length, a message that names the input and a place, bounded memory.
fn bounded(data: &[u8], read: impl FnOnce() -> Result<Scan, Error>) -> Result<Scan, Error> {
    MEMORY.reset_peak_usage();
    let before = MEMORY.current_usage();
    let result = read();
    let taken = MEMORY.peak_usage().saturating_sub(before);
    assert!(taken <= BASE + 8 * data.len(), "{taken} bytes of memory for {} of input", data.len());
    match &result {
        Ok(scan) => {
            let count = scan.cloud.len();
            assert!(
                scan.cloud.attributes.iter().all(|a| a.values.len() == count),
                "columns differ in length"
            );
        }
        Err(error) => {
            let message = error.to_string();
            let placed = ["byte ", "line ", "`: "].iter().any(|place| message.contains(place));
            assert!(placed && message.len() < 2000, "a message without a place: {message}");
        }
    }
    result
}

/// A file and a pipe give the same points, or neither does.
fn same(file: &Result<Scan, Error>, pipe: &Result<Scan, Error>) {
    let bits =
        |scan: &Scan| -> Vec<[u64; 3]> { scan.cloud.positions.iter().map(|p| p.map(f64::to_bits)).collect() };
    match (file, pipe) {
        (Ok(file), Ok(pipe)) => {
            assert_eq!(bits(file), bits(pipe), "a file and a pipe give different points");
            assert_eq!(file.missing, pipe.missing, "a file and a pipe miss different parts");
        }
        (Err(_), Err(_)) => {}
        (Ok(_), Err(error)) => panic!("read from a file, refused from a pipe: {error}"),
        (Err(error), Ok(_)) => panic!("read from a pipe, refused from a file: {error}"),
    }
}

/// Bytes of a page of E57, the last four of which are the CRC-32C of the others.
const PAGE: usize = 1024;

/// The input with right checksums in its pages: else nothing behind them would be tried.
pub fn with_checksums(data: &[u8]) -> Vec<u8> {
    let mut data = data.to_vec();
    for page in data.chunks_exact_mut(PAGE) {
        let sum = crc32c(&page[..PAGE - 4]);
        page[PAGE - 4..].copy_from_slice(&sum.to_be_bytes());
    }
    data
}

fn crc32c(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |sum, byte| {
        (0..8).fold(
            sum ^ u32::from(*byte),
            |sum, _| if sum & 1 == 1 { sum >> 1 ^ 0x82f6_3b78 } else { sum >> 1 },
        )
    })
}
