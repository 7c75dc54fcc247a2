//! LAS and LAZ inputs of every point format, whole and broken.

use crate::common::las::{file, file_of, length, put, records};
use crate::common::{from_bytes, shared};
use lineament::Column;
use lineament_io::{
    Error, Format, LasFrame, LasRecord, PointFormat, PointTable, ReadOptions, read, write_points_to,
};
use proptest::prelude::*;

#[test]
fn every_point_format_reads_packed_and_unpacked() {
    for format in 0..=10 {
        let plain = from_bytes(&file(format, 250, None), "a.las", &ReadOptions::default()).unwrap();
        assert_eq!((plain.format, plain.cloud.len()), (Format::Las, 250));
        assert_eq!(
            plain.cloud.positions[3],
            [-79.0 * 0.001 + 500_000.0, -15.0 * 0.001 + 5_000_000.0, 0.0 * 0.01 - 100.0]
        );
        assert_eq!(plain.crs.as_deref(), Some("ETRS89 / UTM zone 32N"));
        let column = |name: &str| &plain.cloud.attributes.iter().find(|a| a.name == name).unwrap().values;
        assert!(matches!(column("intensity"), Column::U16(v) if v[249] == 249));
        assert!(matches!(column("classification"), Column::U8(v) if v[0] == 6));
        assert!(matches!(column("return_number"), Column::U8(v) if v[0] == if format < 6 { 1 } else { 2 }));
        assert!(
            matches!(column("number_of_returns"), Column::U8(v) if v[0] == if format < 6 { 2 } else { 3 })
        );
        assert!(matches!(column("amplitude"), Column::F32(v) if v[7] == 7.0));
        assert!(matches!(column("reflectance"), Column::F64(v) if v[7] == 6.0));
        for chunk in [60, 250, 50_000] {
            let packed =
                from_bytes(&file(format, 250, Some(chunk)), "a.laz", &ReadOptions::default()).unwrap();
            assert_eq!(packed.cloud, plain.cloud, "format {format}, chunk {chunk}");
            let bare = ReadOptions { attributes: false, ..ReadOptions::default() };
            let bare = from_bytes(&file(format, 250, Some(chunk)), "a.laz", &bare).unwrap();
            assert_eq!(bare.cloud.positions, plain.cloud.positions, "format {format}, chunk {chunk}");
        }
    }
}

#[test]
fn a_large_chunk_is_unpacked_in_steps_and_gives_the_same() {
    let plain = from_bytes(&file(1, 300_000, None), "a.las", &ReadOptions::default()).unwrap();
    let options = ReadOptions { memory: Some(1 << 30), ..ReadOptions::default() };
    let packed = from_bytes(&file(1, 300_000, Some(300_000)), "a.laz", &options).unwrap();
    assert_eq!(packed.cloud, plain.cloud);
}

/// Version 1.4 may say behind the points where on earth they lie.
#[test]
fn extended_records_say_where_the_points_lie_and_are_carried_over() {
    for (format, chunk) in [(6, None), (7, Some(10))] {
        let mut file = file(format, 40, chunk);
        let there = file.windows(15).position(|w| w == b"LASF_Projection").unwrap();
        put(&mut file, there, b"SOMEONE_ELSE___");
        let end = file.len() as u64;
        for (user, data) in [("other", &b"123"[..]), ("LASF_Projection", b"PROJCS[\"Behind\"]\0")] {
            let mut record = vec![0; 60];
            put(&mut record, 2, user.as_bytes());
            put(&mut record, 18, &2112u16.to_le_bytes());
            put(&mut record, 20, &(data.len() as u64).to_le_bytes());
            file.extend([record, data.to_vec()].concat());
        }
        put(&mut file, 235, &end.to_le_bytes());
        put(&mut file, 243, &3u32.to_le_bytes());
        let scan = from_bytes(&file, "a.las", &ReadOptions::default()).unwrap();
        assert_eq!((scan.cloud.len(), scan.crs.as_deref()), (40, Some("Behind")));
        for expected in ["1 extended variable length records", "1 extended records that the header announces"]
        {
            assert!(scan.ignored.iter().any(|what| what.starts_with(expected)), "{:?}", scan.ignored);
        }
        let classes = vec![0; 40];
        let table = PointTable { cloud: &scan.cloud, classes: &classes, scores: &[], las: scan.las.as_ref() };
        let mut written = Vec::new();
        write_points_to(&mut written, PointFormat::Laz, &table).unwrap();
        let again = from_bytes(&written, "b.laz", &ReadOptions::default()).unwrap();
        assert_eq!((again.crs.as_deref(), again.cloud.positions), (Some("Behind"), scan.cloud.positions));
    }
}

