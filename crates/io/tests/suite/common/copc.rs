//! A COPC file: an octree of two levels whose last node stands on a page of its own.

use super::las::{put, vlr};
use laz::LazVlrBuilder;
use laz::laszip::{LasZipCompressor, LazItemRecordBuilder, LazVlr};
use std::io::{Cursor, Seek};

/// Bytes of the header and of a record of point format 6.
const HEADER: usize = 375;
const RECORD: usize = 30;
/// The cube of the root in stored integers, of a thousandth each.
const SIZE: i32 = 1000;
/// Where the stored integer 0 lies.
pub const ORIGIN: [f64; 3] = [500_000.0, 5_000_000.0, 100.0];

/// Stored coordinates of point `i`, all over the cube.
fn point(i: usize) -> [i32; 3] {
    [7919, 104_729, 1_299_709].map(|prime| ((i * prime + prime / 3) % (SIZE as usize + 1)) as i32)
}

/// The node of a point: every fourth is the root's, the others go by the half they lie in.
fn node(i: usize) -> [i32; 4] {
    let [x, y, z] = point(i).map(|c| i32::from(c > SIZE / 2));
    if i.is_multiple_of(4) { [0, 0, 0, 0] } else { [1, x, y, z] }
}

fn record(i: usize) -> [u8; RECORD] {
    let mut row = [0; RECORD];
    point(i).iter().enumerate().for_each(|(axis, c)| put(&mut row, 4 * axis, &c.to_le_bytes()));
    put(&mut row, 12, &(i as u16).to_le_bytes());
    row[14] = 0x11;
    row
}

fn entry(node: [i32; 4], offset: u64, bytes: i32, points: i32) -> Vec<u8> {
    let key = node.iter().flat_map(|k| k.to_le_bytes());
    key.chain(offset.to_le_bytes()).chain(bytes.to_le_bytes()).chain(points.to_le_bytes()).collect()
}

/// A file with `count` points whose intensities are their numbers.
pub fn file(count: usize) -> Vec<u8> {
    let items = LazItemRecordBuilder::default_for_point_format_id(6, 0).unwrap();
    let laz = LazVlrBuilder::new(items).with_variable_chunk_size().build();
    let mut packing = Vec::new();
    laz.write_to(&mut packing).unwrap();
    let laz_record = vlr(LazVlr::USER_ID, LazVlr::RECORD_ID, &packing);
    let points_at = HEADER + 54 + 160 + laz_record.len();
    let mut out = Cursor::new(vec![0u8; points_at]);
    out.set_position(points_at as u64);
    let mut nodes: Vec<[i32; 4]> = (0..count).map(node).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let mut entries = Vec::new();
    let mut compressor = LasZipCompressor::new(&mut out, laz).unwrap();
    compressor.reserve_offset_to_chunk_table().unwrap();
    for (index, &key) in nodes.iter().enumerate() {
        let mine: Vec<usize> = (0..count).filter(|&i| node(i) == key).collect();
        let start = compressor.get_mut().stream_position().unwrap();
        mine.iter().for_each(|&i| compressor.compress_one(&record(i)).unwrap());
        let last = index + 1 == nodes.len();
        if last {
            compressor.done().unwrap()
        } else {
            compressor.finish_current_chunk().unwrap()
        }
        // What follows the last chunk is the chunk table, which no decoder of the chunk looks at.
        let bytes = compressor.get_mut().stream_position().unwrap() - start;
        entries.push(entry(key, start, bytes as i32, mine.len() as i32));
    }
    drop(compressor);
    let mut bytes = out.into_inner();
    let own_page = (bytes.len() + 60) as u64;
    let page = entries.pop().unwrap();
    entries.push(entry(nodes[nodes.len() - 1], own_page, page.len() as i32, -1));
    let root_page = own_page + page.len() as u64;
    bytes.extend(evlr("copc", 1000, &[page, entries.concat()].concat()));
    let info = info(root_page, 32 * entries.len() as u64);
    let records = [vlr("copc", 1, &info), laz_record].concat();
    header(&mut bytes, count, points_at, own_page - 60);
    put(&mut bytes, HEADER, &records);
    bytes
}

fn evlr(user: &str, id: u16, data: &[u8]) -> Vec<u8> {
    let mut bytes = vec![0; 60];
    put(&mut bytes, 2, user.as_bytes());
    put(&mut bytes, 18, &id.to_le_bytes());
    put(&mut bytes, 20, &(data.len() as u64).to_le_bytes());
    bytes.extend(data);
    bytes
}

fn info(page: u64, length: u64) -> [u8; 160] {
    let half = f64::from(SIZE) / 2000.0;
    let mut info = [0; 160];
    ORIGIN.iter().enumerate().for_each(|(axis, c)| put(&mut info, 8 * axis, &(c + half).to_le_bytes()));
    put(&mut info, 24, &half.to_le_bytes());
    put(&mut info, 40, &page.to_le_bytes());
    put(&mut info, 48, &length.to_le_bytes());
    info
}

fn header(bytes: &mut [u8], count: usize, points_at: usize, evlrs_at: u64) {
    put(bytes, 0, b"LASF");
    (bytes[24], bytes[25], bytes[104]) = (1, 4, 0x86);
    put(bytes, 94, &(HEADER as u16).to_le_bytes());
    put(bytes, 96, &(points_at as u32).to_le_bytes());
    put(bytes, 100, &2u32.to_le_bytes());
    put(bytes, 105, &(RECORD as u16).to_le_bytes());
    for (axis, origin) in ORIGIN.into_iter().enumerate() {
        put(bytes, 131 + 8 * axis, &0.001f64.to_le_bytes());
        put(bytes, 155 + 8 * axis, &origin.to_le_bytes());
        put(bytes, 187 + 16 * axis, &origin.to_le_bytes());
        put(bytes, 179 + 16 * axis, &(origin + f64::from(SIZE) * 0.001).to_le_bytes());
    }
    put(bytes, 235, &evlrs_at.to_le_bytes());
    put(bytes, 243, &1u32.to_le_bytes());
    put(bytes, 247, &(count as u64).to_le_bytes());
}
