//! Pictures of a cloud and its feature network: orthographic, no graphics hardware, no files. Surface display enhanced along
//! feature lines is the non photorealistic rendering of Gumhold 2001, section 5.3.
//!
//! Every point is a surfel: a small disc in the tangent plane. The discs give a surface without holes to shade and
//! to hide lines behind; when points stand far enough apart on the picture they are drawn as dots on it. Lines are
//! stroked on top by kind, their hidden parts faint and dashed.
//!
//! [`draw`] gives the lines alone, with the outlines of the surface and without what it hides, as shapes for vectors.

mod best;
mod camera;
mod caption;
mod compose;
mod depth_buffer;
mod drawing;
mod hidden;
mod lines;
mod picture;
mod scene;
mod slices;
mod stroke;
mod style;
mod surfel;
mod tone;
mod triangles;

pub use camera::View;
pub use compose::{draw, render};
pub use drawing::{Drawing, Layer, Shape, Text};
pub use lines::lines_spacing;
pub use picture::Picture;
pub use scene::{Color, Hidden, Scene, Settings, Slice, Style, Triangles};
pub use style::{class_tint, patch_tint, score_tint};
pub use surfel::{Surfel, surfels};
