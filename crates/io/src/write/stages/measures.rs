//! The values at every point of the input, in its order: not a number where a point has none.

use crate::format::PointFormat;
use crate::write::points::{PointTable, write_points_to};
use lineament::{Attribute, Cloud, Column, Ellipsoid, Extraction, Penalties};
use std::io::{self, Write};

/// Centre, deviations along the axes, the least axis and the greatest of every correlation ellipsoid.
pub(super) fn ellipsoids(
    out: &mut dyn Write,
    cloud: &Cloud,
    found: &Extraction,
    all: &[Ellipsoid],
) -> io::Result<()> {
    let of = |i: usize| all.get(found.canonical[i] as usize);
    let value = |name: &str, value: &dyn Fn(&Ellipsoid) -> f64| {
        column(name, cloud.len(), |i| of(i).map_or(f64::NAN, value))
    };
    let unit = found.frame.length_to_world(1.0);
    let mut columns = Vec::new();
    for (c, name) in ["centre_x", "centre_y", "centre_z"].into_iter().enumerate() {
        // In double numbers, as it is a place; points that were merged or thinned out have the ellipsoid of another.
        let own = |i: usize| cloud.positions[found.source[found.canonical[i] as usize] as usize][c];
        let centre = |i: usize| of(i).map_or(f64::NAN, |e| own(i) + unit * e.centre[c]);
        let values = Column::F64((0..cloud.len()).map(centre).collect());
        columns.push(Attribute { name: name.into(), values });
    }
    for (k, name) in ["deviation_least", "deviation_middle", "deviation_most"].into_iter().enumerate() {
        columns.push(value(name, &|e| unit * e.axes.values[k].max(0.0).sqrt()));
    }
    for (axis, names) in [(0, ["nx", "ny", "nz"]), (2, ["long_x", "long_y", "long_z"])] {
        for (c, name) in names.into_iter().enumerate() {
            columns.push(value(name, &|e| e.axes.vectors[axis][c]));
        }
    }
    columns.push(value("neighbors", &|e| (e.count - 1) as f64));
    write(out, cloud, found, &[], columns)
}

/// Density, score, and the penalties of both kinds.
pub(super) fn penalties(out: &mut dyn Write, cloud: &Cloud, found: &Extraction) -> io::Result<()> {
    let unit = found.frame.length_to_world(1.0);
    let density = |i: usize| found.measure.density.get(found.canonical[i] as usize).copied();
    let mut columns =
        vec![column("density", cloud.len(), |i| density(i).map_or(f64::NAN, |mu| unit * f64::from(mu)))];
    for (kind, penalties) in [("crease", &found.measure.crease), ("border", &found.measure.border)] {
        let mut row = vec![None; found.source.len()];
        penalties.points.iter().enumerate().for_each(|(c, &i)| row[i as usize] = Some(c));
        let mut add = |name: String, value: &dyn Fn(&Penalties, usize) -> f32| {
            let of = |i: usize| row.get(found.canonical[i] as usize).copied().flatten();
            let number = |i| of(i).map_or(f64::NAN, |c| f64::from(value(penalties, c)));
            columns.push(column(&name, cloud.len(), number));
        };
        add(kind.into(), &|p, c| p.scalar[c]);
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            add(format!("{kind}_{name}"), &|p, c| p.vector[c][axis]);
        }
        if kind == "crease" {
            add("crease_corner".into(), &|p, c| p.corner[c]);
        }
    }
    write(out, cloud, found, &found.scores(), columns)
}

/// A column of single numbers.
pub(super) fn column(name: &str, count: usize, value: impl Fn(usize) -> f64) -> Attribute {
    Attribute { name: name.into(), values: Column::F32((0..count).map(|i| value(i) as f32).collect()) }
}

/// Writes the points with their class, these scores, if any, and these columns.
pub(super) fn write(
    out: &mut dyn Write,
    cloud: &Cloud,
    found: &Extraction,
    scores: &[f32],
    attributes: Vec<Attribute>,
) -> io::Result<()> {
    let cloud = Cloud { positions: cloud.positions.clone(), attributes };
    let classes: Vec<u8> = found.classes().into_iter().map(|class| class as u8).collect();
    let table = PointTable { cloud: &cloud, classes: &classes, scores, las: None };
    write_points_to(out, PointFormat::Ply, &table)
}
