//! Number types of files and the columns that their values go into.

mod half;

use lineament::Column;
use rayon::prelude::*;

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

/// The order of the bytes of a number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Endian {
    #[default]
    Little,
    Big,
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
        match self {
            Scalar::I8 => number::<i8>(bytes, endian).into(),
            Scalar::U8 => number::<u8>(bytes, endian).into(),
            Scalar::I16 => number::<i16>(bytes, endian).into(),
            Scalar::U16 => number::<u16>(bytes, endian).into(),
            Scalar::I32 => number::<i32>(bytes, endian).into(),
            Scalar::U32 => number::<u32>(bytes, endian).into(),
            Scalar::I64 => number::<i64>(bytes, endian).to_f64(),
            Scalar::U64 => number::<u64>(bytes, endian).to_f64(),
            Scalar::F16 => number::<Half>(bytes, endian).to_f64(),
            Scalar::F32 => number::<f32>(bytes, endian).into(),
            Scalar::F64 => number::<f64>(bytes, endian),
        }
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
        match self {
            Scalar::I8 => axis_of::<i8>(rows, stride, offset, endian, out, axis),
            Scalar::U8 => axis_of::<u8>(rows, stride, offset, endian, out, axis),
            Scalar::I16 => axis_of::<i16>(rows, stride, offset, endian, out, axis),
            Scalar::U16 => axis_of::<u16>(rows, stride, offset, endian, out, axis),
            Scalar::I32 => axis_of::<i32>(rows, stride, offset, endian, out, axis),
            Scalar::U32 => axis_of::<u32>(rows, stride, offset, endian, out, axis),
            Scalar::I64 => axis_of::<i64>(rows, stride, offset, endian, out, axis),
            Scalar::U64 => axis_of::<u64>(rows, stride, offset, endian, out, axis),
            Scalar::F16 => axis_of::<Half>(rows, stride, offset, endian, out, axis),
            Scalar::F32 => axis_of::<f32>(rows, stride, offset, endian, out, axis),
            Scalar::F64 => axis_of::<f64>(rows, stride, offset, endian, out, axis),
        }
    }
}

/// Appends field `offset` of every row (`stride` bytes each) of `rows` to a column of the field's type.
pub(crate) fn append(column: &mut Column, rows: &[u8], stride: usize, offset: usize, endian: Endian) {
    each_column!(column, values => extend(values, rows, stride, offset, endian));
}

/// Appends a field of this type, which may be one that the column holds as another.
pub(crate) fn append_as(
    kind: Scalar,
    column: &mut Column,
    rows: &[u8],
    stride: usize,
    offset: usize,
    endian: Endian,
) {
    match (kind, column) {
        (Scalar::F16, Column::F32(values)) => {
            each_row(values, rows, stride, |row| number::<Half>(&row[offset..], endian).single());
        }
        (_, column) => append(column, rows, stride, offset, endian),
    }
}

fn extend<T: Number>(values: &mut Vec<T>, rows: &[u8], stride: usize, offset: usize, endian: Endian) {
    each_row(values, rows, stride, |row| number::<T>(&row[offset..], endian));
}

/// Bytes of rows from which on threads share them: most of the time goes into touching memory that is fresh.
pub(crate) const SHARED: usize = 1 << 20;
/// Rows that a thread takes at least.
const LEAST_ROWS: usize = 1 << 13;

/// Appends what `take` makes of every row (`stride` bytes each) of `rows`, in their order.
fn each_row<T: Send>(
    values: &mut Vec<T>,
    rows: &[u8],
    stride: usize,
    take: impl Fn(&[u8]) -> T + Send + Sync,
) {
    if rows.len() < SHARED {
        values.extend(rows.chunks_exact(stride).map(take));
    } else {
        values.par_extend(rows.par_chunks_exact(stride).with_min_len(LEAST_ROWS).map(take));
    }
}

