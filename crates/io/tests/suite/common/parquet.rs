//! Parquet files in every form that other programs write.

use ::parquet::basic::Compression;
use ::parquet::data_type::{DoubleType, FloatType, Int32Type};
use ::parquet::file::properties::{WriterProperties, WriterVersion};
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::parser::parse_message_type;
use std::sync::Arc;

/// Its multiples have bits that cannot be packed: pages of the second version then stay as they are.
pub const MIX: u64 = 0x9e37_79b9_7f4a_7c15;

/// A Parquet file of x, y, z and a column of small integers with nulls, in the given form.
pub fn file(codec: Compression, version: WriterVersion, dictionary: bool, rows: usize) -> Vec<u8> {
    let schema = "message m { required double x; required double y; required float z; \
        optional int32 n (integer(32, false)); }";
    let properties = WriterProperties::builder()
        .set_compression(codec)
        .set_writer_version(version)
        .set_dictionary_enabled(dictionary)
        .set_write_page_header_statistics(true)
        .build();
    let schema = Arc::new(parse_message_type(schema).unwrap());
    let mut writer = SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties)).unwrap();
    let mut group = writer.next_row_group().unwrap();
    let doubles: Vec<f64> = (0..rows).map(|i| (i % 50) as f64).collect();
    let mixed: Vec<f64> = (0..rows as u64).map(|i| f64::from_bits(i.wrapping_mul(MIX) >> 2)).collect();
    let floats: Vec<f32> = doubles.iter().map(|&v| v as f32 / 4.0).collect();
    let levels: Vec<i16> = (0..rows).map(|i| (i % 2) as i16).collect();
    let integers: Vec<i32> = (0..rows as i32 / 2).map(|i| i - 1).collect();
    for column in 0..4 {
        let mut to = group.next_column().unwrap().unwrap();
        match column {
            0 => to.typed::<DoubleType>().write_batch(&doubles, None, None),
            1 => to.typed::<DoubleType>().write_batch(&mixed, None, None),
            2 => to.typed::<FloatType>().write_batch(&floats, None, None),
            _ => to.typed::<Int32Type>().write_batch(&integers, Some(&levels), None),
        }
        .unwrap();
        to.close().unwrap();
    }
    group.close().unwrap();
    writer.into_inner().unwrap()
}

/// A Parquet file of x, y and z that are 0 in all rows: dictionaries of one value, and runs of it.
pub fn constant(rows: usize) -> Vec<u8> {
    let schema = Arc::new(
        parse_message_type("message m { required float x; required float y; required float z; }").unwrap(),
    );
    let mut writer = SerializedFileWriter::new(Vec::new(), schema, Arc::default()).unwrap();
    let mut group = writer.next_row_group().unwrap();
    while let Some(mut column) = group.next_column().unwrap() {
        column.typed::<FloatType>().write_batch(&vec![0.0; rows], None, None).unwrap();
        column.close().unwrap();
    }
    group.close().unwrap();
    writer.into_inner().unwrap()
}

/// Every way to pack a column.
pub fn codecs() -> [Compression; 7] {
    use Compression::{BROTLI, GZIP, LZ4, LZ4_RAW, SNAPPY, UNCOMPRESSED, ZSTD};
    let (gzip, brotli, zstd) = (Default::default(), Default::default(), Default::default());
    [UNCOMPRESSED, SNAPPY, GZIP(gzip), BROTLI(brotli), LZ4, LZ4_RAW, ZSTD(zstd)]
}
