//! Pictures of what was missed and what is false.

use std::path::{Path, PathBuf};

use lineament::apply::render::{Scene, Settings, View, render, surfels};
use lineament_io as io;

use super::{Comparison, extension};
use crate::args::Evaluate;
use crate::failure::{Code, Failure};
use crate::source::Input;

/// The settings of a picture.
fn settings(args: &Evaluate) -> Result<Settings, Failure> {
    let usage = |e: lineament::Error| Failure { code: Code::Usage, advice: None, ..Failure::from(e) };
    let (view, (width, height)) = (View::parse(&args.view).map_err(usage)?, args.size);
    let settings = Settings { views: vec![view], width, height, ..Settings::default() };
    settings.check().map_err(usage)?;
    Ok(settings)
}

/// Refuses a view or a size that is none.
pub fn check(args: &Evaluate) -> Result<(), Failure> {
    settings(args).map(|_| ())
}

/// Writes a picture over the scan, or a drawing.
pub fn write(
    path: &Path,
    inputs: &[PathBuf],
    args: &Evaluate,
    compared: &Comparison,
    scan: Option<&Input>,
) -> Result<(), Failure> {
    let settings = settings(args)?;
    if extension(path) == "svg" {
        let view = match settings.views[..] {
            [View::From(from)] => Some(from.map(|x| -x)),
            _ => None,
        };
        return Ok(io::write_verdicts(path, inputs, &compared.stretches, view)?);
    }
    let (surfels, spacing) = match scan {
        Some(scan) => surfels(&scan.cloud).map_err(|e| Failure::from(e).at(&scan.name))?,
        None => (Vec::new(), compared.spacing),
    };
    let settings = Settings { up: scan.map_or(settings.up, Input::up), ..settings };
    let scene = Scene { surfels: &surfels, verdicts: &compared.stretches, spacing, ..Scene::default() };
    let picture = render(&scene, &settings).map_err(|e| Failure { advice: None, ..e.into() })?;
    Ok(io::write_picture(path, inputs, &picture)?)
}
