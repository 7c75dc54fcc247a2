//! Points that a LAS file itself says are none of the scene: flagged as withheld, or classed as noise (LAS 1.4 R15, table 9).

use crate::columns::get;
use crate::error::Error;
use crate::read::ReadOptions;
use lineament::{Attribute, Cloud};

/// The attributes that tell.
const CLASS: &str = "classification";
const WITHHELD: &str = "withheld";
/// The classes of noise, low and high.
const NOISE: [f64; 2] = [7.0, 18.0];

/// Whether an attribute is needed to tell such points.
pub(super) fn tells(attribute: &str) -> bool {
    [CLASS, WITHHELD].contains(&attribute)
}

/// Leaves such points out if the options say so, and gives their number. Classes that were asked for stay.
///
/// # Errors
/// A file that has no other points.
pub(super) fn leave_out(name: &str, cloud: &mut Cloud, options: &ReadOptions) -> Result<usize, Error> {
    if !options.without_noise || cloud.is_empty() {
        return Ok(0);
    }
    let column = |name: &str| cloud.attributes.iter().find(|a| a.name == name);
    let (class, withheld) = (column(CLASS).filter(|_| options.classes.is_empty()), column(WITHHELD));
    let value = |column: Option<&Attribute>, i: usize| column.map_or(0.0, |a| get(&a.values, i));
    let stays = |i: &u32| value(withheld, *i as usize) == 0.0 && !NOISE.contains(&value(class, *i as usize));
    let kept: Vec<u32> = (0..cloud.len() as u32).filter(stays).collect();
    let left = cloud.len() - kept.len();
    if kept.is_empty() {
        let what = format!("all {left} points are flagged as withheld or classed as noise");
        return Err(Error::Unsupported { name: name.into(), what, advice: "--all-points keeps them".into() });
    }
    if left > 0 {
        *cloud = cloud.select(&kept);
    }
    Ok(left)
}