/// Appends the points whose coordinates are fields, at `offsets` and all of one type, of every row (`stride` bytes each).
pub(crate) fn append_points(
    points: &mut Vec<[f64; 3]>,
    rows: &[u8],
    stride: usize,
    (kind, offsets): (Scalar, [usize; 3]),
    endian: Endian,
) {
    if kind == Scalar::F16 {
        return points_like::<Half>(&[], points, rows, stride, offsets, endian);
    }
    each_column!(&kind.column(0), values => points_like(values, points, rows, stride, offsets, endian));
}

/// Points from fields of the type of `_kind`.
fn points_like<T: Stored>(
    _kind: &[T],
    points: &mut Vec<[f64; 3]>,
    rows: &[u8],
    stride: usize,
    offsets: [usize; 3],
    endian: Endian,
) {
    let point = |row: &[u8], endian| offsets.map(|offset| number::<T>(&row[offset..], endian).to_f64());
    match endian {
        Endian::Little => each_row(points, rows, stride, |row| point(row, Endian::Little)),
        Endian::Big => each_row(points, rows, stride, |row| point(row, Endian::Big)),
    }
}

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

/// A number of fixed size in a file.
pub(crate) trait Stored: Copy + Send {
    /// From little or big endian bytes; 0 if they are too few.
    fn from_bytes(bytes: &[u8], endian: Endian) -> Self;
    /// As f64, rounded where it does not fit.
    fn to_f64(self) -> f64;
}

/// A number that columns hold too.
pub(crate) trait Number: Stored {
    /// As little endian bytes.
    fn put(self, out: &mut Vec<u8>);
    /// From f64, if the type holds that value; f32 rounds.
    fn narrow(value: f64) -> Option<Self>;
}

macro_rules! numbers {
    ($narrow:ident: $($t:ty)*) => {$(
        impl Stored for $t {
            #[inline]
            fn from_bytes(bytes: &[u8], endian: Endian) -> Self {
                match (bytes.first_chunk(), endian) {
                    (Some(&bytes), Endian::Little) => <$t>::from_le_bytes(bytes),
                    (Some(&bytes), Endian::Big) => <$t>::from_be_bytes(bytes),
                    (None, _) => <$t>::default(),
                }
            }
            #[inline]
            fn to_f64(self) -> f64 {
                self as f64
            }
        }
        impl Number for $t {
            fn put(self, out: &mut Vec<u8>) {
                out.extend_from_slice(&self.to_le_bytes());
            }
            fn narrow(value: f64) -> Option<Self> {
                let narrowed = value as $t;
                $narrow(value, narrowed as f64).then_some(narrowed)
            }
        }
    )*};
}

/// An integer type holds a value that comes back the same.
fn same(value: f64, back: f64) -> bool {
    value == back
}

/// A float type holds every value, rounded.
fn rounded(_: f64, _: f64) -> bool {
    true
}

numbers!(same: i8 u8 i16 u16 i32 u32 i64 u64);
numbers!(rounded: f32 f64);

/// The bits of a number of half precision.
#[derive(Clone, Copy)]
struct Half(u16);

impl Half {
    fn single(self) -> f32 {
        half::single(self.0)
    }
}

impl Stored for Half {
    fn from_bytes(bytes: &[u8], endian: Endian) -> Self {
        Half(u16::from_bytes(bytes, endian))
    }
    fn to_f64(self) -> f64 {
        self.single().into()
    }
}

#[inline]
fn number<T: Stored>(bytes: &[u8], endian: Endian) -> T {
    T::from_bytes(bytes, endian)
}

fn axis_of<T: Stored>(
    rows: &[u8],
    stride: usize,
    offset: usize,
    endian: Endian,
    out: &mut [[f64; 3]],
    axis: usize,
) {
    match endian {
        Endian::Little => {
            for (row, point) in rows.chunks_exact(stride).zip(out) {
                point[axis] = number::<T>(&row[offset..], Endian::Little).to_f64();
            }
        }
        Endian::Big => {
            for (row, point) in rows.chunks_exact(stride).zip(out) {
                point[axis] = number::<T>(&row[offset..], Endian::Big).to_f64();
            }
        }
    }
}
