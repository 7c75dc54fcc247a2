//! Pictures of a cloud and its feature network: orthographic, no graphics hardware, no files. Surface display enhanced along
//! feature lines is the non photorealistic rendering of Gumhold 2001, section 5.3.
//!
//! Every point is a surfel: a small disc in the tangent plane. The discs give a surface without holes to shade and
//! to hide lines behind; when points stand far enough apart on the picture they are drawn as dots on it. Lines are
//! stroked on top by kind, their hidden parts faint and dashed.

mod best;
mod camera;
mod caption;
mod compose;
mod depth_buffer;
mod hidden;
mod lines;
mod picture;
mod scene;
mod slices;
mod stroke;
mod style;
mod surfel;
mod tone;

pub use camera::View;
pub use compose::render;
pub use picture::Picture;
pub use scene::{Scene, Settings, Slice};
pub use surfel::{Surfel, surfels};
