//! What a small file can ask for by a count, a name, a depth or a repetition is bounded before it is done.

use crate::common::e57_raw::{self, packet, scaled};
use crate::common::{copc, from_bytes, las, parquet, spent};
use ::parquet::basic::Compression;
use ::parquet::file::metadata::{
    FileMetaData, ParquetMetaDataBuilder, ParquetMetaDataReader, ParquetMetaDataWriter,
};
use ::parquet::file::properties::WriterVersion;
use bytes::Bytes;
use lineament::mesh::MeshPoints;
use lineament::{Attribute, Cloud, Column};
use lineament_io::{PointFormat, PointTable, ReadOptions, write_points_to};
use std::time::Duration;

/// Reads bytes; the error as text. All of it at once.
fn read(bytes: &[u8], name: &str) -> Result<Vec<[f64; 3]>, String> {
    let start = spent();
    let scan = from_bytes(bytes, name, &ReadOptions::default());
    let took = spent() - start;
    assert!(took < Duration::from_secs(8), "{name}: {took:?}");
    scan.map(|scan| scan.cloud.positions).map_err(|error| error.to_string())
}

fn refusal(bytes: &[u8], name: &str) -> String {
    read(bytes, name).unwrap_err()
}

#[test]
fn e57_fields_of_one_value_take_no_bits_and_give_the_points_that_are_announced() {
    let prototype = ["cartesianX", "cartesianY", "cartesianZ"].map(|name| scaled(name, 5, 5)).concat();
    let file = |records| e57_raw::file(&prototype, records, &[], 1, "");
    assert_eq!(read(&file(2), "constant.e57"), Ok(vec![[0.5; 3]; 2]));
    for records in [1 << 40, u64::MAX] {
        let message = refusal(&file(records), "constant.e57");
        assert!(message.contains("beyond the bound"), "{message}");
    }
    let valid = format!("{}<cartesianInvalidState type=\"Integer\" minimum=\"2\" maximum=\"2\"/>", prototype);
    let message = refusal(&e57_raw::file(&valid, 1 << 50, &[], 1, ""), "invalid.e57");
    assert!(message.contains("beyond the bound"), "{message}");
}

#[test]
fn e57_streams_may_run_ahead_of_each_other() {
    let prototype = ["cartesianX", "cartesianY", "cartesianZ"].map(|name| scaled(name, 0, 255)).concat();
    let packets =
        [packet(&[&[10, 20, 30], &[], &[]]), packet(&[&[], &[1], &[4, 5]]), packet(&[&[], &[2, 3], &[6]])];
    let file = e57_raw::file(&prototype, 3, &packets, 1, "");
    assert_eq!(
        read(&file, "ahead.e57").unwrap(),
        [[1.0, 0.1, 0.4], [2.0, 0.2, 0.5], [3.0, 0.30000000000000004, 0.6000000000000001]]
    );
    let message = refusal(&e57_raw::file(&prototype, 4, &packets, 1, ""), "short.e57");
    assert!(message.contains("scan 1, point 3 of 4"), "{message}");
}

#[test]
fn e57_scans_that_share_their_points_and_xml_beyond_memory_are_refused() {
    let prototype = ["cartesianX", "cartesianY", "cartesianZ"].map(|name| scaled(name, 0, 1)).concat();
    let packets = vec![packet(&[&[0x55; 3000], &[0; 3000], &[0xff; 3000]])];
    assert_eq!(read(&e57_raw::file(&prototype, 24_000, &packets, 1, ""), "one.e57").unwrap().len(), 24_000);
    let message = refusal(&e57_raw::file(&prototype, 24_000, &packets, 50, ""), "many.e57");
    assert!(message.contains("scans share their bytes"), "{message}");
    let message =
        refusal(&e57_raw::file(&prototype, 24_000, &packets, 1, &"<a/>".repeat(400_000)), "xml.e57");
    assert!(message.contains("XML that takes"), "{message}");
}

