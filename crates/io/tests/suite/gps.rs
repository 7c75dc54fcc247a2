//! GPS times of LAZ: those of several sequences come back, and those that change their sequence without end are refused.

use crate::common::gps::{layered, place, pointwise, with_times};
use crate::common::las::{file_of, length};
use crate::common::{example, from_bytes};
use lineament::{Attribute, Column};
use lineament_io::{ReadOptions, read_from};
use std::io::Cursor;
use std::process::Command;

/// A damaged file of three kilobytes. In a process of its own, since a full stack ends the process.
#[test]
fn changes_of_sequence_without_end_are_refused() {
    let Some(reader) = example("positions") else { return };
    let folder = tempfile::tempdir().unwrap();
    // The model learns that sequences change, so that a change comes to take next to no bits.
    let rising = std::iter::successors(Some(500usize), |count| Some(count * 9 / 8)).take(50).collect();
    for (name, bytes) in [("layered.laz", layered(1_000_000)), ("pointwise.laz", pointwise(rising))] {
        assert!(bytes.len() < 4000, "{}", bytes.len());
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        let run = Command::new(&reader).arg(&path).output().unwrap();
        let message = String::from_utf8_lossy(&run.stderr);
        assert_eq!(run.status.code(), Some(1), "{name}: {:?}, {message}", run.status);
        assert!(message.contains(name) && message.contains("change their sequence without end"), "{message}");
    }
}

/// A packer changes once; a change round to the sequence that it came from is sound too, if odd.
#[test]
fn some_changes_in_a_row_are_read() {
    for changes in 0..=4 {
        let scan = from_bytes(&layered(changes), "some.laz", &ReadOptions::default()).unwrap();
        let Column::F64(times) = column(&scan.cloud.attributes, "gps_time") else { panic!("times") };
        // The bits of a sequence that was not used before begin at zero.
        let first = if changes % 4 == 0 { 3e5f64.to_bits() } else { 0 };
        assert!((1..200).all(|i| times[i].to_bits() == first + i as u64), "{changes}: {times:?}");
    }
    for changes in [5, 6, 50] {
        let error = from_bytes(&layered(changes), "more.laz", &ReadOptions::default()).unwrap_err();
        assert!(error.to_string().contains("change their sequence"), "{error}");
    }
}

/// A wrong value for each byte of the packed points.
#[test]
fn any_change_of_a_byte_is_read_or_refused() {
    let (mut read, mut refused) = (0, 0);
    let packed = |format| file_of(format, with_times(format, &times(40)), Some(30), None);
    for file in [packed(1), packed(6), packed(7), layered(4), pointwise(vec![0, 4, 1, 2, 0, 3])] {
        let points_at = u32::from_le_bytes(file[96..100].try_into().unwrap()) as usize;
        for at in points_at..file.len() {
            let mut changed = file.clone();
            changed[at] ^= [0x01, 0x80, 0xff][at % 3];
            match read_from(Box::new(Cursor::new(changed)), "changed.laz", &ReadOptions::default()) {
                Ok(scan) => {
                    assert!(scan.cloud.attributes.iter().all(|a| a.values.len() == scan.cloud.len()));
                    read += 1;
                }
                Err(error) => {
                    assert!(error.to_string().contains("byte "), "{error}");
                    refused += 1;
                }
            }
        }
    }
    assert!(read > 300 && refused > 300, "{read} read, {refused} refused");
}

/// Numbers that look random.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) % limit
    }
}

/// Times of several sequences with steps of all sizes: each code of the packer occurs.
fn times(count: usize) -> Vec<f64> {
    let mut random = Random(7);
    let mut clocks = [3e5, 3.5e5, -20.0, 1e-3, 9e15, 0.0];
    let (mut clock, mut pace) = (0, 1e-5);
    let mut all = Vec::new();
    while all.len() < count {
        if random.below(20) == 0 {
            clock = random.below(6) as usize;
        }
        if random.below(50) == 0 {
            pace = [0.0, 1e-9, 1e-5, -1e-4, 0.25][random.below(5) as usize];
        }
        let factor = [0.0, 1.0, 1.0, 1.0, 2.0, 7.0, 40.0, 499.0, 700.0, -3.0, -10.0, -11.0, 1e4];
        clocks[clock] += pace * factor[random.below(13) as usize];
        for _ in 0..=random.below(3) {
            all.push(clocks[clock]);
        }
    }
    all.truncate(count);
    all
}

/// Records all of whose bytes vary, some of them seldom.
fn varied(format: u8, count: usize) -> Vec<u8> {
    let mut records = with_times(format, &times(count));
    let mut random = Random(11);
    let (mut angle, mut source, mut channel) = (0i16, 7u16, 0);
    for record in records.chunks_exact_mut(length(format)) {
        for axis in 0..3 {
            let far = if random.below(30) == 0 { 1 << 31 } else { 1 << random.below(12) };
            let step = (random.below(far) as i32).wrapping_sub((far / 2) as i32);
            let old = i32::from_le_bytes(record[4 * axis..4 * axis + 4].try_into().unwrap());
            record[4 * axis..4 * axis + 4].copy_from_slice(&old.wrapping_add(step).to_le_bytes());
        }
        record[12..14].copy_from_slice(&(random.below(4000) as u16).to_le_bytes());
        if random.below(3) == 0 {
            channel = random.below(4) as u8;
            angle = angle.wrapping_add(random.below(200) as i16 - 100);
            source = source.wrapping_add(random.below(3) as u16);
        }
        record[14] = random.below(256) as u8;
        if format >= 6 {
            record[15] = (random.below(256) as u8) & 0b1100_1111 | channel << 4;
            record[16] = [2, 2, 2, 6, 40, 255][random.below(6) as usize];
            record[17] = random.below(3) as u8 * 100;
            record[18..20].copy_from_slice(&angle.to_le_bytes());
            record[20..22].copy_from_slice(&source.to_le_bytes());
        }
    }
    records
}

fn column<'a>(attributes: &'a [Attribute], name: &str) -> &'a Column {
    &attributes.iter().find(|a| a.name == name).unwrap().values
}

/// The same records packed by `laz` and as they are give the same clouds, of every point format with times.
#[test]
fn records_of_all_kinds_come_back() {
    let cases = [
        (1, None),
        (3, None),
        (4, None),
        (6, None),
        (7, None),
        (8, None),
        (10, None),
        (6, Some(4)),
        (7, Some(4)),
    ];
    for (format, version) in cases {
        let records = varied(format, 4000);
        let plain = file_of(format, records.clone(), None, None);
        let packed = file_of(format, records.clone(), Some(1500), version);
        let options = ReadOptions::default();
        let plain = from_bytes(&plain, "plain.las", &options).unwrap().cloud;
        let packed = from_bytes(&packed, "packed.laz", &options).unwrap().cloud;
        assert_eq!(plain.positions, packed.positions, "{format} {version:?}");
        for attribute in &plain.attributes {
            let other = column(&packed.attributes, &attribute.name);
            assert!(attribute.values == *other, "{format} {version:?}: {}", attribute.name);
        }
        let Column::F64(found) = column(&packed.attributes, "gps_time") else { panic!("times") };
        let wanted = records
            .chunks_exact(length(format))
            .map(|record| f64::from_le_bytes(record[place(format)..place(format) + 8].try_into().unwrap()));
        assert!(wanted.eq(found.iter().copied()), "{format} {version:?}");
    }
}
