//! `--stages`: the stages of a method.

use std::path::{Path, PathBuf};

use lineament::{Cloud, Extraction, Method};
use lineament_io::write_stages;

use crate::failure::{Code, Failure};
use crate::outputs;
use crate::source::Origin;
use crate::work::Work;

/// Has the stages kept if there is a folder for them; refuses those of the default method, which has none to show.
pub fn keep(work: &mut Work, folder: Option<&Path>) -> Result<(), Failure> {
    work.staged = folder.is_some();
    if folder.is_none() || work.params.method != Method::Auto {
        return Ok(());
    }
    let failure = Failure::new(Code::Usage, "--stages: the method `auto` has no stages to show");
    Err(failure.advise("add `--method penalty`, `projection` or `segments`"))
}

/// Writes the stages of one input; the files written.
pub fn write(
    work: &Work,
    folder: Option<&Path>,
    origin: &Origin,
    cloud: &Cloud,
    found: &Extraction,
) -> Result<Vec<PathBuf>, Failure> {
    let Some(folder) = folder else { return Ok(Vec::new()) };
    let folder = self::folder(folder, work.count() > 1, origin)?;
    outputs::write(&folder, || write_stages(&folder, &work.inputs, cloud, found))
}

/// The folder for the stages of one input, made if it is not there; of several inputs one of that input's name within.
pub fn folder(folder: &Path, several: bool, origin: &Origin) -> Result<PathBuf, Failure> {
    let folder = if several { folder.join(origin.stem()) } else { folder.into() };
    outputs::make(&folder)?;
    Ok(folder)
}
