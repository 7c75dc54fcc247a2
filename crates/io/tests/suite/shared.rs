//! Files written by other people's programs, and files that broke other people's readers.

use crate::common::shared;
use lineament_io::{Format, ReadOptions, read};
use std::path::{Path, PathBuf};

/// The files of a folder of the evaluation data, and of its folders, in order.
fn files(folder: &str) -> Vec<PathBuf> {
    let Some(root) = shared(folder) else { return Vec::new() };
    let mut found: Vec<PathBuf> = Vec::new();
    for entry in std::fs::read_dir(root).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(std::fs::read_dir(&path).unwrap().map(|entry| entry.unwrap().path()));
        } else {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn has(path: &Path, extensions: &[&str]) -> bool {
    path.extension().is_some_and(|e| extensions.iter().any(|known| e == *known))
}

#[test]
fn every_cloud_of_the_evaluation_data_reads_whole() {
    for path in
        ["cad", "labelled", "scans"].iter().flat_map(|folder| files(folder)).filter(|p| has(p, &["ply"]))
    {
        let scan = read(&path, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        // Header, then 12 bytes a point: what plyfile and the scoring read.
        let header = scan.bytes as usize - scan.cloud.len() * 12;
        assert!(header < 400, "{}: {} points in {} bytes", path.display(), scan.cloud.len(), scan.bytes);
        assert!(scan.ignored.is_empty() && scan.cloud.positions.iter().flatten().all(|c| c.is_finite()));
    }
}

#[test]
fn files_of_other_programs_read_with_their_counts() {
    for (name, format, count, attributes) in [
        ("formats/b9_training.ply", Format::Ply, 22300, 4),
        ("formats/points_ascii.ply", Format::Ply, 5, 0),
        ("formats/points_bin.ply", Format::Ply, 8, 3),
        ("formats/points_cloudcompare.xyz", Format::Table, 101, 4),
        ("formats/fin90_with_PCA_normals.xyz", Format::Table, 757, 3),
        ("formats/oni.pwn", Format::Table, 1435, 3),
        ("models/brain.ply", Format::Ply, 18844, 0),
        ("models/cow.obj", Format::Obj, 2903, 0),
        ("models/fandisk.obj", Format::Obj, 6475, 0),
        ("models/rocker-arm.obj", Format::Obj, 10044, 0),
        ("malformed/assimp-malformed.obj", Format::Obj, 8, 0),
        ("malformed/assimp-malformed2.obj", Format::Obj, 8, 0),
    ] {
        let Some(path) = shared(name) else { continue };
        let scan = read(&path, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!((scan.format, scan.cloud.len()), (format, count), "{name}");
        assert_eq!(scan.cloud.attributes.len(), attributes, "{name}: {:?}", scan.ignored);
    }
}

#[test]
fn broken_files_are_refused_by_name_and_place() {
    for path in
        files("malformed").iter().filter(|path| !path.display().to_string().contains("assimp-malformed"))
    {
        // One of them is only odd: its chunk table is damaged where nothing is read.
        let Err(error) = read(path, &ReadOptions::default()) else {
            assert!(path.ends_with("laz-11.laz"), "{}", path.display());
            continue;
        };
        let message = error.to_string();
        assert!(message.contains(&path.display().to_string()) && message.len() < 600, "{message}");
    }
}
