//! Fewer points of a cloud: every n-th, one a voxel, those inside a box.

use super::ReadOptions;
use crate::columns::each_column;
use lineament::Cloud;
use std::collections::HashMap;

/// Selects points by the options: first those in the box, then every n-th of these, then one for each voxel. Adds a sentence
/// for each that drops points.
pub(super) fn select(cloud: &mut Cloud, options: &ReadOptions, ignored: &mut Vec<String>) {
    if options.bounds.is_none() && options.every.is_none() && options.voxel.is_none() {
        return;
    }
    let mut kept: Vec<usize> = (0..cloud.len()).collect();
    let mut step = |kept: &mut Vec<usize>, next: Vec<usize>, what: &str| {
        if next.len() < kept.len() {
            ignored.push(format!("{} points {what}", kept.len() - next.len()));
        }
        *kept = next;
    };
    if let Some([low, high]) = options.bounds {
        let inside = |&i: &usize| (0..3).all(|a| (low[a]..=high[a]).contains(&cloud.positions[i][a]));
        let next = kept.iter().copied().filter(inside).collect();
        step(&mut kept, next, "outside the bounds");
    }
    if let Some(every) = options.every.filter(|&every| every > 1) {
        let next = kept.iter().copied().step_by(every).collect();
        step(&mut kept, next, &format!("that are not every {every}th"));
    }
    if let Some(size) = options.voxel.filter(|&size| size > 0.0) {
        let next = voxels(cloud, &kept, size);
        step(&mut kept, next, &format!("with a better one in their voxel of {size:?}"));
    }
    if kept.len() < cloud.len() {
        take(cloud, &kept);
    }
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
