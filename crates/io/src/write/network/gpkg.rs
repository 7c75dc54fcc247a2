//! A network as GeoPackage (OGC 12-128r18, version 1.3): the layers `lines` and `nodes` with 3D geometries in the frame of
//! the input, their attributes, and the reference system of the input.

use super::context::NetworkContext;
use crate::write::encode::sqlite::{Table, Value, database};
use lineament::{Network, Node, Strip};
use std::io::{self, Write};

/// `GPKG`, and the version.
const APPLICATION: u32 = 0x4750_4b47;
const VERSION: u32 = 10_300;
/// The time of the last change: the time of writing would make bytes differ between runs.
const CHANGED: &str = "1970-01-01T00:00:00.000Z";
/// Number of a reference system that is known by its name alone.
const UNNUMBERED: i64 = 100_000;
/// Geometry types of WKB with z.
const POINT_Z: u32 = 1001;
const LINE_Z: u32 = 1002;

/// Writes a database of two layers.
pub(super) fn write(out: &mut dyn Write, network: &Network, context: &NetworkContext) -> io::Result<()> {
    let (srs, id) = reference_systems(context);
    let lines: Vec<&Strip> = network.strips.iter().filter(|strip| strip.points.len() > 1).collect();
    let ways: Vec<Vec<[f64; 3]>> = lines.iter().map(|strip| way(strip)).collect();
    let nodes: Vec<[f64; 3]> = network.nodes.iter().map(|node| node.position).collect();
    let line_rows =
        lines.iter().zip(&ways).enumerate().map(|(i, (strip, way))| (i as i64 + 1, line(strip, way, id)));
    let node_rows = network.nodes.iter().enumerate().map(|(i, node)| (i as i64 + 1, point(node, id)));
    let lines = table("lines", LINES, line_rows.collect());
    let nodes_table = table("nodes", NODES, node_rows.collect());
    let counts = vec![
        (1, vec![text("lines"), Value::Integer(lines.rows.len() as i64)]),
        (2, vec![text("nodes"), Value::Integer(nodes_table.rows.len() as i64)]),
    ];
    let all: Vec<[f64; 3]> = ways.concat();
    let tables = [
        srs,
        contents(&[("lines", &all), ("nodes", &nodes)], id),
        geometry_columns(id),
        Table {
            name: "sqlite_sequence",
            sql: "CREATE TABLE sqlite_sequence(name,seq)".into(),
            rows: counts,
            unique: vec![],
        },
        lines,
        nodes_table,
    ];
    out.write_all(&database(&tables, APPLICATION, VERSION)?)
}

const LINES: &str = "fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom LINESTRING, kind TEXT, closed BOOLEAN, \
    start_node INTEGER, end_node INTEGER, length DOUBLE, fold_deg DOUBLE, deviation DOUBLE, confidence DOUBLE";
const NODES: &str = "fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom POINT, kind TEXT, degree INTEGER";

fn text(text: &str) -> Value {
    Value::Text(text.into())
}

fn table(name: &'static str, columns: &str, rows: Vec<(i64, Vec<Value>)>) -> Table {
    Table { name, sql: format!("CREATE TABLE {name} ({columns})"), rows, unique: Vec::new() }
}

/// The points of a strip; a closed one ends where it begins.
fn way(strip: &Strip) -> Vec<[f64; 3]> {
    let first = strip.points.first().filter(|_| strip.closed);
    strip.points.iter().chain(first).copied().collect()
}

