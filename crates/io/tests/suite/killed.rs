//! A program that is killed while it writes leaves the old file or the whole new one.
#![cfg(unix)]

use crate::common::example;
use std::process::{Command, Stdio};
use std::time::Instant;

#[test]
fn after_a_kill_the_old_file_stands_or_the_whole_new_one() {
    let Some(writer) = example("network") else { return };
    for extension in ["json", "gpkg", "ply"] {
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

#[test]
#[cfg(target_os = "linux")]
fn on_a_full_disk_the_old_file_stands() {
    let Some(writer) = example("network") else { return };
    // A disk of 256 KiB that no other process sees, and that is gone when the shell ends.
    let script = "mount -t tmpfs -o size=256k none \"$1\" || exit 77
        printf old > \"$1/$2\"; \"$0\" --points 20000 \"$1/$2\" 2>&1; echo \"; code $?; $(cat \"$1/$2\"); $(ls -A \"$1\")\"";
    for name in ["lines.json", "lines.obj", "lines.gpkg"] {
        let folder = tempfile::tempdir().unwrap();
        let run = Command::new("unshare")
            .args(["--user", "--map-root-user", "--mount", "sh", "-c", script])
            .args([writer.as_path(), folder.path()])
            .arg(name)
            .output();
        let Some(run) = run.ok().filter(|run| run.status.success()) else {
            return println!("skipped: no small disk can be mounted here");
        };
        let said = String::from_utf8(run.stdout).unwrap();
        assert!(said.contains("No space left") && said.contains(name), "{said}");
        assert!(said.trim_end().ends_with(&format!("; code 1; old; {name}")), "{said}");
    }
}
