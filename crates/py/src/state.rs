//! What Python only holds on to, as bytes: for copies, and for pickles that go to another process.

use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::fault::Fault;

/// Its bytes are laid out as the types of this version are.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// A value as bytes, behind the version. Numbers come back to the bit.
///
/// # Errors
/// Internal: the values are plain.
pub fn bytes<'py>(py: Python<'py>, value: &impl Serialize) -> PyResult<(Bound<'py, PyBytes>,)> {
    let state = postcard::to_allocvec(&(VERSION, value));
    Ok((PyBytes::new(py, &state.map_err(|e| Fault::Internal(e.to_string()))?),))
}

/// The value of such bytes.
///
/// # Errors
/// Bytes of another version of the package, and such as are none.
pub fn value<T: DeserializeOwned>(state: &[u8]) -> Result<T, Fault> {
    let wrong = |what: String| Fault::Argument(format!("a result that was kept as bytes: {what}"));
    let (version, rest): (&str, _) = postcard::take_from_bytes(state).map_err(|e| wrong(e.to_string()))?;
    if version != VERSION {
        return Err(wrong(format!("it is of lineament {version}, this is {VERSION}")));
    }
    postcard::from_bytes(rest).map_err(|e| wrong(e.to_string()))
}