/// A row of `lines`. Nodes are numbered from 1, as in `nodes`.
fn line(strip: &Strip, way: &[[f64; 3]], srs: i64) -> Vec<Value> {
    let node = |index: Option<u32>| index.map_or(Value::Null, |node| Value::Integer(i64::from(node) + 1));
    let mut wkb = vec![1];
    wkb.extend(LINE_Z.to_le_bytes());
    wkb.extend((way.len() as u32).to_le_bytes());
    way.iter().flatten().for_each(|c| wkb.extend(c.to_le_bytes()));
    vec![
        Value::Null,
        geometry(&wkb, Some(way), srs),
        text(strip.kind.name()),
        Value::Integer(strip.closed.into()),
        node(strip.start),
        node(strip.end),
        Value::Real(strip.length()),
        strip.fold_deg.map_or(Value::Null, Value::Real),
        Value::Real(strip.deviation),
        Value::Real(strip.confidence),
    ]
}

/// A row of `nodes`.
fn point(node: &Node, srs: i64) -> Vec<Value> {
    let mut wkb = vec![1];
    wkb.extend(POINT_Z.to_le_bytes());
    node.position.iter().for_each(|c| wkb.extend(c.to_le_bytes()));
    let geometry = geometry(&wkb, None, srs);
    vec![Value::Null, geometry, text(node.kind.name()), Value::Integer(node.degree.into())]
}

/// Least and greatest coordinate of points on an axis; `None` if there are none.
fn extent(points: &[[f64; 3]], axis: usize) -> Option<[f64; 2]> {
    let limit = |pick: fn(f64, f64) -> f64| points.iter().map(|p| p[axis]).reduce(pick);
    Some([limit(f64::min)?, limit(f64::max)?])
}

/// A geometry with its header, and the box around it if points are given.
fn geometry(wkb: &[u8], around: Option<&[[f64; 3]]>, srs: i64) -> Value {
    // Little endian; the kind of box is in bits 1 to 3, 2 being x, y and z.
    let mut bytes = vec![b'G', b'P', 0, if around.is_some() { 0b101 } else { 1 }];
    bytes.extend((srs as i32).to_le_bytes());
    let limits = (0..3).filter_map(|axis| extent(around?, axis)).flatten();
    limits.for_each(|c| bytes.extend(c.to_le_bytes()));
    bytes.extend(wkb);
    Value::Blob(bytes)
}

/// The reference systems that every file has, and that of the input with its number.
fn reference_systems(context: &NetworkContext) -> (Table, i64) {
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
    let Some(crs) = &context.crs else { return (srs_table(rows), -1) };
    let definition = context.crs_wkt.as_deref().unwrap_or("undefined");
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

fn contents(layers: &[(&str, &[[f64; 3]])], srs: i64) -> Table {
    let columns = "table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE, \
        description TEXT DEFAULT '', last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')), \
        min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, srs_id INTEGER, \
        CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id)";
    let row = |(index, (name, points)): (usize, &(&str, &[[f64; 3]]))| {
        let [x, y] = [0, 1].map(|axis| extent(points, axis).map(|limits| limits.map(Value::Real)));
        let [[min_x, max_x], [min_y, max_y]] =
            [x, y].map(|limits| limits.unwrap_or([Value::Null, Value::Null]));
        let mut row = vec![text(name), text("features"), text(name), text(""), text(CHANGED)];
        row.extend([min_x, min_y, max_x, max_y, Value::Integer(srs)]);
        (index as i64 + 1, row)
    };
    let rows = layers.iter().enumerate().map(row).collect();
    Table { unique: vec![vec![0], vec![2]], ..table("gpkg_contents", columns, rows) }
}

fn geometry_columns(srs: i64) -> Table {
    let columns = "table_name TEXT NOT NULL, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL, \
        srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL, \
        CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name), CONSTRAINT uk_gc_table_name UNIQUE (table_name), \
        CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name), \
        CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys (srs_id)";
    let row = |name: &str, kind: &str| {
        let (z, m) = (Value::Integer(1), Value::Integer(0));
        vec![text(name), text("geom"), text(kind), Value::Integer(srs), z, m]
    };
    let rows = vec![(1, row("lines", "LINESTRING")), (2, row("nodes", "POINT"))];
    Table { unique: vec![vec![0, 1], vec![0]], ..table("gpkg_geometry_columns", columns, rows) }
}
