//! Outputs appear whole or not at all, and never over an input.

use lineament_io::{Error, Output, check_output};
use std::io::Write;
use std::path::{Path, PathBuf};

fn entries(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn nothing_stands_at_the_target_before_it_is_finished() {
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("lines \u{e9}.json");
    let mut output = Output::create(&target, &[]).unwrap();
    output.write_all(b"whole").unwrap();
    output.flush().unwrap();
    assert!(!target.exists());
    output.finish().unwrap();
    assert_eq!(std::fs::read(&target).unwrap(), b"whole");
    assert_eq!(entries(folder.path()).len(), 1);
}

#[test]
fn an_unfinished_output_leaves_the_old_file_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("lines.json");
    std::fs::write(&target, "old").unwrap();
    let mut output = Output::create(&target, &[]).unwrap();
    output.write_all(b"new").unwrap();
    drop(output);
    assert_eq!(std::fs::read(&target).unwrap(), b"old");
    assert_eq!(entries(folder.path()), ["lines.json"]);
}

#[test]
fn an_output_that_is_an_input_by_any_path_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("scan.ply");
    std::fs::write(&input, "points").unwrap();
    std::fs::create_dir(folder.path().join("sub")).unwrap();
    let mut others = vec![input.clone(), folder.path().join("sub/../scan.ply")];
    #[cfg(unix)]
    {
        let (hard, soft) = (folder.path().join("hard.ply"), folder.path().join("soft.ply"));
        std::fs::hard_link(&input, &hard).unwrap();
        std::os::unix::fs::symlink(&input, &soft).unwrap();
        others.extend([hard, soft]);
    }
    for other in others {
        let error = Output::create(&other, std::slice::from_ref(&input)).unwrap_err();
        assert!(matches!(error, Error::OutputIsInput { .. }), "{error}");
    }
    assert_eq!(std::fs::read(&input).unwrap(), b"points");
}

#[test]
fn a_missing_folder_is_named() {
    let error = check_output(Path::new("there/is/none/out.json"), &[]).unwrap_err();
    assert!(error.to_string().contains("there is no folder `there/is/none`"), "{error}");
    assert!(!error.is_input());
}

#[test]
fn a_folder_as_target_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    assert!(Output::create(folder.path(), &[]).is_err());
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_an_error() {
    let full = Path::new("/dev/full");
    let Ok(mut output) = Output::create(full, &[]) else { return println!("skipped: no /dev/full here") };
    let written =
        output.write_all(&vec![0; 1 << 20]).map_err(|e| output.failed(e)).and_then(|()| output.finish());
    assert!(matches!(written, Err(Error::Io { action: "write", .. })));
    assert!(full.exists());
}

#[cfg(unix)]
#[test]
fn a_link_stays_and_the_file_it_leads_to_is_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let (file, link): (PathBuf, PathBuf) = (folder.path().join("file.obj"), folder.path().join("link.obj"));
    std::fs::write(&file, "old").unwrap();
    std::os::unix::fs::symlink(&file, &link).unwrap();
    let mut output = Output::create(&link, &[]).unwrap();
    output.write_all(b"new").unwrap();
    output.finish().unwrap();
    assert!(link.is_symlink());
    assert_eq!(std::fs::read(&file).unwrap(), b"new");
}
