//! COPC inputs, whole and by bounds.

use crate::common::copc::{ORIGIN, file};
use crate::common::from_bytes;
use lineament_io::{Format, ReadOptions, Scan};

fn bounded(bytes: &[u8], low: [f64; 3], high: [f64; 3]) -> Scan {
    let moved = |corner: [f64; 3]| std::array::from_fn(|a| ORIGIN[a] + corner[a]);
    let options = ReadOptions { bounds: Some([moved(low), moved(high)]), ..ReadOptions::default() };
    from_bytes(bytes, "a.copc.laz", &options).unwrap()
}

/// Whether an input is refused since no point lies inside the bounds.
fn refused(bytes: &[u8], low: [f64; 3], high: [f64; 3]) -> bool {
    let moved = |corner: [f64; 3]| std::array::from_fn(|a| ORIGIN[a] + corner[a]);
    let options = ReadOptions { bounds: Some([moved(low), moved(high)]), ..ReadOptions::default() };
    from_bytes(bytes, "a.copc.laz", &options).is_err_and(|e| e.to_string().contains("lies inside the bounds"))
}

#[test]
fn the_whole_file_has_all_points() {
    let scan = from_bytes(&file(4000), "a.copc.laz", &ReadOptions::default()).unwrap();
    assert_eq!(
        (scan.format, scan.cloud.len(), scan.ignored.len()),
        (Format::Las, 4000, 2),
        "{:?}",
        scan.ignored
    );
}

#[test]
fn bounds_give_the_points_that_the_whole_file_has_there_and_leave_nodes_unread() {
    let bytes = file(4000);
    let whole = from_bytes(&bytes, "a.copc.laz", &ReadOptions::default()).unwrap();
    for (low, high, fewer) in [
        ([0.0; 3], [0.2; 3], true),
        ([0.6, 0.6, 0.6], [0.9, 0.7, 0.9], true),
        ([0.4, 0.1, 0.1], [0.6, 0.2, 0.2], true),
        ([0.0; 3], [1.0; 3], false),
        ([0.503, 0.0, 0.0], [0.503, 1.0, 1.0], true),
        ([0.5, 0.5, 0.5], [0.5, 0.5, 0.5], false),
    ] {
        let inside =
            |p: &[f64; 3]| (0..3).all(|a| (ORIGIN[a] + low[a]..=ORIGIN[a] + high[a]).contains(&p[a]));
        let expected: Vec<_> = whole.cloud.positions.iter().copied().filter(inside).collect();
        if expected.is_empty() {
            assert!(refused(&bytes, low, high), "{low:?} {high:?}");
            continue;
        }
        let part = bounded(&bytes, low, high);
        assert_eq!(part.cloud.positions, expected, "{low:?} {high:?}");
        let unread = part.ignored.iter().any(|what| what.ends_with("points in nodes outside the bounds"));
        assert_eq!(unread, fewer, "{:?}", part.ignored);
    }
}

#[test]
fn bounds_beside_all_nodes_are_refused_with_the_points_passed_over() {
    let options = ReadOptions { bounds: Some([[-9e6; 3], [-8e6; 3]]), ..ReadOptions::default() };
    let message = from_bytes(&file(4000), "a.copc.laz", &options).unwrap_err().to_string();
    assert!(message.contains("no point lies inside the bounds"), "{message}");
    assert!(message.contains("4000 points in nodes outside the bounds"), "{message}");
}

#[test]
fn nodes_that_overlap_are_read_though_others_are_damaged() {
    let mut bytes = file(4000);
    let whole = bounded(&bytes, [0.6; 3], [1.0; 3]);
    // The first point of the first child, [1, 0, 0, 0]: its chunk is not touched for the opposite corner.
    let table = bytes.len() - 32 * 9 + 16 + 32;
    let start = u64::from_le_bytes(bytes[table..table + 8].try_into().unwrap()) as usize;
    bytes[start + 30..start + 60].fill(0xff);
    assert_eq!(bounded(&bytes, [0.6; 3], [1.0; 3]).cloud, whole.cloud);
    assert!(from_bytes(&bytes, "a.copc.laz", &ReadOptions::default()).is_err());
}

#[test]
fn a_damaged_octree_is_refused_and_ends() {
    let bytes = file(400);
    let root = bytes.len() - 32 * 9;
    let bounds = Some([[0.0; 3], [1e7; 3]]);
    let read = |bytes: &[u8]| {
        from_bytes(bytes, "a.copc.laz", &ReadOptions { bounds, ..ReadOptions::default() })
            .map(|s| s.cloud.len())
    };
    assert_eq!(read(&bytes).unwrap(), 400);
    let with = |at: usize, value: &[u8]| {
        let mut bytes = bytes.clone();
        bytes[at..at + value.len()].copy_from_slice(value);
        read(&bytes).unwrap_err().to_string()
    };
    // A page that leads to itself; a chunk beyond the end; more points than there are; a level that cannot be.
    let own =
        [(root as u64).to_le_bytes().as_slice(), &288i32.to_le_bytes(), &(-1i32).to_le_bytes()].concat();
    assert!(with(root + 16, &own).contains("octree"));
    assert!(with(root + 16, &u64::MAX.to_le_bytes()).contains("a node of"));
    assert!(with(root + 28, &i32::MAX.to_le_bytes()).contains("more than the 400 points"));
    assert!(with(root + 28, &(-2i32).to_le_bytes()).contains("a node of -2 points"));
    assert!(with(root, &99i32.to_le_bytes()).contains("level 99"));
}
