//! GeoPackages (OGC 12-128r18, version 1.3): layers of geometries with z in the frame of the input, their attributes, and the
//! reference system of the input.

use super::sqlite::{Table, Value, database};
use std::io::{self, Write};

/// `GPKG`, and the version.
const APPLICATION: u32 = 0x4750_4b47;
const VERSION: u32 = 10_300;
/// The time of the last change: the time of writing would make bytes differ between runs.
const CHANGED: &str = "1970-01-01T00:00:00.000Z";
/// Number of a reference system that is known by its name alone.
const UNNUMBERED: i64 = 100_000;

/// A geometry.
pub(in crate::write) enum Shape {
    Point([f64; 3]),
    Line(Vec<[f64; 3]>),
    /// Rings, the outer one first, each ending where it begins.
    Polygon(Vec<Vec<[f64; 3]>>),
}

/// A layer: features of one type.
pub(in crate::write) struct Layer {
    pub name: &'static str,
    /// Type of the geometries in the standard.
    pub geometry: &'static str,
    /// Attributes in SQL, with commas between them.
    pub columns: &'static str,
    pub features: Vec<(Shape, Vec<Value>)>,
}

/// Writes a database of layers. `crs` is `EPSG:` and a code or a name, `wkt` its definition.
pub(in crate::write) fn write(
    out: &mut dyn Write,
    layers: Vec<Layer>,
    crs: Option<&str>,
    wkt: Option<&str>,
) -> io::Result<()> {
    let (systems, id) = reference_systems(crs, wkt);
    let counts = layers.iter().zip(1..);
    let counts =
        counts.map(|(l, i)| (i, vec![text(l.name), Value::Integer(l.features.len() as i64)])).collect();
    let sequence = Table {
        name: "sqlite_sequence",
        sql: "CREATE TABLE sqlite_sequence(name,seq)".into(),
        rows: counts,
        unique: vec![],
    };
    let mut tables = vec![systems, contents(&layers, id), geometry_columns(&layers, id), sequence];
    tables.extend(layers.into_iter().map(|layer| features(layer, id)));
    out.write_all(&database(&tables, APPLICATION, VERSION)?)
}

pub(in crate::write) fn text(text: &str) -> Value {
    Value::Text(text.into())
}

fn table(name: &'static str, columns: &str, rows: Vec<(i64, Vec<Value>)>) -> Table {
    Table { name, sql: format!("CREATE TABLE {name} ({columns})"), rows, unique: Vec::new() }
}

/// The table of a layer.
fn features(layer: Layer, srs: i64) -> Table {
    let Layer { name, geometry, columns, features } = layer;
    let columns = format!("fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom {geometry}, {columns}");
    let row = |(i, (shape, values)): (i64, (Shape, Vec<Value>))| {
        (i, [vec![Value::Null, shape.value(srs)], values].concat())
    };
    table(name, &columns, (1..).zip(features).map(row).collect())
}

impl Shape {
    fn points(&self) -> Vec<[f64; 3]> {
        match self {
            Shape::Point(point) => vec![*point],
            Shape::Line(points) => points.clone(),
            Shape::Polygon(rings) => rings.concat(),
        }
    }

    /// The geometry with its header, and the box around it unless it is a point.
    fn value(&self, srs: i64) -> Value {
        let points = self.points();
        let around = !matches!(self, Shape::Point(_));
        // Little endian; the kind of box is in bits 1 to 3, 2 being x, y and z.
        let mut bytes = vec![b'G', b'P', 0, if around { 0b101 } else { 1 }];
        bytes.extend((srs as i32).to_le_bytes());
        let limits = (0..3).filter(|_| around).filter_map(|axis| extent(&points, axis)).flatten();
        limits.for_each(|c| bytes.extend(c.to_le_bytes()));
        self.wkb(&mut bytes);
        Value::Blob(bytes)
    }

