//! Columns, one value at a time.

use super::scalar::{Scalar, each_column};
use super::stored::{Number, Stored};
use lineament::Column;

/// Appends a value to a column. `false`, and nothing is appended, if the type of the column cannot hold it.
pub(crate) fn push(column: &mut Column, value: f64) -> bool {
    each_column!(column, values => match Number::narrow(value) {
        Some(value) => {
            values.push(value);
            true
        }
        None => false,
    })
}

/// Value `index` of a column as f64; NaN beyond its end. Integers beyond 2^53 round.
pub(crate) fn get(column: &Column, index: usize) -> f64 {
    each_column!(column, values => values.get(index).map_or(f64::NAN, |&value| value.to_f64()))
}

/// Values in the smallest integer type that holds them all, or as they are: for inputs that state no type.
pub(crate) fn narrowed(values: Vec<f64>) -> Column {
    let kinds = [Scalar::U8, Scalar::I16, Scalar::U16, Scalar::I32, Scalar::U32];
    let negative_zero = |v: &f64| *v == 0.0 && v.is_sign_negative();
    let whole = values.iter().all(|v| v.fract() == 0.0 && !negative_zero(v));
    for kind in kinds.into_iter().filter(|_| whole) {
        let mut column = kind.column(values.len());
        if values.iter().all(|&value| push(&mut column, value)) {
            return column;
        }
    }
    Column::F64(values)
}

/// Keeps the first `length` values of a column.
pub(crate) fn truncate(column: &mut Column, length: usize) {
    each_column!(column, values => values.truncate(length));
}

/// Values that a column has room for.
pub(crate) fn capacity(column: &Column) -> usize {
    each_column!(column, values => values.capacity())
}
