//! Outputs that appear whole or not at all.

mod temporary;

use crate::error::Error;
use std::fs::{File, Metadata};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// A file in the making: written beside its target under another name, then synced and renamed by
/// [`Output::finish`]. Dropped unfinished it leaves nothing behind, and whatever stood at the target stands.
/// `-` is standard output; a target that is no plain file (a device, a pipe) is written to as it is.
#[derive(Debug)]
pub struct Output {
    name: String,
    target: PathBuf,
    /// The file to rename; `None` for standard output and for devices, and once it is renamed.
    temporary: Option<PathBuf>,
    writer: Writer,
}

#[derive(Debug)]
enum Writer {
    File(BufWriter<File>),
    Standard(BufWriter<io::Stdout>),
}

/// Bytes gathered before they go to the system.
const BUFFER: usize = 1 << 17;

/// Checks that an output could be made: its folder exists, and no input is the same file by another path or link.
///
/// # Errors
/// [`Error::NoFolder`], [`Error::OutputIsInput`], or [`Error::Io`] for a target that is a folder.
pub fn check_output(path: &Path, inputs: &[PathBuf]) -> Result<(), Error> {
    if path.as_os_str() == "-" {
        return Ok(());
    }
    let output = path.display().to_string();
    let folder = folder(path);
    if !folder.is_dir() {
        return Err(Error::NoFolder { output, folder: folder.display().to_string() });
    }
    let Ok(target) = std::fs::metadata(path) else { return Ok(()) };
    if target.is_dir() {
        return Err(Error::Io { action: "write", name: output, source: io::ErrorKind::IsADirectory.into() });
    }
    for input in inputs {
        if std::fs::metadata(input).is_ok_and(|input_meta| same_file(path, &target, input, &input_meta)) {
            return Err(Error::OutputIsInput { output, input: input.display().to_string() });
        }
    }
    Ok(())
}

fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

#[cfg(unix)]
fn same_file(_: &Path, a: &Metadata, _: &Path, b: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    a.is_file() && (a.dev(), a.ino()) == (b.dev(), b.ino())
}

#[cfg(not(unix))]
fn same_file(a: &Path, _: &Metadata, b: &Path, _: &Metadata) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

impl Output {
    /// Begins an output at `path`, which must be none of `inputs`.
    ///
    /// # Errors
    /// Those of [`check_output`], and [`Error::Io`] if the folder cannot be written to.
    pub fn create(path: &Path, inputs: &[PathBuf]) -> Result<Output, Error> {
        check_output(path, inputs)?;
        if path.as_os_str() == "-" {
            let writer = Writer::Standard(BufWriter::with_capacity(BUFFER, io::stdout()));
            return Ok(Output {
                name: "standard output".into(),
                target: PathBuf::new(),
                temporary: None,
                writer,
            });
        }
        let name = path.display().to_string();
        // A link is followed, so that the file it leads to is replaced and the link stays.
        let target = followed(path);
        let there = std::fs::metadata(&target);
        let opened = if there.as_ref().is_ok_and(|meta| !meta.is_file()) {
            File::options().write(true).open(&target).map(|file| (None, file))
        } else {
            temporary::create(&target, there.ok().as_ref()).map(|(path, file)| (Some(path), file))
        };
        let (temporary, file) =
            opened.map_err(|source| Error::Io { action: "write", name: name.clone(), source })?;
        Ok(Output { name, target, temporary, writer: Writer::File(BufWriter::with_capacity(BUFFER, file)) })
    }

    /// Writes a whole output: creates it at `path`, which must be none of `inputs`, lets `write` fill it, and finishes it.
    ///
    /// # Errors
    /// Those of [`Output::create`], and [`Error::Io`] for a failed write.
    pub fn whole(
        path: &Path,
        inputs: &[PathBuf],
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Error> {
        let mut output = Output::create(path, inputs)?;
        write(&mut output).map_err(|source| output.failed(source))?;
        output.finish()
    }

    /// Syncs the bytes written and moves the file to its place.
    ///
    /// # Errors
    /// [`Error::Io`] if the system refuses, a full disk above all; the target is then as it was.
    pub fn finish(mut self) -> Result<(), Error> {
        self.complete().map_err(|source| self.failed(source))
    }

    /// The error for a failed write to this output.
    pub fn failed(&self, source: io::Error) -> Error {
        Error::Io { action: "write", name: self.name.clone(), source }
    }

    fn complete(&mut self) -> io::Result<()> {
        self.flush()?;
        let Writer::File(file) = &self.writer else { return Ok(()) };
        let Some(temporary) = &self.temporary else { return Ok(()) };
        file.get_ref().sync_all()?;
        std::fs::rename(temporary, &self.target)?;
        self.temporary = None;
        // The name is on disk once the folder is; systems that cannot sync folders still have the file.
        if let Ok(folder) = File::open(folder(&self.target)) {
            let _ = folder.sync_all();
        }
        Ok(())
    }
}

/// Links that are followed one after the other.
const LINKS: usize = 40;

/// The target of a path through symbolic links, which need not exist.
fn followed(path: &Path) -> PathBuf {
    let mut at = path.to_path_buf();
    for _ in 0..LINKS {
        match std::fs::read_link(&at) {
            Ok(next) => at = folder(&at).join(next),
            Err(_) => break,
        }
    }
    at.canonicalize().unwrap_or(at)
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.writer {
            Writer::File(writer) => writer.write(bytes),
            Writer::Standard(writer) => writer.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.writer {
            Writer::File(writer) => writer.flush(),
            Writer::Standard(writer) => writer.flush(),
        }
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        if let Some(temporary) = &self.temporary {
            let _ = std::fs::remove_file(temporary);
        }
    }
}
