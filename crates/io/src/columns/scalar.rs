//! The number types that files store.

use super::stored::{Endian, Stored, number};
use lineament::Column;

/// A number type that a file stores.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    /// Half precision; columns hold it as `f32`.
    F16,
    F32,
    F64,
}

/// Runs `$body` with `$v` bound to the vector inside a column, whatever its type.
macro_rules! each_column {
    ($column:expr, $v:ident => $body:expr) => {
        match $column {
            lineament::Column::I8($v) => $body,
            lineament::Column::U8($v) => $body,
            lineament::Column::I16($v) => $body,
            lineament::Column::U16($v) => $body,
            lineament::Column::I32($v) => $body,
            lineament::Column::U32($v) => $body,
            lineament::Column::I64($v) => $body,
            lineament::Column::U64($v) => $body,
            lineament::Column::F32($v) => $body,
            lineament::Column::F64($v) => $body,
        }
    };
}
pub(crate) use each_column;

/// Runs `$body` with `$T` standing for the number type of a [`Scalar`].
macro_rules! each_scalar {
    ($kind:expr, $T:ident => $body:expr) => {{
        macro_rules! with {
            ($t:ty) => {{
                type $T = $t;
                $body
            }};
        }
        match $kind {
            Scalar::I8 => with!(i8),
            Scalar::U8 => with!(u8),
            Scalar::I16 => with!(i16),
            Scalar::U16 => with!(u16),
            Scalar::I32 => with!(i32),
            Scalar::U32 => with!(u32),
            Scalar::I64 => with!(i64),
            Scalar::U64 => with!(u64),
            Scalar::F16 => with!($crate::columns::stored::Half),
            Scalar::F32 => with!(f32),
            Scalar::F64 => with!(f64),
        }
    }};
}
impl Scalar {
    /// Bytes of one value.
    pub fn size(self) -> usize {
        match self {
            Scalar::I8 | Scalar::U8 => 1,
            Scalar::I16 | Scalar::U16 | Scalar::F16 => 2,
            Scalar::I32 | Scalar::U32 | Scalar::F32 => 4,
            Scalar::I64 | Scalar::U64 | Scalar::F64 => 8,
        }
    }

    /// Whether values are integers.
    pub fn is_integer(self) -> bool {
        !matches!(self, Scalar::F16 | Scalar::F32 | Scalar::F64)
    }

    /// An empty column of this type with room for `capacity` values.
    pub fn column(self, capacity: usize) -> Column {
        match self {
            Scalar::I8 => Column::I8(Vec::with_capacity(capacity)),
            Scalar::U8 => Column::U8(Vec::with_capacity(capacity)),
            Scalar::I16 => Column::I16(Vec::with_capacity(capacity)),
            Scalar::U16 => Column::U16(Vec::with_capacity(capacity)),
            Scalar::I32 => Column::I32(Vec::with_capacity(capacity)),
            Scalar::U32 => Column::U32(Vec::with_capacity(capacity)),
            Scalar::I64 => Column::I64(Vec::with_capacity(capacity)),
            Scalar::U64 => Column::U64(Vec::with_capacity(capacity)),
            Scalar::F16 | Scalar::F32 => Column::F32(Vec::with_capacity(capacity)),
            Scalar::F64 => Column::F64(Vec::with_capacity(capacity)),
        }
    }

    /// The type of a column.
    pub fn of(column: &Column) -> Scalar {
        match column {
            Column::I8(_) => Scalar::I8,
            Column::U8(_) => Scalar::U8,
            Column::I16(_) => Scalar::I16,
            Column::U16(_) => Scalar::U16,
            Column::I32(_) => Scalar::I32,
            Column::U32(_) => Scalar::U32,
            Column::I64(_) => Scalar::I64,
            Column::U64(_) => Scalar::U64,
            Column::F32(_) => Scalar::F32,
            Column::F64(_) => Scalar::F64,
        }
    }

    /// The value that the first bytes of `bytes` spell, as f64; 0 if they are too few.
    pub fn value(self, bytes: &[u8], endian: Endian) -> f64 {
        each_scalar!(self, T => number::<T>(bytes, endian).to_f64())
    }

    /// Writes field `offset` of every row (`stride` bytes each) of `rows` into axis `axis` of `out`.
    pub fn fill_axis(
        self,
        rows: &[u8],
        stride: usize,
        offset: usize,
        endian: Endian,
        out: &mut [[f64; 3]],
        axis: usize,
    ) {
        each_scalar!(self, T => {
            let numbers = rows.chunks_exact(stride).map(|row| number::<T>(&row[offset..], endian).to_f64());
            numbers.zip(out).for_each(|(number, point)| point[axis] = number);
        });
    }
}
