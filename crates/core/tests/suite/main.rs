//! Tests of the library as its users call it, one module a subject.

mod common;
mod degenerate;
mod false_lines;
mod holes;
mod meshes;
mod metamorphic;
mod naming;
mod narrow_faces;
mod projection;
mod recovery;
mod relations;
mod scales;
mod scanned;
mod section_axis;
mod section_degenerate;
mod section_properties;
mod sections;
mod shapes_networks;
mod stages;
