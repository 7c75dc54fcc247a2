//! A point of an E57 scan from its fields: Cartesian, or spherical where that alone is there, moved by the pose of the scan
//! (ASTM E2807, sections 8.4.4 and 8.4.22).

use super::packets::Packets;
use e57::{PointCloud, RecordName, Transform};

/// A point whose place is known.
pub(super) struct Point {
    /// In the frame of the file.
    pub position: [f64; 3],
    pub color: Option<[f32; 3]>,
    pub intensity: Option<f32>,
}

/// Fields that belong together, by the indices of their columns, and the one that says whether they are valid.
struct Group<const N: usize> {
    columns: Option<[usize; N]>,
    state: Option<usize>,
}

/// The fields of a scan that are read, and the values of some rows of them.
pub(super) struct Fields {
    cartesian: Group<3>,
    spherical: Group<3>,
    color: Group<3>,
    intensity: Group<1>,
    rotation: [[f64; 3]; 3],
    translation: [f64; 3],
    /// Values a field, none for those that are passed over.
    values: Vec<Vec<f64>>,
    kept: Vec<bool>,
}

impl Fields {
    pub fn new(scan: &PointCloud) -> Self {
        use RecordName as Name;
        let find = |name: &Name| scan.prototype.iter().position(|record| record.name == *name);
        let group = |names: [Name; 3], state: Name| {
            let [a, b, c] = names.map(|name| find(&name));
            Group { columns: a.zip(b).zip(c).map(|((a, b), c)| [a, b, c]), state: find(&state) }
        };
        let spherical = [Name::SphericalRange, Name::SphericalAzimuth, Name::SphericalElevation];
        let (rotation, translation) = pose(scan);
        let mut fields = Self {
            cartesian: group(
                [Name::CartesianX, Name::CartesianY, Name::CartesianZ],
                Name::CartesianInvalidState,
            ),
            spherical: group(spherical, Name::SphericalInvalidState),
            color: group([Name::ColorRed, Name::ColorGreen, Name::ColorBlue], Name::IsColorInvalid),
            intensity: Group {
                columns: find(&Name::Intensity).map(|column| [column]),
                state: find(&Name::IsIntensityInvalid),
            },
            rotation,
            translation,
            values: vec![Vec::new(); scan.prototype.len()],
            kept: Vec::new(),
        };
        fields.kept = (0..scan.prototype.len()).map(|field| fields.reads(field)).collect();
        fields
    }

    fn reads(&self, field: usize) -> bool {
        let triples = [&self.cartesian, &self.spherical, &self.color];
        let columns = triples.iter().flat_map(|group| group.columns).flatten();
        let states = triples.iter().filter_map(|group| group.state);
        let all = columns.chain(states).chain(self.intensity.columns.into_iter().flatten());
        all.chain(self.intensity.state).any(|read| read == field)
    }

    /// Reads the next `rows` rows, which the streams must hold. The error names a value that no point can have.
    pub fn decode(&mut self, packets: &mut Packets, rows: usize) -> Result<(), String> {
        for (field, values) in self.values.iter_mut().enumerate() {
            if self.kept[field] {
                packets.values(field, rows, values);
            } else {
                packets.skip(field, rows);
            }
        }
        let states = [
            ("Cartesian", self.cartesian.state, 2.0),
            ("spherical", self.spherical.state, 2.0),
            ("colour", self.color.state, 1.0),
            ("intensity", self.intensity.state, 1.0),
        ];
        for (name, state, most) in states {
            let odd = |value: &&f64| !(0.0..=most).contains(*value) || value.fract() != 0.0;
            if let Some(value) = state.and_then(|field| self.values[field].iter().find(odd)) {
                return Err(format!("the {name} state {value}, where 0 to {most} are known"));
            }
        }
        Ok(())
    }

    /// A point of the rows; `None` if its place is not known.
    pub fn point(&self, row: usize) -> Option<Point> {
        let local = self.valid(&self.cartesian, row).or_else(|| {
            let [range, azimuth, elevation] = self.valid(&self.spherical, row)?;
            let flat = range * elevation.cos();
            Some([flat * azimuth.cos(), flat * azimuth.sin(), range * elevation.sin()])
        })?;
        let [x, y, z] = local;
        let turned = self.rotation.map(|r| r[0] * x + r[1] * y + r[2] * z);
        Some(Point {
            position: [0, 1, 2].map(|axis| turned[axis] + self.translation[axis]),
            color: self.valid(&self.color, row).map(|color| color.map(|c| c as f32)),
            intensity: self.valid(&self.intensity, row).map(|[value]| value as f32),
        })
    }

    /// The values of a group, if it is there and valid.
    fn valid<const N: usize>(&self, group: &Group<N>, row: usize) -> Option<[f64; N]> {
        let valid = group.state.is_none_or(|field| self.values[field][row] == 0.0);
        group.columns.filter(|_| valid).map(|columns| columns.map(|field| self.values[field][row]))
    }
}

/// Rows of the rotation, and the translation, from the frame of a scan into that of the file.
fn pose(scan: &PointCloud) -> ([[f64; 3]; 3], [f64; 3]) {
    let Transform { rotation: q, translation: t } = scan.transform.clone().unwrap_or_default();
    let rotation = [
        [
            q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z,
            2.0 * (q.x * q.y - q.w * q.z),
            2.0 * (q.x * q.z + q.w * q.y),
        ],
        [
            2.0 * (q.x * q.y + q.w * q.z),
            q.w * q.w + q.y * q.y - q.x * q.x - q.z * q.z,
            2.0 * (q.y * q.z - q.w * q.x),
        ],
        [
            2.0 * (q.x * q.z - q.w * q.y),
            2.0 * (q.y * q.z + q.w * q.x),
            q.w * q.w + q.z * q.z - q.x * q.x - q.y * q.y,
        ],
    ];
    (rotation, [t.x, t.y, t.z])
}
