//! Fewer points of a cloud: every n-th, one a voxel, those inside a box.

use super::{ReadOptions, Returns};
use crate::columns::{each_column, get};
use crate::error::Error;
use crate::format::Format;
use lineament::Cloud;
use std::collections::{BTreeSet, HashMap};

/// Points that voxels leave of many below which their edge may not be the one that was meant.
const FEW: usize = 100;
/// Steps of a voxel's edge up to which f64 tells neighbouring voxels apart.
const STEPS: f64 = (1u64 << 52) as f64;

/// Refuses options that a format has no use for.
pub(super) fn fits(name: &str, format: Format, options: &ReadOptions) -> Result<(), Error> {
    let refused = |what: String, advice: &str| {
        Err(Error::Unsupported { name: name.into(), what, advice: advice.into() })
    };
    if options.scan.is_some() && !matches!(format, Format::E57 | Format::Ptx) {
        return refused(format!("{format} holds no scans to choose from"), "read it without --scan");
    }
    if options.columns.is_some() && format != Format::Table {
        return refused(
            format!("{format} holds no table whose columns could be told"),
            "read it without --columns",
        );
    }
    Ok(())
}

/// Keeps what the options ask for: first the box, then every n-th of what is in it, then one a voxel. Adds a sentence
/// for each that drops points.
///
/// # Errors
/// A box that holds none of the points, and voxels finer than the coordinates.
pub(super) fn select(
    name: &str,
    cloud: &mut Cloud,
    options: &ReadOptions,
    ignored: &mut Vec<String>,
    warnings: &mut Vec<String>,
) -> Result<(), Error> {
    let filters = !options.classes.is_empty() || options.returns.is_some();
    if !filters && options.bounds.is_none() && options.every.is_none() && options.voxel.is_none() {
        return Ok(());
    }
    let mut kept: Vec<usize> = (0..cloud.len()).collect();
    let passed = ignored.join(", ");
    let mut step = |kept: &mut Vec<usize>, next: Vec<usize>, what: &str| {
        if next.len() < kept.len() {
            ignored.push(format!("{} points {what}", kept.len() - next.len()));
        }
        *kept = next;
    };
    if filters {
        let next = filtered(name, cloud, options)?;
        step(&mut kept, next, "of other classes or returns");
    }
    if let Some([low, high]) = options.bounds {
        let inside = |&i: &usize| (0..3).all(|a| (low[a]..=high[a]).contains(&cloud.positions[i][a]));
        let next: Vec<usize> = kept.iter().copied().filter(inside).collect();
        if next.is_empty() {
            return Err(outside(name, cloud, [low, high], &passed));
        }
        step(&mut kept, next, "outside the bounds");
    }
    if let Some(every) = options.every.filter(|&every| every > 1) {
        let next = kept.iter().copied().step_by(every).collect();
        step(&mut kept, next, &format!("that are not every {every}th"));
    }
    if let Some(size) = options.voxel.filter(|&size| size > 0.0) {
        finer(name, cloud, &kept, size)?;
        let next = voxels(cloud, &kept, size);
        warnings.extend(few(next.len(), kept.len(), size));
        step(&mut kept, next, &format!("with a better one in their voxel of {size:?}"));
    }
    if kept.len() < cloud.len() {
        take(cloud, &kept);
    }
    Ok(())
}

/// A warning where voxels leave few of many points.
fn few(left: usize, all: usize, size: f64) -> Option<String> {
    let few = left < FEW && 10 * left < all;
    few.then(|| format!("voxels of {size:?} leave {left} of {all} points: smaller ones leave more"))
}

/// The points of the classes and returns asked for.
fn filtered(name: &str, cloud: &Cloud, options: &ReadOptions) -> Result<Vec<usize>, Error> {
    let mut kept: Vec<usize> = (0..cloud.len()).collect();
    if !options.classes.is_empty() {
        let class = column(name, cloud, "classification")?;
        kept.retain(|&i| options.classes.iter().any(|&c| class(i) == f64::from(c)));
    }
    if let Some(returns) = options.returns {
        let number = column(name, cloud, "return_number")?;
        let count = column(name, cloud, "number_of_returns")?;
        kept.retain(|&i| match returns {
            Returns::First => number(i) <= 1.0,
            Returns::Last => number(i) >= count(i),
            Returns::Only => count(i) <= 1.0,
        });
    }
    if kept.is_empty() && !cloud.is_empty() {
        let what = format!("none of {} points is of these classes and returns", cloud.len());
        let advice = match column(name, cloud, "classification") {
            Ok(class) => {
                let classes: BTreeSet<u8> = (0..cloud.len()).map(|i| class(i) as u8).collect();
                let classes: Vec<String> = classes.iter().map(u8::to_string).collect();
                format!("there are the classes {}; `lineament info` shows the returns", classes.join(", "))
            }
            Err(_) => "`lineament info` shows the returns".into(),
        };
        return Err(Error::Unsupported { name: name.into(), what, advice });
    }
    Ok(kept)
}