/// A Parquet file whose metadata is changed by `change`.
fn changed(bytes: &[u8], change: impl Fn(ParquetMetaDataBuilder) -> ParquetMetaDataBuilder) -> Vec<u8> {
    let metadata = ParquetMetaDataReader::new().parse_and_finish(&Bytes::from(bytes.to_vec())).unwrap();
    let end =
        bytes.len() - 8 - u32::from_le_bytes(bytes[bytes.len() - 8..][..4].try_into().unwrap()) as usize;
    let mut file = bytes[..end].to_vec();
    let mut rest = Vec::new();
    ParquetMetaDataWriter::new(&mut rest, &change(metadata.into_builder()).build()).finish().unwrap();
    file.extend(rest);
    file
}

#[test]
fn parquet_row_groups_that_share_a_page_are_bounded_by_what_they_unpack_to() {
    let one = parquet::file(Compression::SNAPPY, WriterVersion::PARQUET_1_0, false, 100_000);
    let file = changed(&one, |mut builder| {
        let group = builder.take_row_groups().remove(0).into_builder().set_num_rows(1).build().unwrap();
        let old = builder.build();
        let old = old.file_metadata();
        let whole = FileMetaData::new(
            old.version(),
            1000,
            old.created_by().map(String::from),
            old.key_value_metadata().cloned(),
            old.schema_descr_ptr(),
            old.column_orders().cloned(),
        );
        ParquetMetaDataBuilder::new(whole).set_row_groups(vec![group; 1000])
    });
    let message = refusal(&file, "shared.parquet");
    assert!(message.contains("with which the pages unpack to more than twice that"), "{message}");
}

#[test]
fn a_dictionary_of_one_value_that_stands_for_millions_of_rows_is_refused() {
    assert_eq!(read(&parquet::constant(50_000), "few.parquet").unwrap().len(), 50_000);
    let file = parquet::constant(2_500_000);
    assert!(file.len() < 30_000, "{}", file.len());
    let message = refusal(&file, "many.parquet");
    assert!(message.contains("2500000 points that unpack to") && message.contains("--memory"), "{message}");
}

#[test]
fn parquet_pages_without_the_rows_are_named() {
    let one = parquet::file(Compression::UNCOMPRESSED, WriterVersion::PARQUET_1_0, false, 10);
    let metadata =
        |bytes: &[u8]| ParquetMetaDataReader::new().parse_and_finish(&Bytes::from(bytes.to_vec())).unwrap();
    assert_eq!(metadata(&one).num_row_groups(), 1);
    // The thrift number of rows, in the group and in the whole: zigzag of 10 is 20, of 12 is 24.
    let at: Vec<usize> = (0..one.len() - 1).filter(|&i| one[i] == 0x16 && one[i + 1] == 20).collect();
    let mut file = one.clone();
    at.iter().for_each(|&i| file[i + 1] = 24);
    let message = refusal(&file, "few.parquet");
    assert!(message.contains("whose pages hold 10 of 12 rows"), "{message}");
}

#[test]
fn a_parquet_schema_of_groups_inside_each_other_is_refused() {
    let mut metadata = vec![0x29, 0xfc, 0x90, 0x4e];
    (0..10_000).for_each(|_| metadata.extend([0x48, 1, b'n', 0x15, 2, 0]));
    metadata.push(0);
    let length = (metadata.len() as u32).to_le_bytes();
    let message = refusal(&[b"PAR1", metadata.as_slice(), &length, b"PAR1"].concat(), "deep.parquet");
    assert!(message.contains("groups inside each other"), "{message}");
}

fn gltf(nodes: usize, primitives: usize, accessor: &str) -> Vec<u8> {
    let list = |item: &str, count: usize| vec![item.to_string(); count].join(",");
    let primitive: Vec<String> =
        (0..primitives).map(|i| format!("{{\"attributes\":{{\"POSITION\":{i}}}}}")).collect();
    let all: Vec<String> = (0..nodes).map(|i| i.to_string()).collect();
    format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"scenes\":[{{\"nodes\":[{}]}}],\"nodes\":[{}],\"meshes\":[{{\"primitives\":[{}]}}],\
         \"accessors\":[{}],\"bufferViews\":[{{\"buffer\":0,\"byteLength\":48}}],\
         \"buffers\":[{{\"byteLength\":48,\"uri\":\"data:;base64,{}\"}}]}}",
        all.join(","),
        list("{\"mesh\":0}", nodes),
        primitive.join(","),
        list(accessor, primitives),
        "AACAPwAAAEAAAEBA".repeat(4)
    )
    .into_bytes()
}

