//! ZIP archives with right checksums: else nothing behind them would be tried.

use flate2::read::DeflateDecoder;
use std::io::Read;

/// First bytes of an entry of the directory, and its bytes without name and extra fields.
const CENTRAL: &[u8] = b"PK\x01\x02";
const CENTRAL_BYTES: usize = 46;
/// Bytes that are unpacked at most.
const MOST: u64 = 1 << 24;

/// The input with the checksum in every entry of a directory that its content has.
pub fn with_entry_checksums(data: &[u8]) -> Vec<u8> {
    let mut data = data.to_vec();
    let mut at = 0;
    while let Some(next) = data[at..].windows(4).position(|four| four == CENTRAL) {
        at += next;
        if let Some(sum) = checksum(&data, at) {
            data[at + 16..at + 20].copy_from_slice(&sum.to_le_bytes());
        }
        at += CENTRAL.len();
    }
    data
}

/// The CRC-32 of the content of the entry whose record stands at `at`.
fn checksum(data: &[u8], at: usize) -> Option<u32> {
    let record = data.get(at..at + CENTRAL_BYTES)?;
    let [name, extra] = [28, 30].map(|place| short(record, place));
    let start = at + CENTRAL_BYTES + name;
    let [unpacked, packed, place] = sizes(record, data.get(start..start + extra)?);
    let place = usize::try_from(place).ok()?;
    let head = data.get(place..place.checked_add(30)?)?;
    let content = place + 30 + short(head, 26) + short(head, 28);
    let content = data.get(content..content.checked_add(usize::try_from(packed).ok()?)?)?;
    let reader: Box<dyn Read> = match short(record, 10) {
        8 => Box::new(DeflateDecoder::new(content)),
        _ => Box::new(content),
    };
    let mut bytes = Vec::new();
    // An entry that cannot be unpacked whole gets the sum of its readable part: no reader gets beyond that.
    let _ = reader.take(unpacked.min(MOST)).read_to_end(&mut bytes);
    Some(crc32fast::hash(&bytes))
}

/// Bytes unpacked and packed, and where the entry begins; of 64 bits in the extra fields where 32 do not do.
fn sizes(record: &[u8], mut extra: &[u8]) -> [u64; 3] {
    let mut sizes = [24, 20, 42].map(|place| u64::from(word(record, place)));
    while extra.len() >= 4 {
        let end = (4 + short(extra, 2)).min(extra.len());
        if short(extra, 0) == 1 {
            let mut wide = extra[4..end].chunks_exact(8);
            for size in sizes.iter_mut().filter(|size| **size == u64::from(u32::MAX)) {
                let eight = wide.next().and_then(|eight| eight.first_chunk());
                *size = eight.map_or(*size, |eight| u64::from_le_bytes(*eight));
            }
        }
        extra = &extra[end..];
    }
    sizes
}

fn short(bytes: &[u8], at: usize) -> usize {
    usize::from(u16::from_le_bytes([bytes[at], bytes[at + 1]]))
}

fn word(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]])
}
