//! Apache Parquet: flat columns of numbers, of which three are called x, y and z. Columns of text, dates as text and
//! nested columns are left out. The crate `parquet` decodes what [`pages`] has found to fit the file.

mod page;
mod pages;
mod schema;
mod thrift;
mod tree;
mod unpack;

use super::{Decoded, ReadOptions, limit};
use crate::columns::{Scalar, get};
use crate::error::{Error, Place};
use crate::quiet;
use crate::source::{Shared, Source, Window};
use ::parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use ::parquet::data_type::DataType;
use ::parquet::errors::{ParquetError, Result as ParquetResult};
use ::parquet::file::metadata::ParquetMetaData;
use ::parquet::file::reader::{ChunkReader, FileReader, Length, SerializedFileReader};
use bytes::Bytes;
use lineament::{Attribute, Column};
use pages::Room;
use schema::Wanted;
use std::io::BufReader;

/// First and last bytes of the format.
pub(crate) const MAGIC: &[u8] = b"PAR1";
/// Memory that a byte of metadata may take once it is decoded.
const METADATA: u64 = 200;
/// Bytes that a row takes for a while: a coordinate, or an integer until it is a double.
const TRANSIENT: usize = 8;
/// Values that are decoded at a time.
const BATCH: usize = 1 << 14;

/// The input as the decoder wants it.
struct Chunks(Shared);

impl Length for Chunks {
    fn len(&self) -> u64 {
        self.0.length()
    }
}

impl ChunkReader for Chunks {
    type T = BufReader<Window>;

    fn get_read(&self, start: u64) -> ParquetResult<Self::T> {
        Ok(BufReader::with_capacity(1 << 12, self.0.window(start, u64::MAX)))
    }

    fn get_bytes(&self, start: u64, length: usize) -> ParquetResult<Bytes> {
        self.0.at(start, length).map(Bytes::from).map_err(|e| ParquetError::External(Box::new(e)))
    }
}

/// Reads a Parquet input.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    let shared = source.seekable()?;
    let shared = Shared::new(shared).map_err(|e| source.io(e))?;
    check_footer(source, options, &shared)?;
    let source: &Source = source;
    quiet::catch(|| decode(source, options, &shared))
        .unwrap_or_else(|| Err(fault(source, 0, "columns that cannot be decoded".into())))
}

fn fault(source: &Source, at: u64, found: String) -> Error {
    source.fault(Place::Byte(at), found, "the file is cut or damaged; get it anew")
}

/// The metadata at the end, before the decoder takes memory or time for what it claims.
fn check_footer(source: &Source, options: &ReadOptions, shared: &Shared) -> Result<(), Error> {
    let length = shared.length();
    let end = length.checked_sub(8).and_then(|at| shared.at(at, 8).ok()).filter(|end| end.ends_with(MAGIC));
    let Some(&[a, b, c, d]) = end.as_deref().and_then(|end| end.first_chunk()) else {
        return Err(fault(source, length, "an end without `PAR1`: the file is not whole".into()));
    };
    let metadata = u64::from(u32::from_le_bytes([a, b, c, d]));
    if metadata + 12 > length {
        return Err(fault(source, length - 8, format!("metadata of {metadata} bytes")));
    }
    if metadata * METADATA > limit::bound(source, options) {
        return Err(limit::beyond(source, options, length - 8, &format!("metadata of {metadata} bytes")));
    }
    let at = length - 8 - metadata;
    let bytes = shared.at(at, metadata as usize).map_err(|e| source.io(e))?;
    if !thrift::is_structure(&bytes) {
        return Err(fault(source, at, "metadata that is no whole structure".into()));
    }
    let paths = tree::paths(&bytes).map_err(|found| fault(source, at, found))?;
    if paths > limit::bound(source, options) / 2 {
        let what = format!("a schema whose columns have paths of {paths} bytes");
        return Err(limit::beyond(source, options, at, &what));
    }
    Ok(())
}

fn decode(source: &Source, options: &ReadOptions, shared: &Shared) -> Result<Decoded, Error> {
    let failed = |error: ParquetError| fault(source, shared.length(), error.to_string());
    let file = SerializedFileReader::new(Chunks(shared.clone())).map_err(failed)?;
    let metadata = file.metadata();
    let mut out = Decoded::default();
    let mut wanted = schema::wanted(source, metadata.file_metadata().schema_descr(), options, &mut out)?;
    let rows = rows(metadata).map_err(|found| fault(source, shared.length(), found))?;
    let attributes = wanted.iter().filter(|column| column.axis.is_none());
    let row_bytes = 24 + TRANSIENT + attributes.map(Wanted::bytes).sum::<usize>();
    limit::check(source, options, rows, row_bytes)?;
    let bound = limit::bound(source, options);
    let mut room = Room { memory: bound - rows * row_bytes as u64, total: bound.saturating_mul(2) };
    out.cloud.positions = vec![[0.0; 3]; rows as usize];
    wanted.iter_mut().filter(|column| column.axis.is_none()).for_each(|column| column.reserve(rows as usize));
    let mut first = 0;
    for (index, group) in metadata.row_groups().iter().enumerate() {
        let reader = file.get_row_group(index).map_err(failed)?;
        let count = group.num_rows() as usize;
        for column in &mut wanted {
            pages::check(source, options, shared, group.column(column.index), &mut room)?;
            let values = reader.get_column_reader(column.index).map_err(failed)?;
            if column.axis.is_some() {
                column.reserve(count);
            }
            let read = group_column(values, count, column).map_err(failed)?;
            if read < count {
                // All pages are there, so that nothing is cut off.
                let name = &column.name;
                let found =
                    format!("column `{name}` of row group {index}, whose pages hold {read} of {count} rows");
                let place = group.column(column.index).byte_range().0;
                options.salvage.then_some(()).ok_or_else(|| fault(source, place, found))?;
                out.cut(source, options, "rows", rows, first as u64)?;
                out.cloud.positions.truncate(first);
                wanted.iter_mut().for_each(|column| crate::columns::truncate(&mut column.values, first));
                return Ok(finish(out, wanted));
            }
            if let Some(axis) = column.axis {
                let target = out.cloud.positions[first..].iter_mut().enumerate().take(count);
                target.for_each(|(row, point)| point[axis] = get(&column.values, row));
                column.reserve(0);
            }
        }
        first += count;
    }
    Ok(finish(out, wanted))
}

