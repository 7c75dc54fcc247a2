//! Never a silent part: rows beyond those that are announced, a file that becomes shorter while it is read, a last number that
//! may be cut.

use crate::common::from_bytes;
use lineament_io::{Format, ReadOptions, Scan};

fn scan(text: &str, name: &str) -> Result<Scan, String> {
    from_bytes(text.as_bytes(), name, &ReadOptions::default()).map_err(|error| error.to_string())
}

fn ply(elements: &str, rows: &str) -> String {
    let vertex = "property float x\nproperty float y\nproperty float z\n";
    format!("ply\nformat ascii 1.0\n{}end_header\n{rows}", elements.replace("XYZ\n", vertex))
}

#[test]
fn rows_beyond_those_announced_are_refused() {
    let elements = "element vertex 2\nXYZ\nelement face 1\nproperty list uchar int vertex_indices\n";
    assert_eq!(scan(&ply(elements, "0 0 0\n1 0 0\n3 0 1 1\n\n"), "whole.ply").unwrap().cloud.len(), 2);
    let message = scan(&ply(elements, "0 0 0\n1 0 0\n3 0 1 1\n3 0 1 1\n"), "more.ply").unwrap_err();
    assert!(message.contains("line 13: more rows than the 2 vertex and 1 face of the header"), "{message}");
    for text in ["OFF\n2 1 0\n0 0 0\n1 0 0\n3 0 1 0\n3 0 1 1\n", "OFF\n2 0 0\n0 0 0\n1 0 0\n2 0 0\n"] {
        let message = scan(text, "more.off").unwrap_err();
        assert!(message.contains("more rows than the 2 vertices"), "{message}");
    }
    let running = "OFF 4 1 0\n0 0\n0 1 0 0\n0 1 0 0 0 1\n3 0 1 2 3 0 1 3\n";
    assert!(scan(running, "running.off").unwrap().warnings[0].contains("more than the 1 faces"));
}

#[test]
fn bytes_for_more_rows_than_announced_are_a_warning() {
    let header = "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    let binary = |bytes: usize| [header.as_bytes(), &vec![0; bytes]].concat();
    let warnings = |bytes| from_bytes(&binary(bytes), "more.ply", &ReadOptions::default()).unwrap().warnings;
    assert!(warnings(24).is_empty() && warnings(25).is_empty());
    assert!(warnings(48)[0].contains("24 bytes after the last element"));
}

#[test]
fn a_second_element_of_points_is_refused() {
    let message = scan(&ply("element vertex 1\nXYZ\nelement vertex 1\nXYZ\n", "0 0 0\n1 1 1\n"), "two.ply")
        .unwrap_err();
    assert!(message.contains("more than one element `vertex`"), "{message}");
}

#[test]
fn a_last_line_without_an_end_is_a_warning_where_a_cut_cannot_be_told() {
    let pcd = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n0 0 0\n1 2 3.25";
    let vertices = ply("element vertex 2\nXYZ\n", "0 0 0\n1 2 3.25");
    let off = "OFF\n2 0 0\n0 0 0\n1 2 3.25";
    for (text, name) in
        [(pcd, "a.pcd"), (&vertices, "a.ply"), (off, "a.off"), ("2\n0 0 0\n1 2 3.25", "a.pts")]
    {
        let cut = scan(text, name).unwrap();
        assert_eq!(cut.warnings.len(), 1, "{name}: {:?}", cut.warnings);
        assert!(cut.warnings[0].contains("the last line has no end"), "{name}: {:?}", cut.warnings);
        assert!(scan(&format!("{text}\n"), name).unwrap().warnings.is_empty(), "{name}");
    }
}

/// Whether this process has read some of a file through an open handle.
#[cfg(target_os = "linux")]
fn begun(path: &std::path::Path) -> bool {
    let handles = std::fs::read_dir("/proc/self/fd").into_iter().flatten().flatten();
    let mut open = handles.filter(|handle| std::fs::read_link(handle.path()).is_ok_and(|to| to == path));
    open.any(|handle| {
        let info = std::path::Path::new("/proc/self/fdinfo").join(handle.file_name());
        std::fs::read_to_string(info).is_ok_and(|text| !text.starts_with("pos:\t0\n"))
    })
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_that_becomes_shorter_while_it_is_read_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("shrinks.xyz");
    let row = "1.5 2.5 3.5\n";
    let shrinks = || {
        std::fs::write(&path, row.repeat(4_000_000)).unwrap();
        let shorter = std::fs::OpenOptions::new().write(true).open(&path).unwrap();
        let reading = std::thread::spawn({
            let path = path.clone();
            move || lineament_io::read(&path, &ReadOptions::default())
        });
        while !begun(&path) && !reading.is_finished() {
            std::thread::yield_now();
        }
        shorter.set_len(12 * 3_000_000).unwrap();
        reading.join().unwrap()
    };
    // The reader may have been at the end when the file became shorter.
    for _ in 0..10 {
        match shrinks() {
            Err(error) => {
                assert!(error.to_string().contains("36000000 of 48000000 bytes"), "{error}");
                return;
            }
            Ok(scan) => assert!([3_000_000, 4_000_000].contains(&scan.cloud.len()), "{}", scan.cloud.len()),
        }
    }
    panic!("the file was read whole ten times");
}

#[test]
fn salvage_reads_on_behind_a_block_whose_count_is_short() {
    let text = "3\n1 2 3 4\n5 6 7 8\n2\n9 1 2 3\n4 5 6 7\n";
    assert!(
        scan(text, "short.pts").unwrap_err().contains("a new count line after 2 rows where 3 were announced")
    );
    let options = ReadOptions { salvage: true, ..Default::default() };
    let salvaged = from_bytes(text.as_bytes(), "short.pts", &options).unwrap();
    assert_eq!((salvaged.format, salvaged.cloud.len()), (Format::Table, 4));
    assert_eq!(salvaged.missing.unwrap().to_string(), "4 of 5 rows read, 1 missing");
}

#[test]
fn what_is_asked_of_an_input_that_it_cannot_give_is_refused() {
    let text = "0 0 0\n1 0 0\n0 1 0\n10000000 5 5\n";
    let refusal =
        |options: ReadOptions| from_bytes(text.as_bytes(), "a.xyz", &options).unwrap_err().to_string();
    let none = ReadOptions::default;
    let message = refusal(ReadOptions { scan: Some(2), ..none() });
    assert!(message.contains("table holds no scans"), "{message}");
    let message = refusal(ReadOptions { bounds: Some([[50.0; 3], [60.0; 3]]), ..none() });
    assert!(message.contains("none of 4 points") && message.contains("[10000000.0, 5.0, 5.0]"), "{message}");
    let message = refusal(ReadOptions { voxel: Some(1e-12), ..none() });
    assert!(message.contains("finer than coordinates of 10000000.0"), "{message}");
}
