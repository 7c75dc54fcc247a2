//! Where on earth the points of an input lie: the reference system that it states, that of a `.prj` file beside it, or the one that
//! was asked for.

use super::{Decoded, ReadOptions};
use crate::crs::{Crs, Measure};
use crate::error::Error;
use crate::source::Source;
use std::path::{Path, PathBuf};

/// Extensions of files with well-known text.
const BESIDE: [&str; 2] = ["prj", "PRJ"];
/// Bytes beyond which a file is no definition of a system.
const LONGEST: u64 = 1 << 16;

/// Settles the reference system: that of the options goes over that of the input, which goes over that of a file beside it.
///
/// # Errors
/// A code that the register does not have.
pub(super) fn settle(source: &Source, options: &ReadOptions, out: &mut Decoded) -> Result<(), Error> {
    if let Some(code) = options.crs {
        let known = Crs::of_code(code.into()).filter(|crs| crs.measure().is_some());
        let asked = known.ok_or_else(|| Error::Unsupported {
            name: source.name().into(),
            what: format!("EPSG:{code} is no horizontal reference system of the EPSG register"),
            advice: "name one that is, such as EPSG:25832".into(),
        })?;
        instead(asked, code, out);
    } else if out.crs.is_none()
        && let Some(path) = source.path()
        && let Some((beside, text)) = BESIDE.iter().find_map(|extension| definition(path, extension))
    {
        out.crs = Crs::parse(&text);
        out.beside.push(beside);
        if let (Some(las), Some(wkt)) = (&mut out.las, &out.crs.wkt) {
            las.define(wkt);
        }
    }
    if out.crs.measure() == Some(Measure::Degrees) {
        let name = out.crs.short().unwrap_or_default();
        out.warnings.push(format!(
            "x and y are degrees ({name}) and z is a length, so that neither distances nor angles are right: project the points \
             first, such as to their UTM zone"
        ));
    }
    Ok(())
}

/// Puts the system that was asked for in the place of what the input states, and says so where that is another.
fn instead(asked: Crs, code: u32, out: &mut Decoded) {
    let stated = std::mem::replace(&mut out.crs, asked);
    if stated.code == Some(code.into()) {
        // The same system, with its definition.
        out.crs = stated;
        return;
    }
    if let Some(other) = stated.short() {
        out.warnings.push(format!(
            "the input states the reference system {other}: EPSG:{code} is taken, as asked for"
        ));
    }
    if let Some(las) = &mut out.las {
        las.place(code);
    }
}

/// The file of this extension beside an input, and the definition in it.
fn definition(path: &Path, extension: &str) -> Option<(PathBuf, String)> {
    let beside = path.with_extension(extension);
    let length = std::fs::metadata(&beside).ok().filter(|meta| meta.is_file())?.len();
    let bytes = std::fs::read(&beside).ok().filter(|_| beside != path && length <= LONGEST)?;
    let text = String::from_utf8_lossy(&bytes).into_owned();
    // Text that is no well-known text is older than it, and names no system that others know.
    Crs::parse(&text).wkt.is_some().then_some((beside, text))
}
