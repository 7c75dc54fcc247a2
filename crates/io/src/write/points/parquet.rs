//! Classified points as Parquet: x, y and z as double, class, score, and every attribute of the input in its type.

use super::rows::names;
use super::table::PointTable;
use crate::columns::Scalar;
use ::parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use ::parquet::data_type::{DataType, DoubleType, FloatType, Int32Type, Int64Type};
use ::parquet::errors::Result;
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter, SerializedRowGroupWriter};
use ::parquet::schema::types::{Type, TypePtr};
use lineament::Column;
use std::io::{self, Write};
use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};

/// Rows of a row group.
const GROUP: usize = 1 << 20;

/// Writes row group after row group; one at a time is in memory.
pub(super) fn write(out: &mut dyn Write, table: &PointTable) -> io::Result<()> {
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_dictionary_enabled(false)
        .set_created_by(concat!("lineament ", env!("CARGO_PKG_VERSION")).into())
        .build();
    let gathered = Gathered::default();
    let schema = schema(table).map_err(io::Error::other)?;
    let writer = SerializedFileWriter::new(gathered.clone(), schema, Arc::new(properties));
    let mut writer = writer.map_err(io::Error::other)?;
    let count = table.cloud.len();
    for start in (0..count).step_by(GROUP) {
        write_group(&mut writer, table, start..(start + GROUP).min(count)).map_err(io::Error::other)?;
        out.write_all(&gathered.take())?;
    }
    writer.close().map_err(io::Error::other)?;
    out.write_all(&gathered.take())
}

/// Bytes of the encoder that are not yet taken: it needs an output that threads may share.
#[derive(Clone, Default)]
struct Gathered(Arc<Mutex<Vec<u8>>>);

impl Gathered {
    fn take(&self) -> Vec<u8> {
        std::mem::take(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Write for Gathered {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn schema(table: &PointTable) -> Result<TypePtr> {
    let axes = ["x", "y", "z"].map(|axis| (axis.to_string(), Scalar::F64));
    let fields = axes.into_iter().chain(names(table)).map(|(name, kind)| field(&name, kind).map(Arc::new));
    let fields = fields.collect::<Result<Vec<TypePtr>>>()?;
    Ok(Arc::new(Type::group_type_builder("points").with_fields(fields).build()?))
}

/// A column that has no nulls.
fn field(name: &str, kind: Scalar) -> Result<Type> {
    let (physical, integer) = match kind {
        Scalar::F16 | Scalar::F32 => (Physical::FLOAT, None),
        Scalar::F64 => (Physical::DOUBLE, None),
        Scalar::I64 => (Physical::INT64, Some((64, true))),
        Scalar::U64 => (Physical::INT64, Some((64, false))),
        Scalar::I8 => (Physical::INT32, Some((8, true))),
        Scalar::U8 => (Physical::INT32, Some((8, false))),
        Scalar::I16 => (Physical::INT32, Some((16, true))),
        Scalar::U16 => (Physical::INT32, Some((16, false))),
        Scalar::I32 => (Physical::INT32, Some((32, true))),
        Scalar::U32 => (Physical::INT32, Some((32, false))),
    };
    let logical = integer.map(|(bit_width, is_signed)| LogicalType::integer(bit_width, is_signed));
    let builder = Type::primitive_type_builder(name, physical).with_repetition(Repetition::REQUIRED);
    builder.with_logical_type(logical).build()
}

type Group<'a> = SerializedRowGroupWriter<'a, Gathered>;

fn write_group(
    writer: &mut SerializedFileWriter<Gathered>,
    table: &PointTable,
    rows: Range<usize>,
) -> Result<()> {
    let mut row_group = writer.next_row_group()?;
    let group = &mut row_group;
    for axis in 0..3 {
        let values: Vec<f64> = table.cloud.positions[rows.clone()].iter().map(|p| p[axis]).collect();
        put::<DoubleType>(group, &values)?;
    }
    if let Some(classes) = table.classes.get(rows.clone()) {
        put::<Int32Type>(group, &wide(classes, |class| class.into()))?;
    }
    if !table.scores.is_empty() {
        put::<FloatType>(group, &table.scores[rows.clone()])?;
    }
    table.cloud.attributes.iter().try_for_each(|a| column(group, &a.values, rows.clone()))?;
    row_group.close().map(|_| ())
}

/// Unsigned numbers are stored as the signed ones with the same bits.
fn column(group: &mut Group, column: &Column, rows: Range<usize>) -> Result<()> {
    match column {
        Column::I8(v) => put::<Int32Type>(group, &wide(&v[rows], |v| v.into())),
        Column::U8(v) => put::<Int32Type>(group, &wide(&v[rows], |v| v.into())),
        Column::I16(v) => put::<Int32Type>(group, &wide(&v[rows], |v| v.into())),
        Column::U16(v) => put::<Int32Type>(group, &wide(&v[rows], |v| v.into())),
        Column::I32(v) => put::<Int32Type>(group, &v[rows]),
        Column::U32(v) => put::<Int32Type>(group, &wide(&v[rows], |v| v as i32)),
        Column::I64(v) => put::<Int64Type>(group, &v[rows]),
        Column::U64(v) => put::<Int64Type>(group, &wide(&v[rows], |v| v as i64)),
        Column::F32(v) => put::<FloatType>(group, &v[rows]),
        Column::F64(v) => put::<DoubleType>(group, &v[rows]),
    }
}

fn wide<T: Copy, W>(values: &[T], widen: impl Fn(T) -> W) -> Vec<W> {
    values.iter().map(|&value| widen(value)).collect()
}

fn put<T: DataType>(group: &mut Group, values: &[T::T]) -> Result<()> {
    let Some(mut column): Option<SerializedColumnWriter> = group.next_column()? else { return Ok(()) };
    column.typed::<T>().write_batch(values, None, None)?;
    column.close()
}
