//! Readers of point clouds and writers of feature lines.
//!
//! ```no_run
//! use lineament_io::{ReadOptions, read};
//! let scan = read("part.ply".as_ref(), &ReadOptions::default())?;
//! println!("{} points from {}", scan.cloud.len(), scan.format);
//! # Ok::<(), lineament_io::Error>(())
//! ```
//!
//! Formats are recognised by content first and by extension second. Every reader gives all points or an
//! [`Error`] that names the file, the place and the reason; counts and lengths that a file claims are compared
//! with its actual bytes before memory is taken for them. Outputs appear whole or not at all.
#![forbid(unsafe_code)]

mod columns;
mod crs;
mod error;
mod format;
mod number;
mod output;
mod quiet;
mod read;
mod source;
mod unit;
mod write;

pub use crs::reference_code;
pub use error::{Error, Place};
pub use format::{
    FORMATS, FileFormat, Format, GraphFormat, MeshFormat, NetworkFormat, PatchFormat, PointFormat,
    SectionFormat, Written, format_help, graph_format, mesh_format, network_format, patch_format,
    point_format, section_format,
};
pub use output::{Output, check_output};
pub use read::{
    LasFrame, LasRecord, LineFile, MeshFile, Missing, Planned, ReadOptions, Returns, Sampled, Scan, read,
    read_all, read_from, read_lines, read_marks, read_mesh,
};
pub use unit::Unit;
pub use write::{
    GraphTable, ListFormat, NetworkContext, Parameter, PointTable, Report, SectionContext, StepProtocol,
    label_clutter, las_version, list_format, write_cleaned, write_drawing, write_drawing_to, write_graph,
    write_graph_to, write_list, write_mesh, write_mesh_to, write_network, write_network_to, write_patches,
    write_picture, write_picture_to, write_points, write_points_to, write_report, write_report_to,
    write_section_stages, write_sections, write_sections_to, write_slice_picture, write_stages,
    write_verdicts,
};
