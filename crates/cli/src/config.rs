//! From the command line and parameter files to checked parameters.

mod file;
pub mod near;
pub mod text;

use std::path::Path;

use lineament::params::Params;
use lineament::section::SectionParams;

use crate::args::{Running, Settings, Slicing, Tuning};
use crate::failure::{Code, Failure};

/// The parameters in effect: the defaults, under the file, under `--method`, under `--set` in order.
///
/// # Errors
/// Input if the file cannot be read or is not TOML; refused if a key is unknown or a value out of range.
pub fn params(tuning: &Tuning) -> Result<Params, Failure> {
    params_from(Params::default(), tuning)
}

/// As [`params`], with other values than the defaults to begin with.
///
/// # Errors
/// As [`params`].
pub fn params_from(params: Params, tuning: &Tuning) -> Result<Params, Failure> {
    settled(params, &tuning.settings, |params| match &tuning.method {
        Some(method) => set(params, "method", method).map_err(|e| e.at("--method")),
        None => Ok(()),
    })
}

/// The keys that a parameter file names, with their values as text, checked one by one.
///
/// # Errors
/// As [`params`].
pub fn of_file(path: &Path) -> Result<Vec<(String, String)>, Failure> {
    let (mut params, mut all) = (Params::default(), Vec::new());
    file::each(path, &mut |key, value| {
        all.push((key.into(), value.into()));
        set(&mut params, key, value)
    })?;
    Ok(all)
}

/// The parameters of sections in effect: the defaults, under the file, under the options of their own, under `--set`.
///
/// # Errors
/// As [`params`].
pub fn section(slicing: &Slicing) -> Result<SectionParams, Failure> {
    let options = |params: &mut Params| {
        slicing.set(&mut params.section);
        Ok(())
    };
    Ok(settled(Params::default(), &slicing.settings, options)?.section)
}

/// `params`, overridden by the file, then by the options, then by each `--set` in order; checked.
fn settled(
    mut params: Params,
    settings: &Settings,
    options: impl FnOnce(&mut Params) -> Result<(), Failure>,
) -> Result<Params, Failure> {
    if let Some(path) = &settings.params {
        file::read(path, &mut params)?;
    }
    options(&mut params)?;
    for (key, value) in &settings.set {
        set(&mut params, key, value).map_err(|e| e.at("--set"))?;
    }
    params.check()?;
    Ok(params)
}

/// Sets one parameter; a wrong key or word is answered by the one that was likely meant.
fn set(params: &mut Params, key: &str, value: &str) -> Result<(), Failure> {
    let Err(error) = params.set(key, value) else { return Ok(()) };
    let entries = params.entries();
    let meant = match entries.iter().find(|entry| entry.key == key) {
        None => near::nearest(key, entries.iter().map(|entry| entry.key.as_str())),
        Some(entry) => near::nearest(value, entry.names.iter().copied()),
    };
    let failure = Failure::from(error);
    Err(match meant {
        Some(meant) => {
            failure.advise(format!("did you mean `{meant}`? `lineament params` lists all parameters"))
        }
        None => failure,
    })
}

/// Gives the whole program this many threads. Once.
pub fn threads(running: &Running) -> Result<(), Failure> {
    let Some(count) = running.threads else { return Ok(()) };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(count.into()).build_global();
    pool.map_err(|e| Failure::new(Code::Usage, format!("--threads {count}: {e}")))
}