#[test]
fn gltf_nodes_times_primitives_are_bounded_by_their_vertices() {
    let accessor = |count: usize| {
        format!("{{\"bufferView\":0,\"componentType\":5126,\"count\":{count},\"type\":\"VEC3\"}}")
    };
    assert_eq!(read(&gltf(3, 2, &accessor(4)), "few.gltf").unwrap().len(), 24);
    assert_eq!(read(&gltf(20_000, 20_000, &accessor(0)), "none.gltf").unwrap().len(), 0);
    let message = refusal(&gltf(20_000, 20_000, &accessor(4)), "many.gltf");
    assert!(message.contains("beyond the bound"), "{message}");
    let sparse = "{\"bufferView\":0,\"componentType\":5126,\"count\":1,\"type\":\"VEC3\",\"sparse\":{\"count\":4,\
        \"indices\":{\"bufferView\":0,\"componentType\":5121},\"values\":{\"bufferView\":0}}}";
    assert!(refusal(&gltf(1, 1, sparse), "sparse.gltf").contains("4 sparse elements of 1"));
}

#[test]
fn gltf_primitives_that_share_their_triangles_are_bounded() {
    // Each a strip of 50,000 triangles from 50,002 bytes, which all of them share.
    let strip = |primitives: usize| {
        let primitive = "{\"attributes\":{\"POSITION\":0},\"indices\":1,\"mode\":5}";
        format!(
            "{{\"asset\":{{\"version\":\"2.0\"}},\"meshes\":[{{\"primitives\":[{}]}}],\"accessors\":[\
             {{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"}},\
             {{\"bufferView\":1,\"componentType\":5121,\"count\":50002,\"type\":\"SCALAR\"}}],\
             \"bufferViews\":[{{\"buffer\":0,\"byteLength\":48}},{{\"buffer\":1,\"byteLength\":50002}}],\
             \"buffers\":[{{\"byteLength\":48,\"uri\":\"data:;base64,{}\"}},{{\"byteLength\":50002,\"uri\":\"data:;base64,{}AA==\"}}]}}",
            vec![primitive; primitives].join(","),
            "AACAPwAAAEAAAEBA".repeat(4),
            "AAAA".repeat(16_667)
        )
    };
    let options = ReadOptions { mesh: Some(MeshPoints::Vertices), ..ReadOptions::default() };
    let read = |primitives: usize| from_bytes(strip(primitives).as_bytes(), "shared.gltf", &options);
    assert!(read(20).is_ok());
    let message = read(400).unwrap_err().to_string();
    assert!(message.contains("triangles of all nodes, beyond the bound"), "{message}");
}

/// A table of no points with these attributes.
fn written(format: PointFormat, names: &[String]) -> Vec<u8> {
    let values = Column::U8(vec![7; 60]);
    let attributes =
        names.iter().map(|name| Attribute { name: name.clone(), values: values.clone() }).collect();
    let cloud = Cloud { positions: vec![[1.0, 2.0, 3.0]; 60], attributes };
    let table = PointTable { cloud: &cloud, classes: &[0; 60], scores: &[], las: None };
    let mut bytes = Vec::new();
    write_points_to(&mut bytes, format, &table).unwrap();
    bytes
}

#[test]
fn entries_of_an_archive_that_share_bytes_are_refused() {
    let mut npz = written(PointFormat::Npz, &["a".into(), "b".into()]);
    assert!(read(&npz, "whole.npz").is_ok());
    let heads: Vec<usize> = memchr::memmem::find_iter(&npz, b"PK\x01\x02").collect();
    // Where an entry begins stands at the end of its extra fields, behind the name.
    let place =
        |head: usize| head + 46 + usize::from(u16::from_le_bytes([npz[head + 28], npz[head + 29]])) + 20;
    let (from, to) = (place(heads[0]), place(heads[1]));
    npz.copy_within(from..from + 8, to);
    let message = refusal(&npz, "overlap.npz");
    assert!(message.contains("begins within another one"), "{message}");
}

