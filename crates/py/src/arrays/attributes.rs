//! The further columns of a cloud as arrays of their own types.

use lineament::{Attribute, Column};
use numpy::{IntoPyArray, PyArray1, PyArrayMethods};
use pyo3::prelude::*;

use crate::fault::Fault;

/// A name and an array.
pub type Named<'py> = (String, Bound<'py, PyAny>);

/// The columns for Python, which takes them over.
pub fn out<'py>(py: Python<'py>, attributes: Vec<Attribute>) -> Vec<Named<'py>> {
    attributes.into_iter().map(|a| (a.name, array(py, a.values))).collect()
}

fn array(py: Python<'_>, column: Column) -> Bound<'_, PyAny> {
    match column {
        Column::I8(v) => v.into_pyarray(py).into_any(),
        Column::U8(v) => v.into_pyarray(py).into_any(),
        Column::I16(v) => v.into_pyarray(py).into_any(),
        Column::U16(v) => v.into_pyarray(py).into_any(),
        Column::I32(v) => v.into_pyarray(py).into_any(),
        Column::U32(v) => v.into_pyarray(py).into_any(),
        Column::I64(v) => v.into_pyarray(py).into_any(),
        Column::U64(v) => v.into_pyarray(py).into_any(),
        Column::F32(v) => v.into_pyarray(py).into_any(),
        Column::F64(v) => v.into_pyarray(py).into_any(),
    }
}

/// The columns from Python.
///
/// # Errors
/// An array that is not one row of numbers.
pub fn back(named: Vec<Named<'_>>) -> Result<Vec<Attribute>, Fault> {
    let attribute = |(name, array): Named<'_>| {
        let values = column(&array)
            .ok_or_else(|| Fault::Argument(format!("attribute `{name}`: expected a row of numbers")))?;
        Ok(Attribute { name, values })
    };
    named.into_iter().map(attribute).collect()
}

fn column(array: &Bound<'_, PyAny>) -> Option<Column> {
    macro_rules! first {
        ($($variant:ident),+) => {
            $(if let Ok(row) = array.cast::<PyArray1<_>>() {
                return Some(Column::$variant(row.to_vec().ok()?));
            })+
        };
    }
    first!(F64, F32, U8, I8, U16, I16, U32, I32, U64, I64);
    None
}
