//! Solids and sheets with known feature networks, sampled as a scanner would: for tests, docs and examples.
//!
//! A [`Shape`] is a list of trimmed faces and the [`Truth`]: the creases and borders that it has by construction.
//! A [`Scan`] says where the points lie (grid, by area, blue noise, scanner), how noisy they are and which seed they
//! come from; the same seed gives the same bits on every machine.
//!
//! ```
//! use lineament::shapes::{Sampling, Scan, bracket};
//!
//! let part = bracket().sample(&Scan::new(Sampling::Area { count: 2000 }).noise(0.1).seed(1));
//! assert_eq!(part.cloud.len(), 2000);
//! assert_eq!(part.truth.loops(), 4); // both rims of the bore, foot and rim of the boss
//! ```

mod blocks;
mod bracket;
mod brick;
mod cube;
mod cylinders;
mod drilled;
mod face;
mod fixtures;
mod keyed;
mod lattice;
mod line_index;
mod machined;
mod nearest;
mod pockets;
mod polyhedron;
mod random;
mod ray;
mod revolution;
mod samples;
mod scan;
mod scanner;
mod sheets;
mod surface;
mod truth;
mod turns;
mod uniform;

pub use blocks::{chamfered_block, cuboid, regular_prism, star_prism, tapered_block, wedge};
pub use bracket::bracket;
pub use brick::brick;
pub use cube::{cube, cube_386, random_cube};
pub use cylinders::{cylinders, pipe_cross};
pub use drilled::{countersunk_plate, crossed_bores, flange};
pub use face::{Face, Trim};
pub use fixtures::{dovetail, manifold, pulley, ribbed_bracket, stepped_plate};
pub use keyed::{dome, keyed_shaft};
pub use line_index::LineIndex;
pub use machined::{channel, counterbored_plate, hex_nut, hollow_shaft, slotted_plate, tapered_hub};
pub use pockets::{pocketed_block, punched_plate};
pub use random::Rng;
pub use revolution::{cone, revolve, sphere, stepped_shaft, torus, tube};
pub use samples::{DEFAULT_SAMPLE, Sample, sample, samples};
pub use scan::{Gradient, Noise, Sampled, Sampling, Scan};
pub use sheets::{bent_sheet, sheet, sheet_with_hole};
pub use surface::{Axes, Surface};
pub use truth::{Fold, Truth, TruthCurve, TruthNode};

pub(crate) use line_index::densify;
pub(crate) use nearest::Tree;

/// The boundary of a solid, or a sheet, with the feature network that it has by construction.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// What it is.
    pub name: &'static str,
    /// Smooth pieces that meet along the network's creases and end at its borders.
    pub faces: Vec<Face>,
    /// Creases, borders and the nodes between them.
    pub network: Truth,
}

impl Shape {
    /// Surface area: the sum of `Face::area`.
    pub fn area(&self) -> f64 {
        self.faces.iter().map(Face::area).sum()
    }

    /// Least and greatest corner of a box along the world axes that holds the untrimmed faces.
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        let points = self.faces.iter().flat_map(Face::extremes);
        points.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], p| {
            [0, 1].map(|side| [0, 1, 2].map(|k| if side == 0 { low[k].min(p[k]) } else { high[k].max(p[k]) }))
        })
    }
}

#[cfg(test)]
mod tests;
