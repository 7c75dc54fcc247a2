//! The names of the columns of a table, and which columns are x, y and z.

use super::split::{Separator, fields, uncommented};
use crate::number::{integer, text};
use std::path::Path;

/// The finding and the remedy.
pub(super) type Refusal = (String, String);

/// Names of x, y and z that belong together, in small letters and with `_` for blanks.
const KNOWN: [[&str; 3]; 16] = [
    ["x", "y", "z"],
    ["points:0", "points:1", "points:2"],
    ["points_0", "points_1", "points_2"],
    ["position_x", "position_y", "position_z"],
    ["point_x", "point_y", "point_z"],
    ["x_coord", "y_coord", "z_coord"],
    ["coord_x", "coord_y", "coord_z"],
    ["xcoord", "ycoord", "zcoord"],
    ["x_coordinate", "y_coordinate", "z_coordinate"],
    ["x_koordinate", "y_koordinate", "z_koordinate"],
    ["easting", "northing", "elevation"],
    ["east", "north", "up"],
    ["e", "n", "u"],
    ["rechtswert", "hochwert", "höhe"],
    ["ost", "nord", "höhe"],
    ["rechts", "hoch", "höhe"],
];
/// Names of heights, beside whatever names of x and y.
const HEIGHTS: [&str; 8] = ["z", "h", "height", "elevation", "altitude", "höhe", "hoehe", "up"];

/// The line that may hold names.
pub(super) struct Lines<'a> {
    pub header: Option<&'a [u8]>,
    pub is_comment: bool,
}

/// The columns that are x, y and z by their names.
pub(in crate::read) fn find_axes(names: &[String]) -> Option<[usize; 3]> {
    let plain: Vec<String> = names.iter().map(|name| plain(name)).collect();
    let find = |known: &str| plain.iter().position(|name| name == known);
    KNOWN.iter().find_map(|[x, y, z]| {
        let height = || HEIGHTS.iter().find_map(|height| find(height));
        Some([find(x)?, find(y)?, find(z).or_else(height)?])
    })
}

/// The names that are known, for messages.
pub(in crate::read) fn known() -> String {
    let all: Vec<String> =
        KNOWN.iter().filter(|names| !names[0].starts_with("points")).map(|names| names.join(",")).collect();
    format!(
        "x, y and z may be called {}, in any case, and heights also {}",
        all.join("; "),
        HEIGHTS.join(", ")
    )
}

fn plain(name: &str) -> String {
    name.trim().to_lowercase().replace([' ', '-', '.'], "_")
}

/// The columns of x, y and z: those that were asked for, those with such names, or the first three where there are no names.
pub(super) fn axes(
    header: Option<&[String]>,
    asked: Option<&[String; 3]>,
    columns: usize,
) -> Result<[usize; 3], Refusal> {
    let Some(asked) = asked else {
        let Some(names) = header else { return Ok([0, 1, 2]) };
        let found = || format!("the columns are called {}", names.join(", "));
        return find_axes(names).ok_or_else(|| {
            (found(), format!("{}; or tell the columns by --columns, as numbers or names", known()))
        });
    };
    let mut axes = [0; 3];
    for (axis, wanted) in axes.iter_mut().zip(asked) {
        let by_name = || header?.iter().position(|name| plain(name) == plain(wanted));
        let by_number = || integer(wanted.as_bytes())?.checked_sub(1)?.try_into().ok();
        *axis = by_name().or_else(by_number).filter(|&column| column < columns).ok_or_else(|| {
            let called = header.map_or(String::new(), |names| format!(", called {}", names.join(", ")));
            let found = format!("there is no column `{wanted}` among the {columns}{called}");
            (found, "--columns takes numbers from 1 on, or names of the columns".to_string())
        })?;
    }
    if axes[0] == axes[1] || axes[1] == axes[2] || axes[0] == axes[2] {
        let found = format!("--columns {} names a column twice", asked.join(","));
        return Err((found, "x, y and z are three columns".into()));
    }
    Ok(axes)
}

/// The names of the columns, if a line before the rows gives as many as there are columns.
pub(super) fn of(
    lines: &Lines,
    separator: Separator,
    columns: usize,
    asked: Option<&[String; 3]>,
) -> Option<Vec<String>> {
    let header = lines.header?;
    let text = |fields: Vec<&[u8]>| -> Vec<String> { fields.iter().map(|f| name(f)).collect() };
    let options =
        [separator, Separator::Byte(b','), Separator::Byte(b';'), Separator::Byte(b'\t'), Separator::Blanks];
    let found = options.iter().map(|&s| text(fields(header, s))).find(|names| names.len() == columns)?;
    let meant = |asked: &[String; 3]| asked.iter().all(|a| found.iter().any(|name| plain(name) == plain(a)));
    let named = find_axes(&found).is_some() || asked.is_some_and(meant);
    (named || !lines.is_comment).then_some(found)
}

/// Refuses names that do not fit the columns: which column is x could then only be guessed.
pub(super) fn misfit(lines: &Lines, separator: Separator, columns: usize) -> Result<(), Refusal> {
    let Some(header) = lines.header.filter(|_| !lines.is_comment) else { return Ok(()) };
    let names: Vec<String> = fields(header, separator).iter().map(|field| name(field)).collect();
    let Some([x, y, z]) = find_axes(&names) else { return Ok(()) };
    if [x, y, z] == [0, 1, 2] || columns == 3 && x < y && y < z {
        return Ok(());
    }
    let found = format!("{columns} columns under the {} names {}", names.len(), names.join(", "));
    Err((found, "name every column, so that x, y and z can be told, or give them by --columns".into()))
}

/// The names that columns have by custom in files with this extension.
pub(super) fn usual(name: &str, columns: usize) -> Option<Vec<String>> {
    let extension = Path::new(name).extension()?.to_str()?.to_ascii_lowercase();
    let rest: &[&str] = match (extension.as_str(), columns) {
        ("pts", 4) => &["intensity"],
        ("pts" | "xyzrgb", 6) => &["red", "green", "blue"],
        ("pts", 7) => &["intensity", "red", "green", "blue"],
        ("pwn" | "xyzn", 6) => &["nx", "ny", "nz"],
        _ => return None,
    };
    Some(["x", "y", "z"].iter().chain(rest).map(|name| (*name).into()).collect())
}

/// A column name without comment signs and without a unit in brackets.
fn name(field: &[u8]) -> String {
    let text = text(uncommented(field));
    let bare = text.split(['[', '(']).next().unwrap_or("").trim();
    if bare.is_empty() { text.trim().into() } else { bare.into() }
}
