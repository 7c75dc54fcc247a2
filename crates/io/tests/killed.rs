//! A program that is killed while it writes leaves the old file or the whole new one.
#![cfg(unix)]

mod common;
use common::example;
use std::process::{Command, Stdio};
use std::time::Instant;

#[test]
fn after_a_kill_the_old_file_stands_or_the_whole_new_one() {
    let Some(writer) = example("network") else { return };
    for extension in ["json", "obj", "ply"] {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join(format!("lines.{extension}"));
        let start = Instant::now();
        assert!(Command::new(&writer).args(["--points", "20000"]).arg(&target).status().unwrap().success());
        // Instants from the start of a run to well after its end.
        let step = start.elapsed() / 70;
        let whole = std::fs::read(&target).unwrap();
        let mut killed = 0;
        for round in 0..100u32 {
            std::fs::write(&target, "old").unwrap();
            let mut child = Command::new(&writer)
                .args(["--points", "20000"])
                .arg(&target)
                .stderr(Stdio::null())
                .spawn()
                .unwrap();
            std::thread::sleep(step * (round * 37 % 100));
            let _ = child.kill();
            killed += u32::from(!child.wait().unwrap().success());
            let there = std::fs::read(&target).unwrap();
            assert!(there == b"old" || there == whole, "{} bytes of {}", there.len(), whole.len());
        }
        println!("{extension}: killed {killed} times of 100");
    }
}
