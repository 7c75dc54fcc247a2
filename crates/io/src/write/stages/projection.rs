//! The projected distances with the best scale of each point, and the histogram with its cuts (Tran 2013, figures 3 to 5).

use super::measures::{column, write};
use crate::write::encode::json::{Number, list};
use lineament::detect::projection::{scales::SCALES, steps::Steps};
use lineament::{Attribute, Cloud, Column, Extraction};
use std::io::{self, Write};

/// The points with the distance and the radius at each scale, the best scale (0 without one) and the score; the class tells the marks.
pub(super) fn projection(
    out: &mut dyn Write,
    cloud: &Cloud,
    found: &Extraction,
    steps: &Steps,
) -> io::Result<()> {
    let unit = found.frame.length_to_world(1.0);
    let mut columns = Vec::new();
    for (name, values) in [("distance", &steps.distances), ("radius", &steps.radii)] {
        for (k, scale) in SCALES.iter().enumerate() {
            let at = |i: usize| values.get(found.canonical[i] as usize).map(|row| f64::from(row[k]));
            let of = |i| at(i).map_or(f64::NAN, |length| unit * length);
            columns.push(column(&format!("{name}_{scale}"), cloud.len(), of));
        }
    }
    let best = |&c: &u32| steps.projection.scale.get(c as usize).copied().unwrap_or(0);
    let best = Column::U8(found.canonical.iter().map(best).collect());
    columns.push(Attribute { name: "scale".into(), values: best });
    write(out, cloud, found, &found.scores(), columns)
}

/// The histogram and its cuts, as members of JSON that end in a comma.
pub(super) fn cuts(out: &mut dyn Write, steps: &Steps) -> io::Result<()> {
    let marks = &steps.projection.marks;
    write!(out, "\"scales\": [")?;
    list(out, &SCALES, |out, _, scale| write!(out, "{scale}"))?;
    write!(out, "],\n\"at_scale\": [")?;
    let at = SCALES.map(|scale| steps.projection.scale.iter().filter(|&&s| usize::from(s) == scale).count());
    list(out, &at, |out, _, count| write!(out, "{count}"))?;
    write!(out, "],\n\"histogram\": [")?;
    list(out, &steps.histogram, |out, _, count| write!(out, "{count}"))?;
    writeln!(out, "],\n\"cut_of_two\": {},", Number(steps.cut.unwrap_or(f64::NAN)))?;
    let [lower, upper] = steps.cuts.unwrap_or([f64::NAN; 2]).map(Number);
    writeln!(out, "\"cuts_of_three\": [{lower}, {upper}],")?;
    let [threshold, greatest, eta] = [marks.threshold, marks.greatest, marks.separability].map(Number);
    writeln!(out, "\"threshold\": {threshold},\n\"greatest\": {greatest},\n\"separability\": {eta},")?;
    writeln!(out, "\"marked\": {},", marks.count())
}
