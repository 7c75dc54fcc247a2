//! Reference systems: of the input, of a file beside it, as asked for; and the unit that follows.

use crate::common::from_bytes;
use lineament::Cloud;
use lineament_io::{LasFrame, PointFormat, PointTable, ReadOptions, Scan, Unit, read, write_points_to};

const ROWS: &str = "500000.5 5400000 100\n500001 5400001 101\n500002 5400000 102\n";
const GAUSS: &str = "PROJCS[\"DHDN / zone 3\",GEOGCS[\"DHDN\",DATUM[\"d\",SPHEROID[\"s\",6377397,299.15]],UNIT[\"degree\",0.01745]],\
    UNIT[\"metre\",1],AUTHORITY[\"EPSG\",\"31467\"]]";

fn asked(crs: u32) -> ReadOptions {
    ReadOptions { crs: Some(crs), ..ReadOptions::default() }
}

/// A LAS file in this system.
fn las(frame: Option<&LasFrame>) -> Vec<u8> {
    let cloud = Cloud::new(vec![[5e5, 5.4e6, 1.0], [500_001.0, 5_400_001.0, 2.0]]);
    let table = PointTable { cloud: &cloud, classes: &[], scores: &[], las: frame };
    let mut bytes = Vec::new();
    write_points_to(&mut bytes, PointFormat::Las, &table).unwrap();
    bytes
}

#[test]
fn a_system_that_is_asked_for_goes_over_that_of_the_input_with_a_warning() {
    let scan = from_bytes(ROWS.as_bytes(), "a.xyz", &asked(25832)).unwrap();
    assert_eq!((scan.epsg, scan.unit, scan.warnings.len()), (Some(25832), Some(Unit::Metre), 0));
    let frame = LasFrame::of_system(Some(31467), None).unwrap();
    let same = from_bytes(&las(Some(&frame)), "a.las", &asked(31467)).unwrap();
    assert_eq!((same.epsg, same.warnings.len()), (Some(31467), 0));
    let other = from_bytes(&las(Some(&frame)), "a.las", &asked(25832)).unwrap();
    assert_eq!(other.epsg, Some(25832));
    assert!(other.warnings[0].contains("EPSG:31467"), "{:?}", other.warnings);
    // An output like the input names the system that was asked for.
    let again = from_bytes(&las(other.las.as_ref()), "b.las", &ReadOptions::default()).unwrap();
    assert_eq!(again.epsg, Some(25832));
    let unknown = from_bytes(ROWS.as_bytes(), "a.xyz", &asked(7019)).unwrap_err().to_string();
    assert!(unknown.contains("EPSG:7019"), "{unknown}");
}

#[test]
fn well_known_text_beside_an_input_places_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("a.xyz"), ROWS).unwrap();
    std::fs::write(path("a.prj"), GAUSS).unwrap();
    let read = |name: &str| -> Scan { read(&path(name), &ReadOptions::default()).unwrap() };
    let scan = read("a.xyz");
    assert_eq!((scan.epsg, scan.unit), (Some(31467), Some(Unit::Metre)));
    assert_eq!((scan.wkt.as_deref(), scan.beside), (Some(GAUSS), vec![path("a.prj")]));
    // A system of its own outweighs it, and text of old is none.
    std::fs::write(path("b.las"), las(LasFrame::of_system(Some(25832), None).as_ref())).unwrap();
    std::fs::write(path("b.prj"), GAUSS).unwrap();
    assert_eq!(read("b.las").epsg, Some(25832));
    std::fs::write(path("c.xyz"), ROWS).unwrap();
    std::fs::write(path("c.prj"), "Projection UTM\nZone 32\n").unwrap();
    assert_eq!(read("c.xyz").crs, None);
}

#[test]
fn las_outputs_hold_the_system_of_inputs_of_other_formats() {
    for (epsg, wkt) in [(Some(31467), Some(GAUSS)), (Some(31467), None)] {
        let frame = LasFrame::of_system(epsg, wkt).unwrap();
        let scan = from_bytes(&las(Some(&frame)), "a.las", &ReadOptions::default()).unwrap();
        assert_eq!((scan.epsg, scan.wkt.as_deref()), (epsg, wkt));
        assert_eq!(scan.las.unwrap().point_format, if wkt.is_some() { 6 } else { 1 });
    }
    assert_eq!(LasFrame::of_system(None, None), None);
}

#[test]
fn degrees_beside_metres_are_a_warning() {
    for code in [4326, 4258] {
        let scan = from_bytes(b"8.5 49.1 100\n8.6 49.2 101\n8.7 49.1 102\n", "a.xyz", &asked(code)).unwrap();
        assert!(scan.warnings[0].contains("project the points first"), "{:?}", scan.warnings);
        assert_eq!(scan.unit, None);
    }
    assert_eq!(from_bytes(ROWS.as_bytes(), "a.xyz", &asked(4978)).unwrap().warnings.len(), 0);
}