/// The values of an attribute, by point.
fn column<'a>(
    name: &str,
    cloud: &'a Cloud,
    attribute: &str,
) -> Result<impl Fn(usize) -> f64 + use<'a>, Error> {
    let found = cloud.attributes.iter().find(|a| a.name.eq_ignore_ascii_case(attribute));
    let found = found.ok_or_else(|| Error::Unsupported {
        name: name.into(),
        what: format!("its points have no `{attribute}`"),
        advice: "classes and returns stand in LAS files".into(),
    })?;
    Ok(move |index| get(&found.values, index))
}

/// The error for a box without points; it says where the points lie, or which of them the reader passed over.
fn outside(name: &str, cloud: &Cloud, [low, high]: [[f64; 3]; 2], passed: &str) -> Error {
    if cloud.is_empty() {
        let what = format!("no point lies inside the bounds {low:?} to {high:?}");
        let advice = if passed.is_empty() { "the file has no points" } else { passed };
        return Error::Unsupported { name: name.into(), what, advice: advice.into() };
    }
    let axis = |pick: fn(f64, f64) -> f64, a: usize| {
        let finite = cloud.positions.iter().map(|p| p[a]).filter(|c| c.is_finite());
        finite.reduce(pick).unwrap_or(f64::NAN)
    };
    let [least, most] =
        [f64::min, f64::max].map(|pick: fn(f64, f64) -> f64| [0, 1, 2].map(|a| axis(pick, a)));
    let what = format!("none of {} points lies inside the bounds {low:?} to {high:?}", cloud.len());
    Error::Unsupported { name: name.into(), what, advice: format!("they lie from {least:?} to {most:?}") }
}

/// Refuses voxels so fine that coordinates of this size do not tell neighbouring ones apart.
fn finer(name: &str, cloud: &Cloud, kept: &[usize], size: f64) -> Result<(), Error> {
    let finite = kept.iter().flat_map(|&i| cloud.positions[i]).map(f64::abs).filter(|c| c.is_finite());
    let most = finite.fold(0.0, f64::max);
    if most / size < STEPS {
        return Ok(());
    }
    let what = format!("voxels of {size:?} are finer than coordinates of {most:?} can be told apart");
    let advice = format!("voxels must be larger than {:e}", most / STEPS);
    Err(Error::Unsupported { name: name.into(), what, advice })
}

/// Of every voxel the point nearest to its middle; of several as near, the least by its coordinates: so that the choice
/// does not depend on the order of the points. Non-finite points are kept: they are counted later.
fn voxels(cloud: &Cloud, kept: &[usize], size: f64) -> Vec<usize> {
    let mut best: HashMap<[i64; 3], (f64, [f64; 3], usize)> = HashMap::new();
    let mut next = Vec::new();
    for &i in kept {
        let point = cloud.positions[i];
        if !point.iter().all(|c| c.is_finite()) {
            next.push(i);
            continue;
        }
        let cell = point.map(|c| (c / size).floor());
        let off = (0..3).map(|a| (point[a] / size - cell[a] - 0.5).powi(2)).sum::<f64>();
        let entry = best.entry(cell.map(|c| c as i64)).or_insert((off, point, i));
        if (off, point) < (entry.0, entry.1) {
            *entry = (off, point, i);
        }
    }
    next.extend(best.values().map(|&(_, _, i)| i));
    next.sort_unstable();
    next
}

/// Keeps these points and their attributes.
fn take(cloud: &mut Cloud, kept: &[usize]) {
    cloud.positions = kept.iter().map(|&i| cloud.positions[i]).collect();
    for attribute in &mut cloud.attributes {
        each_column!(&mut attribute.values, values => *values = kept.iter().map(|&i| values[i]).collect());
    }
}
