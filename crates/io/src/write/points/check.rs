//! Conditions on points before any of them is written.

use super::table::PointTable;

/// All columns have one value for each point.
pub(in crate::write) fn check(table: &PointTable) -> Result<(), String> {
    let count = table.cloud.len();
    if !table.classes.is_empty() && table.classes.len() != count {
        return Err(format!("{} classes for {count} points", table.classes.len()));
    }
    if !table.scores.is_empty() && table.scores.len() != count {
        return Err(format!("{} scores for {count} points", table.scores.len()));
    }
    match table.cloud.attributes.iter().find(|a| a.values.len() != count) {
        Some(a) => Err(format!("attribute `{}` has {} values for {count} points", a.name, a.values.len())),
        None => Ok(()),
    }
}
