//! From networks, points, patches, sections, graphs and meshes to files.

mod drawing;
mod encode;
mod graph;
mod list;
mod mesh;
mod network;
mod patches;
mod picture;
mod points;
mod report;
mod section;
mod stages;
mod verdicts;

pub use drawing::{write_drawing, write_drawing_to};
pub use encode::step::StepProtocol;
pub use graph::{GraphTable, write_graph, write_graph_to};
pub use list::{ListFormat, list_format, write_list};
pub use mesh::{write_mesh, write_mesh_to};
pub use network::{NetworkContext, Parameter, write_network, write_network_to};
pub use patches::write_patches;
pub use picture::{write_picture, write_picture_to};
pub use points::{PointTable, label_clutter, las_version, write_cleaned, write_points, write_points_to};
pub use report::{Report, write_report, write_report_to};
pub use section::{SectionContext, write_sections, write_sections_to, write_slice_picture};
pub use stages::{write_section_stages, write_stages};
pub use verdicts::write_verdicts;
