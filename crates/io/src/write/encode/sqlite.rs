//! New SQLite databases (file format 3): tables with their rows, and the small indexes that primary keys and UNIQUE
//! constraints ask for. A database is made whole, in memory, and never changed: no free pages, no journal. A bundled
//! SQLite would be C code that takes longer to compile than this workspace.

mod record;
mod tree;

pub(in crate::write) use record::Value;

use std::io;
use tree::{PAGE, Pages};

/// Bytes of the header of the file, which stands at the beginning of the first page.
const HEADER: usize = 100;

/// A table.
pub(in crate::write) struct Table {
    pub name: &'static str,
    pub sql: String,
    /// Rows with their ids, in ascending order. A column that is the id itself holds `Value::Null`.
    pub rows: Vec<(i64, Vec<Value>)>,
    /// For each constraint of the statement that needs an index, in order, the columns it covers.
    pub unique: Vec<Vec<usize>>,
}

/// A database of these tables with an application id and a user version.
///
/// # Errors
/// More than 2^32 pages, or statements that do not fit the first page.
pub(in crate::write) fn database(tables: &[Table], application: u32, version: u32) -> io::Result<Vec<u8>> {
    let mut pages = Pages::default();
    let mut schema: Vec<Vec<Value>> = Vec::new();
    for table in tables {
        let cells = table.rows.iter().map(|(id, row)| (*id, record::encode(row)));
        let root = pages.table(cells)?;
        schema.push(entry("table", table.name, table.name, root, Some(&table.sql)));
        for (number, columns) in table.unique.iter().enumerate() {
            let name = format!("sqlite_autoindex_{}_{}", table.name, number + 1);
            let root = pages.index(index_rows(table, columns))?;
            schema.push(entry("index", &name, table.name, root, None));
        }
    }
    let rows = schema.iter().enumerate().map(|(i, row)| (i as i64 + 1, record::encode(row)));
    let mut bytes = pages.first(HEADER, rows)?;
    header(&mut bytes, application, version);
    Ok(bytes)
}

/// A row of the schema.
fn entry(kind: &str, name: &str, table: &str, root: u32, sql: Option<&str>) -> Vec<Value> {
    let text = |text: &str| Value::Text(text.into());
    vec![text(kind), text(name), text(table), Value::Integer(root.into()), sql.map_or(Value::Null, text)]
}

/// The rows of an index: the columns it covers and the row's id, sorted. All columns covered are text.
fn index_rows(table: &Table, columns: &[usize]) -> Vec<Vec<u8>> {
    let key = |row: &[Value]| -> Vec<Vec<u8>> { columns.iter().map(|&c| row[c].bytes()).collect() };
    let mut rows: Vec<_> = table.rows.iter().map(|(id, row)| (key(row), *id, row)).collect();
    rows.sort_by(|a, b| (&a.0, a.1).cmp(&(&b.0, b.1)));
    let values = |row: &[Value], id| -> Vec<Value> {
        columns.iter().map(|&c| row[c].clone()).chain([Value::Integer(id)]).collect()
    };
    rows.iter().map(|(_, id, row)| record::encode(&values(row, *id))).collect()
}

fn header(bytes: &mut [u8], application: u32, version: u32) {
    let pages = (bytes.len() / PAGE) as u32;
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, b"SQLite format 3\0");
    put(16, &(PAGE as u16).to_be_bytes());
    // Journal modes, no reserved bytes, and the fractions that the format fixes.
    put(18, &[1, 1, 0, 64, 32, 32]);
    for (at, value) in [
        (24, 1),     // changes of the file
        (28, pages), // pages
        (40, 1),     // changes of the schema
        (44, 4),     // schema format
        (56, 1),     // UTF-8
        (60, version),
        (68, application),
        (92, 1),         // the change for which the number of pages holds
        (96, 3_040_000), // the version whose format this is
    ] {
        put(at, &u32::to_be_bytes(value));
    }
}