#[test]
fn cut_anywhere_it_is_an_error() {
    for format in [3, 7] {
        let plain = file(format, 40, None);
        let packed = file(format, 40, Some(10));
        for (file, name) in [(plain, "cut.las"), (packed, "cut.laz")] {
            for length in (0..file.len() - 1).step_by(7) {
                let error = from_bytes(&file[..length], name, &ReadOptions::default());
                assert!(error.is_err(), "{name} of format {format} cut at {length}");
            }
        }
    }
    let plain = file(3, 40, None);
    let options = ReadOptions { salvage: true, ..ReadOptions::default() };
    let scan = from_bytes(&plain[..plain.len() - 1], "cut.las", &options).unwrap();
    assert_eq!((scan.cloud.len(), scan.missing.unwrap().expected), (39, 40));
}

#[test]
fn whole_chunks_of_a_cut_packed_file_are_salvaged() {
    let options = ReadOptions { salvage: true, ..ReadOptions::default() };
    for format in [1, 3, 6, 7] {
        let plain = from_bytes(&file(format, 95, None), "a.las", &options).unwrap();
        let packed = file(format, 95, Some(10));
        // The chunk table alone, half the file, and the first chunk.
        let start = packed.len() - plain.bytes.min(packed.len() as u64) as usize;
        for length in [packed.len() - 12, packed.len() * 9 / 10, start.max(packed.len() * 8 / 10)] {
            let scan = from_bytes(&packed[..length], "cut.laz", &options).unwrap();
            let whole = scan.cloud.len();
            assert!(
                whole.is_multiple_of(10) || whole == 95,
                "format {format}: {whole} points of {length} bytes"
            );
            assert_eq!(scan.cloud.positions, plain.cloud.positions[..whole], "format {format}");
            let missing = scan.missing.map_or((95, 95), |missing| (missing.read, missing.expected));
            assert_eq!(missing, (whole as u64, 95));
        }
        let all = from_bytes(&packed[..packed.len() - 12], "cut.laz", &options).unwrap();
        assert_eq!(all.cloud, plain.cloud, "format {format}");
    }
}

#[test]
fn points_flagged_as_withheld_or_noise_can_be_left_out() {
    for (format, chunk) in [(1, None), (1, Some(10)), (7, None), (7, Some(10))] {
        let mut rows = records(format, 60);
        let width = length(format);
        for (i, row) in rows.chunks_exact_mut(width).enumerate() {
            let current = format >= 6;
            let class = if i % 6 == 0 {
                7
            } else if i % 6 == 1 && current {
                18
            } else {
                2
            };
            let withheld = i % 6 == 2;
            if current {
                (row[15], row[16]) = (u8::from(withheld) << 2, class);
            } else {
                row[15] = class | u8::from(withheld) << 7;
            }
        }
        let bytes = file_of(format, rows, chunk, None);
        let read = |options| from_bytes(&bytes, "a.las", &options).unwrap();
        let whole = read(ReadOptions::default());
        assert_eq!((whole.cloud.len(), whole.noise), (60, 0));
        let without = ReadOptions { without_noise: true, attributes: false, ..ReadOptions::default() };
        let scan = read(without.clone());
        let left = if format < 6 { 20 } else { 30 };
        assert_eq!((scan.cloud.len(), scan.noise, scan.cloud.attributes.len()), (60 - left, left, 0));
        assert_eq!(scan.cloud.positions[0], whole.cloud.positions[if format < 6 { 1 } else { 3 }]);
        // Classes that are asked for stay.
        let named = read(ReadOptions { classes: vec![7], ..without });
        assert_eq!((named.cloud.len(), named.noise), (10, 10));
    }
}