#[test]
fn a_name_times_a_count_is_bounded() {
    let name = "n".repeat(60_000);
    let pcd = format!(
        "FIELDS x y z {name}\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 10000\nWIDTH 0\nHEIGHT 1\nDATA ascii\n"
    );
    let message = refusal(pcd.as_bytes(), "names.pcd");
    assert!(message.contains("beyond the bound"), "{message}");
}

#[test]
fn twenty_thousand_columns_of_one_name_get_names_of_their_own() {
    let start = spent();
    let ply = written(PointFormat::Ply, &vec!["a".to_string(); 20_000]);
    let scan = from_bytes(&ply, "names.ply", &ReadOptions::default()).unwrap();
    let took = spent() - start;
    assert!(took < Duration::from_secs(8), "{took:?}");
    let mut names: Vec<&str> = scan.cloud.attributes.iter().map(|a| a.name.as_str()).collect();
    assert_eq!(names[1..5], ["a", "input_a", "input_a_2", "input_a_3"]);
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), 20_001);
}

#[test]
fn nodes_of_an_octree_that_share_a_chunk_are_refused() {
    let mut bytes = copc::file(200);
    let bounds = Some([[0.0; 3], [1e7; 3]]);
    let options = ReadOptions { bounds, ..Default::default() };
    assert_eq!(from_bytes(&bytes, "octree.laz", &options).unwrap().cloud.len(), 200);
    // The second entry of the hierarchy gets the place of the first.
    let page = u64::from_le_bytes(bytes[375 + 54 + 40..][..8].try_into().unwrap()) as usize;
    let first: Vec<u8> = bytes[page + 16..page + 28].to_vec();
    bytes[page + 48..page + 60].copy_from_slice(&first);
    let message = from_bytes(&bytes, "octree.laz", &options).unwrap_err().to_string();
    assert!(message.contains("nodes that share a chunk"), "{message}");
}

#[test]
fn a_million_empty_records_behind_the_points_are_passed_over_at_once() {
    let mut laz = las::file(7, 40, Some(10));
    let at = laz.len() as u64;
    laz[235..243].copy_from_slice(&at.to_le_bytes());
    laz[243..247].copy_from_slice(&1_000_000u32.to_le_bytes());
    laz.resize(laz.len() + 60_000_000, 0);
    assert_eq!(read(&laz, "records.laz").unwrap().len(), 40);
}

#[test]
fn parquet_pages_without_a_value_count_for_the_time_they_take() {
    let one = parquet::file(Compression::UNCOMPRESSED, WriterVersion::PARQUET_1_0, false, 10);
    // A page of no bytes: its kind, both its sizes, and a data page of no values in thrift's compact form.
    let page = [0x15, 0, 0x15, 0, 0x15, 0, 0x2c, 0x15, 0, 0x15, 0, 0x15, 6, 0x15, 6, 0, 0];
    let pages = |count: usize| {
        let body = [b"PAR1".as_slice(), &page.repeat(count), &one[4..]].concat();
        changed(&body, |mut builder| {
            let group = builder.take_row_groups().remove(0);
            let columns = group.columns().iter().map(|column| {
                let size = (page.len() * count) as i64;
                let column = column.clone().into_builder().set_data_page_offset(4);
                column.set_total_compressed_size(size).set_total_uncompressed_size(size).build().unwrap()
            });
            let group = group.clone().into_builder().set_column_metadata(columns.collect()).build().unwrap();
            builder.set_row_groups(vec![group])
        })
    };
    let message = refusal(&pages(10), "few.parquet");
    assert!(message.contains("whose pages hold 0 of 10 rows"), "{message}");
    let message = refusal(&pages(400_000), "many.parquet");
    assert!(message.contains("with which the pages unpack to more than twice that"), "{message}");
}
