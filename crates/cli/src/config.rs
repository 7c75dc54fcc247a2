//! From the command line and parameter files to checked parameters.

mod file;
pub mod text;

use lineament::params::Params;

use crate::args::{Running, Tuning};
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
pub fn params_from(mut params: Params, tuning: &Tuning) -> Result<Params, Failure> {
    if let Some(path) = &tuning.params {
        file::read(path, &mut params)?;
    }
    if let Some(method) = &tuning.method {
        params.set("method", method).map_err(|e| Failure::from(e).at("--method"))?;
    }
    for (key, value) in &tuning.set {
        params.set(key, value).map_err(|e| Failure::from(e).at("--set"))?;
    }
    params.check()?;
    Ok(params)
}

/// Gives the whole program this many threads. Once.
pub fn threads(running: &Running) -> Result<(), Failure> {
    let Some(count) = running.threads else { return Ok(()) };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(count.into()).build_global();
    pool.map_err(|e| Failure::new(Code::Usage, format!("--threads {count}: {e}")))
}
