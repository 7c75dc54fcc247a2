//! LAS and LAZ files of every point format.

use laz::laszip::{LazItemRecordBuilder, LazVlr, compress_buffer};
use std::io::Cursor;

const LENGTHS: [usize; 11] = [20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67];
const EXTRA: usize = 5;

/// Records that vary as scans do: a walk in the plane, with other fields that repeat.
pub fn records(format: u8, count: usize) -> Vec<u8> {
    let length = length(format);
    let mut bytes = vec![0u8; length * count];
    for (i, row) in bytes.chunks_exact_mut(length).enumerate() {
        let point = [i as i32 * 7 - 100, (i as i32 % 13) * -5, i as i32 % 3];
        for (axis, value) in point.into_iter().enumerate() {
            row[4 * axis..4 * axis + 4].copy_from_slice(&value.to_le_bytes());
        }
        row[12..14].copy_from_slice(&(i as u16 % 500).to_le_bytes());
        row[14] = if format < 6 { 0b01_010_001 } else { 0b0011_0010 };
        row[if format < 6 { 15 } else { 16 }] = 6;
        let end = row.len();
        row[end - EXTRA..end - 1].copy_from_slice(&(i as f32).to_le_bytes());
        row[end - 1] = 10;
    }
    bytes
}

/// Overwrites bytes.
pub fn put(bytes: &mut [u8], at: usize, value: &[u8]) {
    bytes[at..at + value.len()].copy_from_slice(value);
}

/// A variable length record.
pub fn vlr(user: &str, id: u16, data: &[u8]) -> Vec<u8> {
    let mut bytes = vec![0; 54];
    put(&mut bytes, 2, user.as_bytes());
    put(&mut bytes, 18, &id.to_le_bytes());
    put(&mut bytes, 20, &(data.len() as u16).to_le_bytes());
    bytes.extend(data);
    bytes
}

/// Descriptions of a float called `amplitude` and of a byte called `reflectance`, which counts halves from 1.
fn extra_bytes() -> Vec<u8> {
    let mut data = vec![0; 384];
    data[2] = 9;
    put(&mut data, 4, b"amplitude");
    (data[192 + 2], data[192 + 3]) = (1, 0b1_1000);
    put(&mut data, 192 + 4, b"reflectance");
    put(&mut data, 192 + 112, &0.5f64.to_le_bytes());
    put(&mut data, 192 + 136, &1f64.to_le_bytes());
    vlr("LASF_Spec", 4, &data)
}

/// Bytes of a record.
pub fn length(format: u8) -> usize {
    LENGTHS[usize::from(format)] + EXTRA
}

/// A file of a point format with `count` points and extra bytes, packed in chunks if `chunk` says so.
pub fn file(format: u8, count: usize, chunk: Option<u32>) -> Vec<u8> {
    file_of(format, records(format, count), chunk, None)
}

/// A file of these records, packed with items of another `version` if there is one.
pub fn file_of(format: u8, mut records: Vec<u8>, chunk: Option<u32>, version: Option<u8>) -> Vec<u8> {
    let header_size = if format < 6 { 227 } else { 375 };
    let length = length(format);
    let count = records.len() / length;
    let mut vlrs =
        vec![extra_bytes(), vlr("LASF_Projection", 2112, b"PROJCS[\"ETRS89 / UTM zone 32N\",GEOGCS[]]\0")];
    let packed = chunk.map(|chunk| {
        let items = LazItemRecordBuilder::default_for_point_format_id(format, EXTRA as u16).unwrap();
        let laz = laz::LazVlrBuilder::new(items).with_fixed_chunk_size(chunk).build();
        let mut data = Vec::new();
        laz.write_to(&mut data).unwrap();
        let laz = version.map_or(laz, |version| {
            data[34..].chunks_exact_mut(6).for_each(|item| item[4] = version);
            LazVlr::from_buffer(&data).unwrap()
        });
        vlrs.push(vlr(LazVlr::USER_ID, LazVlr::RECORD_ID, &data));
        laz
    });
    let mut bytes = vec![0u8; header_size];
    put(&mut bytes, 0, b"LASF");
    (bytes[24], bytes[25]) = (1, if format < 6 { 2 } else { 4 });
    put(&mut bytes, 94, &(header_size as u16).to_le_bytes());
    let points_at = header_size + vlrs.iter().map(Vec::len).sum::<usize>();
    put(&mut bytes, 96, &(points_at as u32).to_le_bytes());
    put(&mut bytes, 100, &(vlrs.len() as u32).to_le_bytes());
    bytes[104] = format | if packed.is_some() { 0x80 } else { 0 };
    put(&mut bytes, 105, &(length as u16).to_le_bytes());
    if format < 6 {
        put(&mut bytes, 107, &(count as u32).to_le_bytes())
    } else {
        put(&mut bytes, 247, &(count as u64).to_le_bytes())
    }
    for (axis, (scale, offset)) in
        [(0.001, 500_000.0), (0.001, 5_000_000.0), (0.01, -100.0)].into_iter().enumerate()
    {
        put(&mut bytes, 131 + 8 * axis, &f64::to_le_bytes(scale));
        put(&mut bytes, 155 + 8 * axis, &f64::to_le_bytes(offset));
    }
    bytes.extend(vlrs.concat());
    match packed {
        None => bytes.append(&mut records),
        Some(laz) => {
            let mut out = Cursor::new(bytes);
            out.set_position(points_at as u64);
            compress_buffer(&mut out, &records, laz).unwrap();
            bytes = out.into_inner();
        }
    }
    bytes
}
