//! The files of a folder, each whole or not at all.

use crate::error::Error;
use crate::output::Output;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The files of the stages as they are written.
pub(super) struct Files<'a> {
    folder: &'a Path,
    inputs: &'a [PathBuf],
    /// The files written.
    pub(super) written: Vec<PathBuf>,
}

impl<'a> Files<'a> {
    pub(super) fn new(folder: &'a Path, inputs: &'a [PathBuf]) -> Self {
        Self { folder, inputs, written: Vec::new() }
    }

    /// Writes a file of this name.
    pub(super) fn write(
        &mut self,
        name: &str,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Error> {
        let path = self.folder.join(name);
        Output::whole(&path, self.inputs, |out| write(out))?;
        self.written.push(path);
        Ok(())
    }
}