    /// Well-known binary with z.
    fn wkb(&self, bytes: &mut Vec<u8>) {
        let kind: u32 = match self {
            Shape::Point(_) => 1001,
            Shape::Line(_) => 1002,
            Shape::Polygon(_) => 1003,
        };
        bytes.push(1);
        bytes.extend(kind.to_le_bytes());
        let list = |points: &[[f64; 3]], bytes: &mut Vec<u8>| {
            bytes.extend((points.len() as u32).to_le_bytes());
            points.iter().flatten().for_each(|c| bytes.extend(c.to_le_bytes()));
        };
        match self {
            Shape::Line(points) => list(points, bytes),
            Shape::Point(point) => point.iter().for_each(|c| bytes.extend(c.to_le_bytes())),
            Shape::Polygon(rings) => {
                bytes.extend((rings.len() as u32).to_le_bytes());
                rings.iter().for_each(|ring| list(ring, bytes));
            }
        }
    }
}

/// Least and greatest coordinate of points on an axis; `None` if there are none.
fn extent(points: &[[f64; 3]], axis: usize) -> Option<[f64; 2]> {
    let limit = |pick: fn(f64, f64) -> f64| points.iter().map(|p| p[axis]).reduce(pick);
    Some([limit(f64::min)?, limit(f64::max)?])
}

/// The reference systems that every file has, and that of the input with its number.
fn reference_systems(crs: Option<&str>, wkt: Option<&str>) -> (Table, i64) {
    let row = |name: &str, organisation: &str, id: i64, definition: &str| {
        (
            id,
            vec![
                text(name),
                Value::Null,
                text(organisation),
                Value::Integer(id),
                text(definition),
                Value::Null,
            ],
        )
    };
    let mut rows = vec![
        row("Undefined Cartesian SRS", "NONE", -1, "undefined"),
        row("Undefined geographic SRS", "NONE", 0, "undefined"),
        row("WGS 84 geodetic", "EPSG", 4326, WGS84),
    ];
    let Some(crs) = crs else { return (srs_table(rows), -1) };
    let definition = wkt.unwrap_or("undefined");
    let code = crs.strip_prefix("EPSG:").and_then(|code| code.parse::<u16>().ok()).map(i64::from);
    let id = code.unwrap_or(UNNUMBERED);
    if id != 4326 {
        rows.push(row(crs, if code.is_some() { "EPSG" } else { "NONE" }, id, definition));
        rows.sort_by_key(|row| row.0);
    }
    (srs_table(rows), id)
}

const WGS84: &str = "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],\
    PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433],AUTHORITY[\"EPSG\",\"4326\"]]";

fn srs_table(rows: Vec<(i64, Vec<Value>)>) -> Table {
    let columns = "srs_name TEXT NOT NULL, srs_id INTEGER NOT NULL PRIMARY KEY, organization TEXT NOT NULL, \
        organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT";
    table("gpkg_spatial_ref_sys", columns, rows)
}

fn contents(layers: &[Layer], srs: i64) -> Table {
    let columns = "table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE, \
        description TEXT DEFAULT '', last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')), \
        min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, srs_id INTEGER, \
        CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id)";
    let row = |(index, layer): (i64, &Layer)| {
        let points: Vec<[f64; 3]> = layer.features.iter().flat_map(|(shape, _)| shape.points()).collect();
        let [x, y] = [0, 1].map(|axis| extent(&points, axis).map(|limits| limits.map(Value::Real)));
        let [[min_x, max_x], [min_y, max_y]] =
            [x, y].map(|limits| limits.unwrap_or([Value::Null, Value::Null]));
        let mut row = vec![text(layer.name), text("features"), text(layer.name), text(""), text(CHANGED)];
        row.extend([min_x, min_y, max_x, max_y, Value::Integer(srs)]);
        (index, row)
    };
    let rows = (1..).zip(layers).map(row).collect();
    Table { unique: vec![vec![0], vec![2]], ..table("gpkg_contents", columns, rows) }
}

fn geometry_columns(layers: &[Layer], srs: i64) -> Table {
    let columns = "table_name TEXT NOT NULL, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL, \
        srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL, \
        CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name), CONSTRAINT uk_gc_table_name UNIQUE (table_name), \
        CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name), \
        CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys (srs_id)";
    let row = |(index, layer): (i64, &Layer)| {
        let (z, m) = (Value::Integer(1), Value::Integer(0));
        (index, vec![text(layer.name), text("geom"), text(layer.geometry), Value::Integer(srs), z, m])
    };
    let rows = (1..).zip(layers).map(row).collect();
    Table { unique: vec![vec![0, 1], vec![0]], ..table("gpkg_geometry_columns", columns, rows) }
}
