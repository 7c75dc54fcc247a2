//! Inputs, and how they are read.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use lineament_io::{Format, Returns};

use crate::args::parse;

/// The source of the points.
#[derive(Clone, Debug, Args)]
pub struct Source {
    /// The scans to read, each on its own; `-` is standard input
    #[arg(value_hint = ValueHint::FilePath, required_unless_present = "sample", conflicts_with = "sample")]
    pub input: Vec<PathBuf>,
    /// Use a generated scan instead of a file; `list` lists them
    #[arg(long, value_name = "NAME")]
    pub sample: Option<String>,
    /// Seed of the generated scan
    #[arg(long, value_name = "N", requires = "sample", default_value_t = 1)]
    pub seed: u64,
    #[command(flatten)]
    pub reading: Reading,
}

/// Part of a file that is read.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Reading")]
pub struct Reading {
    /// Read only the points inside this box, its faces included
    #[arg(long, value_name = "X,Y,Z,X,Y,Z", value_parser = parse::bounds, allow_hyphen_values = true)]
    #[arg(conflicts_with = "sample")]
    pub bounds: Option<[[f64; 3]; 2]>,
    /// Read only every N-th point
    #[arg(long, value_name = "N", conflicts_with = "sample", value_parser = parse::count)]
    pub every: Option<usize>,
    /// Read only one point of every cube with this edge, in the unit of the input
    #[arg(long, value_name = "SIZE", conflicts_with = "sample", value_parser = parse::length)]
    pub voxel: Option<f64>,
    /// Read only the points of these classes, such as 2,6 of a LAS file
    #[arg(long, value_name = "C,C,..", value_delimiter = ',', conflicts_with = "sample")]
    pub class: Vec<u8>,
    /// Keep the points that a LAS file flags as withheld or classes as noise (7 and 18), which the commands that look for lines, faces or
    /// sections leave out; --class keeps the classes that it names
    #[arg(long, conflicts_with = "sample")]
    pub all_points: bool,
    /// Read only these returns of each pulse of a LAS file
    #[arg(long, value_name = "last|first|only", conflicts_with = "sample", value_parser = parse::returns)]
    pub returns: Option<Returns>,
    /// Read only one scan of a file that holds several, counted from 1
    #[arg(long, value_name = "N", conflicts_with = "sample", value_parser = parse::count)]
    pub scan: Option<usize>,
    /// Sample a mesh over its faces by this many points [default: so that its smallest edges and faces get ten spacings, between
    /// 20,000 and 200,000, 50,000 for a mesh of few triangles, 30,000 for a heap of facets most of which would not show; its vertices
    /// alone where they are dense]
    #[arg(long, value_name = "N", conflicts_with_all = ["sample", "vertices"], value_parser = parse::samples)]
    pub samples: Option<usize>,
    /// Take the vertices of a mesh alone, however few they are
    #[arg(long, conflicts_with = "sample")]
    pub vertices: bool,
    /// Read the input as this format, whatever its content or name
    #[arg(long, value_name = "NAME", conflicts_with = "sample", value_parser = parse::format)]
    pub input_format: Option<Format>,
    /// Columns of x, y and z in a table, by number from 1 on or by name: 2,3,4 or Rechtswert,Hochwert,Höhe
    #[arg(long, value_name = "X,Y,Z", conflicts_with = "sample", value_parser = parse::columns)]
    pub columns: Option<[String; 3]>,
    /// Coordinate reference system of the points, such as EPSG:25832; it goes over the one that the file or a .prj beside it states, with
    /// a warning where that is another. Outputs name it; nothing is transformed
    #[arg(long, value_name = "EPSG:N", conflicts_with = "sample", value_parser = parse::reference)]
    pub crs: Option<u32>,
    /// Limit on the memory for the points of a compressed input, such as 4G [default: 64M and eight times the file]
    #[arg(long, value_name = "BYTES", conflicts_with = "sample", value_parser = parse::bytes)]
    pub memory: Option<u64>,
    /// Read the whole part of a file that ends early, and tell how much is missing
    #[arg(long)]
    pub salvage: bool,
    /// Refuse a scan with points that are not finite, instead of leaving those points out
    #[arg(long)]
    pub strict: bool,
}
