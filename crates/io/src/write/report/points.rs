//! The points of a report: as many as have room, in an order of which every beginning covers the cloud evenly, their positions as
//! whole numbers of a step far below the spacing.

use super::Report;
use crate::write::encode::json::{Number, Point};
use base64::prelude::{BASE64_STANDARD, Engine};
use lineament::apply::Shown;
use lineament::apply::render::{Surfel, surfels};
use lineament::patch::NO_PATCH;
use lineament::{Cloud, Error, Frame, Localised};
use std::io::{self, Write};

/// Most points of a report: more would not turn smoothly on a plain laptop.
const MOST: usize = 700_000;
/// Least number of steps in the mean spacing of the points written.
const STEPS: f64 = 32.0;
/// Bytes of a coordinate, one of which is taken: 16 bits for most clouds, 24 where these would be too coarse.
const WIDTHS: [usize; 2] = [2, 3];
/// Greatest value of a component of a normal.
const NORMAL: f32 = 127.0;

/// The points of a report.
#[derive(Debug, Default)]
pub(super) struct Chosen {
    /// The points with their discs, in canonical order.
    pub surfels: Vec<Surfel>,
    /// For each of them its index in the cloud.
    pub source: Vec<u32>,
    /// Mean spacing of them.
    pub spacing: f64,
}

/// Chooses the points that have room in so many bytes.
pub(super) fn choose(report: &Report, room: usize) -> Result<Chosen, Error> {
    let Some(cloud) = report.cloud else { return Ok(Chosen::default()) };
    let Localised { positions, source: all, .. } = Frame::localise(cloud)?;
    let shown = Shown::around(&positions);
    let near = |&(_, &p): &(&u32, &[f64; 3])| shown.holds(p);
    let source: Vec<u32> = all.iter().zip(&positions).filter(near).map(|(&i, _)| i).collect();
    let most = MOST.min(room * 3 / 4 / row_bytes(report, WIDTHS[1]));
    if source.len() == all.len() && all.len() <= most {
        let (surfels, spacing) = surfels(cloud)?;
        return Ok(Chosen { surfels, source, spacing });
    }
    let kept: Vec<u32> = even(source.len()).take(most).map(|i| source[i]).collect();
    let part = Cloud::new(kept.iter().map(|&i| cloud.positions[i as usize]).collect());
    // `surfels` brings the points into the order of `localise`.
    let source = Frame::localise(&part)?.source.into_iter().map(|i| kept[i as usize]).collect();
    let (surfels, spacing) = surfels(&part)?;
    Ok(Chosen { surfels, source, spacing })
}

/// Bytes of a point, before they are written in base 64.
fn row_bytes(report: &Report, width: usize) -> usize {
    let label = if report.labels.is_empty() { 0 } else { 2 };
    3 * width + 3 + usize::from(!report.classes.is_empty()) + label
}

/// The numbers below `count` by their bits in reverse order (van der Corput): of a row in Morton order every beginning of this order
/// covers the whole evenly.
fn even(count: usize) -> impl Iterator<Item = usize> {
    let bits = usize::BITS - count.saturating_sub(1).leading_zeros();
    let reversed = move |i: usize| if bits == 0 { i } else { i.reverse_bits() >> (usize::BITS - bits) };
    (0..1usize << bits).map(reversed).filter(move |&i| i < count)
}

/// Appends the points and the closing brace of the data.
pub(super) fn write(out: &mut dyn Write, report: &Report, chosen: &Chosen) -> io::Result<()> {
    let order: Vec<usize> = even(chosen.surfels.len()).collect();
    let grid = Grid::of(chosen);
    writeln!(
        out,
        "\"points\": {{\"count\": {}, \"of\": {},",
        order.len(),
        report.cloud.map_or(0, Cloud::len)
    )?;
    write!(out, "\"spacing\": {}, \"corner\": {}, ", Number(chosen.spacing), Point(&grid.corner))?;
    writeln!(out, "\"step\": {}, \"bytes\": {},", Number(grid.step), grid.width)?;
    column(out, "positions", order.iter().flat_map(|&i| grid.bytes(chosen.surfels[i].position)))?;
    column(out, "normals", order.iter().flat_map(|&i| normal(chosen.surfels[i].normal)))?;
    if !report.classes.is_empty() {
        column(out, "classes", order.iter().map(|&i| report.classes[chosen.source[i] as usize]))?;
    }
    if !report.labels.is_empty() {
        let label = |&i: &usize| label(report.labels[chosen.source[i] as usize]).to_le_bytes();
        column(out, "labels", order.iter().flat_map(label))?;
    }
    writeln!(out, "\"layout\": \"little endian\"}}\n}}")
}

/// Labels in 16 bits, 0 for none; the patches beyond are shown like the first ones again.
fn label(patch: u32) -> u16 {
    if patch == NO_PATCH { 0 } else { (1 + patch % u32::from(u16::MAX)) as u16 }
}

fn normal(normal: [f32; 3]) -> [u8; 3] {
    normal.map(|c| (c * NORMAL).round() as i8 as u8)
}

fn column(out: &mut dyn Write, name: &str, bytes: impl Iterator<Item = u8>) -> io::Result<()> {
    let bytes: Vec<u8> = bytes.collect();
    writeln!(out, "\"{name}\": \"{}\",", BASE64_STANDARD.encode(bytes))
}

/// The lattice on which positions are written.
struct Grid {
    corner: [f64; 3],
    step: f64,
    /// Bytes of a coordinate.
    width: usize,
}

impl Grid {
    /// The finest lattice of the narrowest width that is fine enough.
    fn of(chosen: &Chosen) -> Self {
        let positions = || chosen.surfels.iter().map(|s| s.position);
        let fold = |pick: fn(f64, f64) -> f64| positions().reduce(|a, b| [0, 1, 2].map(|k| pick(a[k], b[k])));
        let (low, high) = (fold(f64::min).unwrap_or_default(), fold(f64::max).unwrap_or_default());
        let extent = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
        let step = |width: usize| extent / ((1u64 << (8 * width)) - 1) as f64;
        let fine = |&&width: &&usize| step(width) * STEPS <= chosen.spacing;
        let width = *WIDTHS.iter().find(fine).unwrap_or(&WIDTHS[1]);
        // Where all points are one, any step will do.
        Self { corner: low, step: if extent > 0.0 { step(width) } else { 1.0 }, width }
    }

    fn bytes(&self, position: [f64; 3]) -> impl Iterator<Item = u8> {
        let width = self.width;
        let coordinate = |k: usize| ((position[k] - self.corner[k]) / self.step).round() as u32;
        [0, 1, 2].map(coordinate).into_iter().flat_map(move |c| c.to_le_bytes().into_iter().take(width))
    }
}
