//! Packed pages whose decoder would unpack on beyond the size that the page states: Gzip, Brotli, and LZ4 in frames. The
//! others (Snappy, Zstandard, plain LZ4) unpack into a buffer of that size.

use super::page::Page;
use crate::source::Shared;
use ::parquet::basic::Compression;
use flate2::read::MultiGzDecoder;
use std::io::{self, BufReader, Read};

/// First bytes of frames of LZ4, current and legacy. LZ4 in this format has none by its rules, but old writers made some.
const FRAMES: [&[u8]; 2] = [b"\x04\x22\x4d\x18", b"\x02\x21\x4c\x18"];
/// Bytes that are unpacked at a time.
const STEP: usize = 1 << 12;

/// Whether a page, whose bytes stand at `at`, unpacks to no more than it states.
pub(super) fn ends_in_time(shared: &Shared, codec: Compression, page: &Page, at: u64) -> io::Result<bool> {
    let levels = page.levels.iter().try_fold(0i64, |sum, &level| sum.checked_add(level.max(0)));
    let Some(levels) = levels.filter(|&levels| levels <= page.packed.min(page.unpacked)) else {
        return Ok(false);
    };
    let [packed, unpacked] = [page.packed, page.unpacked].map(|size| (size - levels) as u64);
    if page.plain || unpacked == 0 {
        return Ok(true);
    }
    let bytes = shared.window(at + levels as u64, packed);
    Ok(match codec {
        Compression::GZIP(_) => fits(MultiGzDecoder::new(bytes), unpacked),
        Compression::BROTLI(_) => fits(brotli::Decompressor::new(bytes, STEP), unpacked),
        Compression::LZ4 => {
            let mut start = Vec::new();
            bytes.take(4).read_to_end(&mut start)?;
            !FRAMES.contains(&start.as_slice())
        }
        _ => true,
    })
}

/// Whether a stream has exactly so many bytes.
fn fits(stream: impl Read, bytes: u64) -> bool {
    let mut stream = BufReader::with_capacity(STEP, stream).take(bytes.saturating_add(1));
    io::copy(&mut stream, &mut io::sink()).is_ok_and(|read| read == bytes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::{Compression as Level, write::GzEncoder};
    use std::io::{Cursor, Write};

    fn check(codec: Compression, packed: &[u8], unpacked: i64, levels: i64) -> bool {
        let shared = Shared::new(Box::new(Cursor::new(packed.to_vec()))).unwrap();
        let packed = packed.len() as i64;
        let page = Page { unpacked, packed, levels: [levels, 0], ..Page::default() };
        ends_in_time(&shared, codec, &page, 0).unwrap()
    }

    #[test]
    fn a_stream_that_goes_on_beyond_its_size_or_ends_before_is_noticed() {
        let mut gzip = GzEncoder::new(b"lv".to_vec(), Level::best());
        gzip.write_all(&[0; 1000]).unwrap();
        let gzip = gzip.finish().unwrap();
        let mut brotli = b"lv".to_vec();
        brotli::CompressorWriter::new(&mut brotli, STEP, 5, 20).write_all(&[0; 1000]).unwrap();
        for (codec, bytes) in
            [(Compression::GZIP(Default::default()), gzip), (Compression::BROTLI(Default::default()), brotli)]
        {
            assert!(check(codec, &bytes, 1002, 2), "{codec}");
            for wrong in [1001, 1003, 2_000_000] {
                assert!(!check(codec, &bytes, wrong, 2), "{codec} {wrong}");
            }
            assert!(!check(codec, &bytes[..bytes.len() - 9], 1002, 2), "{codec}");
            assert!(!check(codec, &bytes, 1002, i64::MAX), "{codec}");
        }
        assert!(!check(Compression::LZ4, &[FRAMES[0], &[0; 20]].concat(), 100, 0));
        assert!(check(Compression::LZ4, &[0, 0, 0, 100, 0, 0, 0, 12], 100, 0));
    }
}
