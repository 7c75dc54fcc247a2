//! Clouds in tiles: parts of space of which each is treated by itself, with what lies around it.
//!
//! [`Histogram`] counts the points of a cloud on a grid, [`Plan`] cuts the grid into tiles, and [`extract()`] takes one tile after the other
//! from points to the measure; what is left of them are the candidates, from which the lines are linked. [`Points`] is where the points come
//! from. See `docs/scale.md`.
//!
//! ```
//! use lineament::shapes::{Sampling, Scan, cuboid};
//! use lineament::tile::{Histogram, Plan, extract};
//! use lineament::{Method, Params};
//!
//! let cloud = cuboid([2.0, 2.0, 60.0]).sample(&Scan::new(Sampling::Area { count: 9000 }).seed(1)).cloud;
//! let params = Params { method: Method::Penalty, ..Params::default() };
//! let plan = Plan::new(&Histogram::of(&cloud.positions, 1 << 12)?, 3000);
//! let tiled = extract(&cloud, &params, &plan, |_| ())?;
//! assert_eq!(tiled.network, lineament::extract(&cloud, &params)?.network);
//! # Ok::<(), lineament::Error>(())
//! ```

mod crowds;
mod extract;
mod found;
mod guests;
mod histogram;
mod kept;
mod linked;
mod measured;
mod part;
mod plan;
mod points;
mod run;
mod set;

pub use extract::{Tiled, extract};
pub use found::Found;
pub use histogram::Histogram;
pub use plan::{Plan, Tile};
pub use points::{Corners, Points};

#[cfg(test)]
mod tests;
