//! Number types of files and the columns that their values go into.

mod half;
mod rows;
mod scalar;
mod stored;
mod values;

pub(crate) use rows::{SHARED, append, append_as, append_points};
pub(crate) use scalar::{Scalar, each_column};
pub(crate) use stored::{Endian, Number, Stored};
pub(crate) use values::{capacity, get, narrowed, push, truncate};