#[test]
fn claims_beyond_the_file_are_refused() {
    for claim in [1u64 << 31, 1 << 32, 1 << 63, u64::MAX] {
        for chunk in [None, Some(10)] {
            let mut bytes = file(7, 40, chunk);
            put(&mut bytes, 247, &claim.to_le_bytes());
            assert!(from_bytes(&bytes, "claim.laz", &ReadOptions::default()).is_err());
        }
    }
    let mut bytes = file(7, 40, None);
    put(&mut bytes, 100, &u32::MAX.to_le_bytes());
    let error = from_bytes(&bytes, "records.las", &ReadOptions::default()).unwrap_err().to_string();
    assert!(error.contains("record 2 of 4294967295"), "{error}");
}

#[test]
fn files_of_other_programs_read_whole() {
    for (name, count) in [("plane.laz", 28185), ("simple.las", 1065), ("simple.laz", 1065)] {
        let Some(path) = shared(&format!("formats/{name}")) else { continue };
        let scan = read(&path, &ReadOptions::default()).unwrap();
        assert_eq!((scan.format, scan.cloud.len()), (Format::Las, count), "{name}");
    }
    if let (Some(las), Some(laz)) = (shared("formats/simple.las"), shared("formats/simple.laz")) {
        let (las, laz) =
            (read(&las, &ReadOptions::default()).unwrap(), read(&laz, &ReadOptions::default()).unwrap());
        assert_eq!(las.cloud, laz.cloud);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]
    #[test]
    fn any_change_of_bytes_is_read_or_refused(
        format in 0u8..=10,
        packed in any::<bool>(),
        changes in proptest::collection::vec((0usize..4000, any::<u8>()), 1..4),
    ) {
        let mut bytes = file(format, 40, packed.then_some(10));
        for (at, value) in changes {
            let at = at % bytes.len();
            bytes[at] = value;
        }
        match from_bytes(&bytes, "changed.laz", &ReadOptions::default()) {
            Ok(scan) => prop_assert!(scan.cloud.attributes.iter().all(|a| a.values.len() == scan.cloud.len())),
            Err(Error::OutputIsInput { .. }) => prop_assert!(false),
            Err(_) => {}
        }
    }
}

/// The reference system that these well-known text and code of GeoTIFF keys give.
fn epsg(wkt: &str, projected: u16) -> Option<u32> {
    let record = |id, data| LasRecord { user: "LASF_Projection".into(), id, data };
    let keys = [1, 1, 0, 1, 3072, 0, 1, projected].map(u16::to_le_bytes).concat();
    let records = vec![record(34735, keys), record(2112, wkt.as_bytes().to_vec())];
    LasFrame { records, ..LasFrame::default() }.epsg()
}

#[test]
fn geo_keys_give_the_code_that_well_known_text_has_not() {
    let esri = "PROJCS[\"NAD_1983_StatePlane_California_III\",GEOGCS[\"GCS\"],UNIT[\"Meter\",1]]";
    assert_eq!(epsg(esri, 26943), Some(26943));
    let coded = "PROJCS[\"p\",GEOGCS[\"g\"],AUTHORITY[\"EPSG\",\"2180\"]]";
    assert_eq!(epsg(coded, 26943), Some(2180));
    assert_eq!(epsg(esri, 32767), None);
}

#[test]
fn geotiff_keys_name_the_epsg_code() {
    let keyed = |entries: [[u16; 4]; 2]| {
        let mut file = file(1, 3, None);
        let there = file.windows(15).position(|w| w == b"LASF_Projection").unwrap();
        put(&mut file, there + 16, &34735u16.to_le_bytes());
        // The data begin 52 bytes after the name; what is left of the text are entries of no key.
        let length = u16::from_le_bytes([file[there + 18], file[there + 19]]);
        put(&mut file, there + 52, &vec![0; usize::from(length)]);
        let keys = [[1, 1, 0, 2], entries[0], entries[1]].concat();
        keys.iter().enumerate().for_each(|(i, key)| put(&mut file, there + 52 + 2 * i, &key.to_le_bytes()));
        from_bytes(&file, "a.las", &ReadOptions::default()).unwrap()
    };
    let scan = keyed([[1024, 0, 1, 1], [3072, 0, 1, 25832]]);
    assert_eq!((scan.epsg, scan.crs.as_deref()), (Some(25832), Some("EPSG:25832")));
    assert_eq!(keyed([[1024, 0, 1, 2], [2048, 0, 1, 4326]]).epsg, Some(4326));
    // A projected system defined by other keys is not the geographic one under it.
    assert_eq!(keyed([[3072, 0, 1, 32767], [2048, 0, 1, 4258]]).epsg, None);
}