/// Rows of all groups, which must be as many as the file states.
fn rows(metadata: &ParquetMetaData) -> Result<u64, String> {
    let counts = metadata.row_groups().iter().map(|group| u64::try_from(group.num_rows()).ok());
    let rows = counts.into_iter().try_fold(0u64, |sum, count| sum.checked_add(count?));
    let stated = u64::try_from(metadata.file_metadata().num_rows()).ok();
    let agreed = rows.filter(|rows| Some(*rows) == stated);
    agreed.ok_or_else(|| format!("{stated:?} rows, but {rows:?} in groups"))
}

fn finish(mut out: Decoded, wanted: Vec<Wanted>) -> Decoded {
    let attributes = wanted.into_iter().filter(|column| column.axis.is_none());
    out.cloud.attributes = attributes.map(|c| Attribute { name: c.name, values: c.values }).collect();
    out
}

/// A number of any type.
enum Value {
    Integer(i64),
    Float(f64),
}

/// Reads the values of a column in a row group; gives how many there were.
fn group_column(reader: ColumnReader, count: usize, column: &mut Wanted) -> ParquetResult<usize> {
    use ColumnReader as Reader;
    use Value::{Float, Integer};
    match reader {
        Reader::BoolColumnReader(reader) => values(reader, count, column, |&v| Integer(v.into())),
        Reader::Int32ColumnReader(reader) => values(reader, count, column, |&v| Integer(v.into())),
        Reader::Int64ColumnReader(reader) => values(reader, count, column, |&v| Integer(v)),
        Reader::FloatColumnReader(reader) => values(reader, count, column, |&v| Float(v.into())),
        Reader::DoubleColumnReader(reader) => values(reader, count, column, |&v| Float(v)),
        _ => Ok(0),
    }
}

fn values<T: DataType>(
    mut reader: ColumnReaderImpl<T>,
    count: usize,
    column: &mut Wanted,
    number: impl Fn(&T::T) -> Value,
) -> ParquetResult<usize> {
    let (mut levels, mut some) = (Vec::new(), Vec::new());
    let mut done = 0;
    while done < count {
        levels.clear();
        some.clear();
        let defined = (column.level > 0).then_some(&mut levels);
        let (read, ..) = reader.read_records(BATCH.min(count - done), defined, None, &mut some)?;
        if read == 0 {
            break;
        }
        let mut present = some.iter();
        for row in 0..read {
            let null = levels.get(row).is_some_and(|&level| level < column.level);
            match if null { None } else { present.next() } {
                Some(value) => push(column, number(value)),
                None => push_null(&mut column.values),
            }
        }
        done += read;
    }
    Ok(done)
}

/// Appends a value. Unsigned numbers are stored as the signed ones with the same bits.
fn push(column: &mut Wanted, value: Value) {
    let (whole, real) = match (value, column.kind) {
        (Value::Integer(value), Scalar::U32) => (value, f64::from(value as u32)),
        (Value::Integer(value), Scalar::U64) => (value, value as u64 as f64),
        (Value::Integer(value), _) => (value, value as f64),
        (Value::Float(value), _) => (value as i64, value),
    };
    match &mut column.values {
        Column::I8(values) => values.push(whole as i8),
        Column::U8(values) => values.push(whole as u8),
        Column::I16(values) => values.push(whole as i16),
        Column::U16(values) => values.push(whole as u16),
        Column::I32(values) => values.push(whole as i32),
        Column::U32(values) => values.push(whole as u32),
        Column::I64(values) => values.push(whole),
        Column::U64(values) => values.push(whole as u64),
        Column::F32(values) => values.push(real as f32),
        Column::F64(values) => values.push(real),
    }
}

/// Appends NaN; integers, which have none, become f64.
fn push_null(column: &mut Column) {
    match column {
        Column::F32(values) => values.push(f32::NAN),
        Column::F64(values) => values.push(f64::NAN),
        integers => {
            let mut wide = Vec::with_capacity(crate::columns::capacity(integers));
            wide.extend((0..integers.len()).map(|row| get(integers, row)));
            wide.push(f64::NAN);
            *integers = Column::F64(wide);
        }
    }
}
