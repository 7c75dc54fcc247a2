//! Reads inputs that are damaged at random, for a given time: `cargo run --release -p lineament-tools --bin mutate -- SECONDS
//! SEED FILE...`. A panic, or a read of more than ten seconds, ends it and leaves the input in `mutate-SEED.bin`. Prints the
//! number of executions. The stable compiler is enough for it.

use lineament_io::{ReadOptions, read_from};
use std::io::Cursor;
use std::time::{Duration, Instant};

/// Numbers that damaged files claim.
const LIES: [u64; 8] = [0, 1, 0x7f, 0xff, 1 << 31, 1 << 32, 1 << 63, u64::MAX];

/// A small generator of numbers (Steele, Lea and Flood 2014, SplitMix64).
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % bound.max(1) as u64) as usize
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [seconds, seed, files @ ..] = arguments.as_slice() else {
        return Err("expected SECONDS SEED FILE...".into());
    };
    let inputs: Vec<(String, Vec<u8>)> =
        files.iter().map(|file| Ok((file.clone(), std::fs::read(file)?))).collect::<std::io::Result<_>>()?;
    let mut random = Random(seed.parse()?);
    let (start, length) = (Instant::now(), Duration::from_secs(seconds.parse()?));
    let keep = format!("mutate-{seed}.bin");
    let (mut executions, mut whole) = (0u64, 0u64);
    while start.elapsed() < length && !inputs.is_empty() {
        let (name, bytes) = &inputs[random.below(inputs.len())];
        let mut bytes = bytes.clone();
        for _ in 0..=random.below(5) {
            damage(&mut bytes, &mut random);
        }
        let began = Instant::now();
        let options = ReadOptions { salvage: random.below(2) == 0, ..ReadOptions::default() };
        let (copy, name) = (bytes.clone(), name.clone());
        let read =
            std::panic::catch_unwind(move || read_from(Box::new(Cursor::new(copy)), &name, &options).is_ok());
        if read.is_err() || began.elapsed() > Duration::from_secs(10) {
            std::fs::write(&keep, bytes)?;
            return Err(format!("execution {executions}: see {keep}").into());
        }
        whole += u64::from(read.is_ok_and(|whole| whole));
        executions += 1;
    }
    println!("{executions} executions in {:.0} s, {whole} of them read", start.elapsed().as_secs_f64());
    Ok(())
}

/// One change: a bit, a byte, a number of four or eight bytes, a cut, a piece doubled, a digit.
fn damage(bytes: &mut Vec<u8>, random: &mut Random) {
    if bytes.is_empty() {
        return;
    }
    // Headers are where most harm is done.
    let reach = if random.below(2) == 0 { bytes.len() } else { bytes.len().min(600) };
    let at = random.below(reach);
    match random.below(8) {
        0 => bytes[at] ^= 1 << random.below(8),
        1 => bytes[at] = random.below(256) as u8,
        2 | 3 => {
            let width = if random.below(2) == 0 { 4 } else { 8 };
            let lie = LIES[random.below(LIES.len())].to_le_bytes();
            bytes.iter_mut().skip(at).zip(&lie[..width]).for_each(|(byte, new)| *byte = *new);
        }
        4 => bytes.truncate(at),
        5 => {
            let piece = bytes[at..(at + 1 + random.below(64)).min(bytes.len())].to_vec();
            let place = random.below(bytes.len());
            bytes.splice(place..place, piece);
        }
        6 => {
            let end = (at + 1 + random.below(16)).min(bytes.len());
            bytes.drain(at..end);
        }
        _ => {
            let digits: Vec<usize> = (0..reach).filter(|&i| bytes[i].is_ascii_digit()).collect();
            if !digits.is_empty() {
                let place = digits[random.below(digits.len())];
                let text = LIES[random.below(LIES.len())].to_string();
                bytes.splice(place..=place, text.into_bytes());
            }
        }
    }
}
