//! E57: any prototype, counts and packets.

use super::Number;
use arbitrary::Arbitrary;

#[allow(dead_code, reason = "fields have ranges of their own here")]
#[path = "../../../crates/io/tests/suite/common/e57_raw.rs"]
mod raw;

/// Fields of records.
#[derive(Arbitrary, Clone, Copy, Debug)]
enum Name {
    X,
    Y,
    Z,
    Range,
    Azimuth,
    Elevation,
    Invalid,
    Intensity,
    Row,
}

#[derive(Arbitrary, Debug)]
enum Kind {
    Scaled { min: i64, bits: u8, scale: i8 },
    Integer { min: i32, bits: u8 },
    Single,
    Double,
    Text,
}

/// The parts of a file.
#[derive(Arbitrary, Debug)]
pub struct E57 {
    fields: Vec<(Name, Kind)>,
    records: Number,
    packets: Vec<Vec<Vec<u8>>>,
    scans: u8,
    pose: Option<[f32; 7]>,
}

impl E57 {
    /// The file.
    pub fn bytes(&self) -> Vec<u8> {
        let prototype: String = self.fields.iter().map(|(name, kind)| field(*name, kind)).collect();
        let packets: Vec<Vec<u8>> = self.packets.iter().filter_map(|streams| packet(streams)).collect();
        let pose = self.pose.map_or(String::new(), |[x, y, z, w, i, j, k]| {
            let float = |name: &str, value: f32| format!("<{name} type=\"Float\">{value}</{name}>");
            let of = |names: [&str; 3], values: [f32; 3]| -> String {
                names.iter().zip(values).map(|(name, value)| float(name, value)).collect()
            };
            let rotation = float("w", w) + &of(["x", "y", "z"], [i, j, k]);
            let translation = of(["x", "y", "z"], [x, y, z]);
            format!(
                "<pose type=\"Structure\"><rotation type=\"Structure\">{rotation}</rotation>\
                 <translation type=\"Structure\">{translation}</translation></pose>"
            )
        });
        raw::file(&prototype, self.records.0, &packets, usize::from(self.scans % 5), &pose)
    }
}

fn field(name: Name, kind: &Kind) -> String {
    let name = match name {
        Name::X => "cartesianX",
        Name::Y => "cartesianY",
        Name::Z => "cartesianZ",
        Name::Range => "sphericalRange",
        Name::Azimuth => "sphericalAzimuth",
        Name::Elevation => "sphericalElevation",
        Name::Invalid => "cartesianInvalidState",
        Name::Intensity => "intensity",
        Name::Row => "rowIndex",
    };
    let most = |min: i64, bits: u8| min.saturating_add(((1u128 << (bits % 64)) - 1) as i64);
    match *kind {
        Kind::Scaled { min, bits, scale } => format!(
            "<{name} type=\"ScaledInteger\" minimum=\"{min}\" maximum=\"{}\" scale=\"{}\"/>",
            most(min, bits),
            0.1 * f64::from(scale)
        ),
        Kind::Integer { min, bits } => {
            let min = i64::from(min);
            format!("<{name} type=\"Integer\" minimum=\"{min}\" maximum=\"{}\"/>", most(min, bits))
        }
        Kind::Single => format!("<{name} type=\"Float\" precision=\"single\"/>"),
        Kind::Double => format!("<{name} type=\"Float\"/>"),
        Kind::Text => format!("<{name} type=\"String\"/>"),
    }
}

/// A packet, unless it would be longer than one can be.
fn packet(streams: &[Vec<u8>]) -> Option<Vec<u8>> {
    let length: usize = streams.iter().map(|stream| stream.len() + 2).sum();
    let streams: Vec<&[u8]> = streams.iter().map(Vec::as_slice).collect();
    (length < 65_000).then(|| raw::packet(&streams))
}
