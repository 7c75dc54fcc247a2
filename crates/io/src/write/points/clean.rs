//! Points that [`clean`](lineament::clean()) told apart: those on surfaces, or all of them with a label.

use std::path::{Path, PathBuf};

use lineament::{Attribute, Class, Cloud, Column};

use super::{PointTable, write_points};
use crate::error::Error;
use crate::format::{PointFormat, point_format};
use crate::read::LasFrame;

/// The attribute of LAS points with the classes of ASPRS, and the class of noise there.
const CLASSIFICATION: &str = "classification";
const NOISE: u8 = 7;
const CLUTTER: u8 = Class::Clutter as u8;

/// Adds a column `class` to all points, 0 on a surface or not finite and 4 for clutter (indices of points), and returns it.
pub fn label_clutter(cloud: &mut Cloud, clutter: &[u32]) -> Vec<u8> {
    let mut classes = vec![Class::Smooth as u8; cloud.len()];
    for &i in clutter {
        if let Some(class) = classes.get_mut(i as usize) {
            *class = CLUTTER;
        }
    }
    cloud.attributes.insert(0, Attribute { name: "class".into(), values: Column::U8(classes.clone()) });
    classes
}

/// Writes points to a file as [`write_points`]: those that were kept, without `labels`, or all with those of [`label_clutter`].
/// NPY then holds the labels, LAS and LAZ have clutter as noise in their classification too.
///
/// # Errors
/// As [`write_points`].
pub fn write_cleaned(
    path: &Path,
    inputs: &[PathBuf],
    cloud: &Cloud,
    labels: &[u8],
    las: Option<&LasFrame>,
) -> Result<(), Error> {
    // The classes are a column of their own where the format holds nothing else, and an attribute elsewhere.
    let table = PointTable { cloud, classes: &[], scores: &[], las };
    match point_format(path)? {
        PointFormat::Npy => write_points(path, inputs, &PointTable { classes: labels, ..table }),
        PointFormat::Las | PointFormat::Laz if !labels.is_empty() => {
            let cloud = with_noise(cloud, labels);
            write_points(path, inputs, &PointTable { cloud: &cloud, ..table })
        }
        _ => write_points(path, inputs, &table),
    }
}

/// The points with clutter classified as noise. A classification that is not of bytes is none of LAS, and stays as it is.
fn with_noise(cloud: &Cloud, labels: &[u8]) -> Cloud {
    let mut cloud = cloud.clone();
    if !cloud.attributes.iter().any(|a| a.name == CLASSIFICATION) {
        let values = Column::U8(vec![0; cloud.len()]);
        cloud.attributes.push(Attribute { name: CLASSIFICATION.into(), values });
    }
    let known = cloud.attributes.iter_mut().find(|a| a.name == CLASSIFICATION);
    if let Some(Attribute { values: Column::U8(classes), .. }) = known {
        let clutter = classes.iter_mut().zip(labels).filter(|(_, label)| **label == CLUTTER);
        clutter.for_each(|(class, _)| *class = NOISE);
    }
    cloud
}
