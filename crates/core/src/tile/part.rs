//! The points of one tile: those in its core, which are its own, those in a margin around it, and guests.

use super::guests::Guests;
use super::plan::{Plan, Tile};
use super::points::{Corners, Points};
use crate::error::Error;
use crate::frame::{Frame, Localised, finite};

/// A tile with its margin, in the frame and the order of the whole cloud.
pub(super) struct Part {
    /// `(N, 3)` distinct points in canonical order, local frame.
    pub(super) positions: Vec<[f64; 3]>,
    /// `(N)` index of each in the input.
    pub(super) source: Vec<u32>,
    /// `(N)` whether each lies in the core.
    pub(super) owned: Vec<bool>,
    /// `(N)` distance up to which no point of the cloud is missing; infinite where none is missing at all.
    pub(super) room: Vec<f64>,
    /// Whether the part is the whole cloud.
    pub(super) whole: bool,
}

impl Part {
    /// Gathers the points within `margin` of a tile's core on every axis, local frame, and of its guests.
    ///
    /// # Errors
    /// Those of the points.
    pub(super) fn gather(
        plan: &Plan,
        tile: &Tile,
        frame: Frame,
        (margin, guests): (f64, &Guests),
        points: &dyn Points,
    ) -> Result<Part, Error> {
        let to_local = |v: [f64; 3]| v.map(|x| x / frame.scale);
        let [min, max] = tile.core.map(to_local);
        let [low, high] = [min.map(|x| x - margin), max.map(|x| x + margin)];
        let boxes: Vec<Corners> = [[low, high]].into_iter().chain(guests.boxes(margin)).collect();
        let boxes: Vec<Corners> = boxes.iter().map(|b| b.map(|v| v.map(|x| x * frame.scale))).collect();
        let (mut some, mut numbers) = (Vec::new(), Vec::new());
        points.within(&boxes, &mut |i, p| {
            let local = to_local(plan.grid.relative(p));
            let inside = (0..3).all(|a| low[a] <= local[a] && local[a] <= high[a]);
            if finite(&p) && (inside || guests.hold(local, margin)) {
                some.push(p);
                numbers.push(i);
            }
        })?;
        let Localised { positions, source, .. } = frame.of_part(&plan.grid, &some);
        let source = source.into_iter().map(|i| numbers[i as usize]).collect();
        let extent = to_local([0, 1, 2].map(|a| plan.bounds.max[a] - plan.grid.offset[a]));
        let room = |p: &[f64; 3]| {
            let side = |a: usize| {
                let below = if low[a] <= 0.0 { f64::INFINITY } else { p[a] - low[a] };
                let above = if high[a] >= extent[a] { f64::INFINITY } else { high[a] - p[a] };
                below.min(above)
            };
            (0..3).map(side).fold(f64::INFINITY, f64::min).max(guests.room(*p, margin))
        };
        let owned = |p: &[f64; 3]| (0..3).all(|a| min[a] <= p[a] && p[a] < max[a]);
        Ok(Part {
            source,
            owned: positions.iter().map(owned).collect(),
            room: positions.iter().map(room).collect(),
            whole: (0..3).all(|a| low[a] <= 0.0 && high[a] >= extent[a]),
            positions,
        })
    }
}
