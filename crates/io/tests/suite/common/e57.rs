//! An E57 file.

use e57::{E57Writer, Quaternion, Record, RecordDataType, RecordName, RecordValue, Transform, Translation};
use std::io::Cursor;

/// Two scans: so many points, Cartesian with states, intensities and colours, moved and turned; spherical, where it is.
pub fn two_scans(points: i64) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let mut writer = E57Writer::new(&mut bytes, "file").unwrap();
    let integer = |max| RecordDataType::Integer { min: 0, max };
    let record = |name, data_type| Record { name, data_type };
    let double = || RecordDataType::F64;
    let prototype = vec![
        record(RecordName::CartesianX, double()),
        record(RecordName::CartesianY, double()),
        record(RecordName::CartesianZ, double()),
        record(RecordName::CartesianInvalidState, integer(2)),
        record(RecordName::ColorRed, integer(255)),
        record(RecordName::ColorGreen, integer(255)),
        record(RecordName::ColorBlue, integer(255)),
        record(RecordName::Intensity, integer(4095)),
    ];
    let mut scan = writer.add_pointcloud("first", prototype).unwrap();
    // A quarter turn about z, then 100 along x.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let rotation = Quaternion { w: half, x: 0.0, y: 0.0, z: half };
    scan.set_transform(Some(Transform { rotation, translation: Translation { x: 100.0, y: 0.0, z: 0.0 } }));
    for i in 0..points {
        let double = |v: i64| RecordValue::Double(v as f64);
        let [state, red, intensity] =
            [i64::from(i % 4 == 0) * 2, i % 256, i % 4096].map(RecordValue::Integer);
        let (green, blue) = (RecordValue::Integer(1), RecordValue::Integer(2));
        scan.add_point(vec![double(i), double(2), double(3), state, red, green, blue, intensity]).unwrap();
    }
    scan.finalize().unwrap();
    let single = || RecordDataType::F32;
    let prototype = vec![
        record(RecordName::SphericalRange, single()),
        record(RecordName::SphericalAzimuth, double()),
        record(RecordName::SphericalElevation, double()),
    ];
    let mut scan = writer.add_pointcloud("second", prototype).unwrap();
    for azimuth in [0.0, std::f64::consts::FRAC_PI_2] {
        let values = vec![RecordValue::Single(2.0), RecordValue::Double(azimuth), RecordValue::Double(0.0)];
        scan.add_point(values).unwrap();
    }
    scan.finalize().unwrap();
    writer.finalize().unwrap();
    drop(writer);
    bytes.into_inner()
}
