//! The shapes that can be asked for, by how they are built.

mod blocks;
mod bracket;
mod brick;
mod cube;
mod cylinders;
mod drilled;
mod fixtures;
mod keyed;
mod machined;
mod pockets;
mod polyhedron;
mod revolution;
mod scenes;
mod sheets;
mod walls;

pub use blocks::{chamfered_block, cuboid, regular_prism, star_prism, tapered_block, wedge};
pub use bracket::bracket;
pub use brick::brick;
pub use cube::{cube, cube_386, random_cube};
pub use cylinders::{cylinders, pipe_cross};
pub use drilled::{countersunk_plate, crossed_bores, flange};
pub use fixtures::{dovetail, manifold, pulley, ribbed_bracket, stepped_plate};
pub use keyed::{dome, keyed_shaft};
pub use machined::{channel, counterbored_plate, hex_nut, hollow_shaft, slotted_plate, tapered_hub};
pub use pockets::{pocketed_block, punched_plate};
pub use revolution::{cone, revolve, sphere, stepped_shaft, torus, tube};
pub use scenes::{farmyard, plant, room};
pub use sheets::{bent_sheet, sheet, sheet_with_hole};
pub use walls::walls;
