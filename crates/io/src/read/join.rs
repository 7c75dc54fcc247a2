//! Several inputs as one cloud.

use super::{ReadOptions, Sampled, Scan, read};
use crate::columns::Scalar;
use crate::error::Error;
use lineament::{Attribute, Column};
use std::path::PathBuf;

/// Reads several files, whose points become one cloud in the order of the files. Attributes that all files have, with
/// the same type, are kept. The scan has the format and reference system of the first, no hash if there are several,
/// and the name of all.
///
/// # Errors
/// As [`read`] for any of them; [`Error::Unsupported`] if none is given.
pub fn read_all(paths: &[PathBuf], options: &ReadOptions) -> Result<Scan, Error> {
    let mut scans = Vec::with_capacity(paths.len());
    for path in paths {
        scans.push(read(path, options)?);
    }
    let mut scans = scans.into_iter();
    let Some(mut first) = scans.next() else {
        let (name, what) = ("input".into(), "no file was given".into());
        return Err(Error::Unsupported { name, what, advice: "name at least one".into() });
    };
    scans.for_each(|next| add(&mut first, next));
    Ok(first)
}

fn add(all: &mut Scan, mut next: Scan) {
    let same =
        |a: &Attribute, b: &Attribute| a.name == b.name && Scalar::of(&a.values) == Scalar::of(&b.values);
    let found = |a: &Attribute, others: &[Attribute]| others.iter().position(|b| same(a, b));
    let (mut kept, mut dropped) = (Vec::new(), Vec::new());
    for mut attribute in std::mem::take(&mut all.cloud.attributes) {
        match found(&attribute, &next.cloud.attributes) {
            Some(at) => {
                append(&mut attribute.values, next.cloud.attributes.swap_remove(at).values);
                kept.push(attribute);
            }
            None => dropped.push(attribute.name),
        }
    }
    dropped.extend(next.cloud.attributes.into_iter().map(|attribute| attribute.name));
    if !dropped.is_empty() {
        dropped.sort();
        dropped.dedup();
        all.ignored.push(format!("attributes that not all inputs have alike: {}", dropped.join(", ")));
    }
    all.cloud.attributes = kept;
    all.cloud.positions.append(&mut next.cloud.positions);
    if next.crs != all.crs {
        let name = |crs: &Option<String>| crs.clone().unwrap_or_else(|| "none stated".into());
        all.warnings.push(format!(
            "the reference system {} of {}: it is taken for {}",
            name(&next.crs),
            next.name,
            name(&all.crs)
        ));
    }
    all.ignored.append(&mut next.ignored);
    all.warnings.append(&mut next.warnings);
    all.beside.append(&mut next.beside);
    all.missing = all.missing.take().or(next.missing);
    all.name = format!("{}, {}", all.name, next.name);
    all.sampled = match (all.sampled.take(), next.sampled) {
        (Some(a), Some(b)) => Some(Sampled {
            faces: a.faces + b.faces,
            spacing: a.spacing.max(b.spacing),
            feature: [a.feature, b.feature].into_iter().flatten().min_by(f64::total_cmp),
            folds: [a.folds, b.folds].concat(),
        }),
        (a, b) => a.or(b),
    };
    all.noise += next.noise;
    all.bytes += next.bytes;
    all.sha256 = None;
}

/// Appends a column to one of the same type.
fn append(column: &mut Column, other: Column) {
    match (column, other) {
        (Column::I8(a), Column::I8(mut b)) => a.append(&mut b),
        (Column::U8(a), Column::U8(mut b)) => a.append(&mut b),
        (Column::I16(a), Column::I16(mut b)) => a.append(&mut b),
        (Column::U16(a), Column::U16(mut b)) => a.append(&mut b),
        (Column::I32(a), Column::I32(mut b)) => a.append(&mut b),
        (Column::U32(a), Column::U32(mut b)) => a.append(&mut b),
        (Column::I64(a), Column::I64(mut b)) => a.append(&mut b),
        (Column::U64(a), Column::U64(mut b)) => a.append(&mut b),
        (Column::F32(a), Column::F32(mut b)) => a.append(&mut b),
        (Column::F64(a), Column::F64(mut b)) => a.append(&mut b),
        _ => {}
    }
}
