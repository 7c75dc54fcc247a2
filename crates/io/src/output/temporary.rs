//! The files that outputs are written to before they are renamed: each is locked while it is written, so that those of
//! processes that were killed are known by having no lock, and cleared.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs::{File, Metadata};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

/// Ends the names of such files.
const SUFFIX: &str = ".part";
/// Names that are tried: others may be taken by processes of the same number, as in containers.
const TRIES: usize = 1000;

/// A fresh file in the folder of `target`, with the permissions of what stands there.
pub(super) fn create(target: &Path, there: Option<&Metadata>) -> io::Result<(PathBuf, File)> {
    clear(target);
    for _ in 0..TRIES {
        let path = beside(target);
        let file = match File::options().write(true).create_new(true).open(&path) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => continue,
            opened => opened?,
        };
        // Where files cannot be locked nothing is cleared either.
        let _ = file.try_lock();
        // Another process may have cleared it before it was locked.
        if !same(&file, &path) {
            continue;
        }
        match there.map_or(Ok(()), |there| permit(&file, there)) {
            Ok(()) => return Ok((path, file)),
            Err(error) => {
                let _ = std::fs::remove_file(&path);
                return Err(error);
            }
        }
    }
    Err(io::Error::new(io::ErrorKind::AlreadyExists, "all names for a temporary file beside it are taken"))
}

/// Gives a file the permissions of another. File systems that have the same for all files refuse to set any.
fn permit(file: &File, there: &Metadata) -> io::Result<()> {
    if file.metadata()?.permissions() == there.permissions() {
        return Ok(());
    }
    file.set_permissions(there.permissions())
}

/// A name in the folder of `target`.
fn beside(target: &Path) -> PathBuf {
    static COUNTER: AtomicU64 = AtomicU64::new(0);
    let number = COUNTER.fetch_add(1, Ordering::Relaxed);
    let mut name = prefix(target);
    name.push(format!("{}-{number}{SUFFIX}", std::process::id()));
    target.with_file_name(name)
}

/// What the names of temporary files for `target` begin with.
fn prefix(target: &Path) -> std::ffi::OsString {
    let mut name = std::ffi::OsString::from(".");
    name.push(target.file_name().unwrap_or_default());
    name.push(".");
    name
}

/// Removes the temporary files of `target` that nobody holds. What cannot be removed stays.
fn clear(target: &Path) {
    // A folder is listed once by a process: it may hold many files, and get many outputs.
    static LISTED: Mutex<BTreeMap<PathBuf, Vec<OsString>>> = Mutex::new(BTreeMap::new());
    let folder = super::folder(target);
    let mut listed = LISTED.lock().unwrap_or_else(PoisonError::into_inner);
    let leftovers = listed.entry(folder.into()).or_insert_with(|| leftovers(folder));
    let prefix = prefix(target);
    leftovers.retain(|name| {
        let own = name.as_encoded_bytes().strip_prefix(prefix.as_encoded_bytes());
        let own = own.and_then(|rest| rest.strip_suffix(SUFFIX.as_bytes())).is_some_and(is_numbered);
        if own {
            remove(&folder.join(name));
        }
        !own
    });
}

/// The names of the temporary files in a folder.
fn leftovers(folder: &Path) -> Vec<OsString> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    // Opening a pipe would wait for its reader.
    let files = entries.filter(|entry| entry.file_type().is_ok_and(|kind| kind.is_file()));
    let names = files.map(|entry| entry.file_name());
    names.filter(|name| name.as_encoded_bytes().ends_with(SUFFIX.as_bytes())).collect()
}

/// Removes a file that nobody holds.
fn remove(path: &Path) {
    let Ok(file) = File::options().write(true).open(path) else { return };
    if file.try_lock().is_ok() && same(&file, path) {
        let _ = std::fs::remove_file(path);
    }
}

/// Whether text is two numbers with a dash between them.
fn is_numbered(text: &[u8]) -> bool {
    let mut parts = text.split(|&b| b == b'-');
    let number =
        |part: Option<&[u8]>| part.is_some_and(|p| !p.is_empty() && p.iter().all(u8::is_ascii_digit));
    number(parts.next()) && number(parts.next()) && parts.next().is_none()
}

/// Whether a file still stands at its path.
#[cfg(unix)]
fn same(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let (Ok(a), Ok(b)) = (file.metadata(), std::fs::symlink_metadata(path)) else { return false };
    (a.dev(), a.ino()) == (b.dev(), b.ino())
}

#[cfg(not(unix))]
fn same(_: &File, path: &Path) -> bool {
    path.exists()
}
