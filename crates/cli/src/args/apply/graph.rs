//! The command line of `graph`.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use lineament::apply::GraphKind;

use crate::args::groups::Work;
use crate::args::parse;

/// The head of the long help.
pub const ABOUT: &str = "\
Write the neighbour graph of a scan without the edges that cross a crease

  lineament graph part.ply -o part.graph.ply           points and edges
  lineament graph part.ply -o part.npz                 arrays xyz, edges and length
  lineament graph part.ply -o part.npz --all           the edges that cross a crease too, told by `cut`
  lineament graph part.ply -o part.csv --graph delaunay

A neighbour graph joins the points that lie beside each other, and near a crease those of two faces. Without these edges, which
join what does not belong together, whatever walks along the graph stays on its face: fits of surfaces, distances, segments
(Gumhold 2001, section 5.1).

There is no default output: name at least one with -o.";

/// The foot of the help.
fn help() -> String {
    format!("Formats by extension:\n{}", lineament_io::format_help(|format| format.graph))
}

/// Arguments of `graph`.
#[derive(Debug, Args)]
#[command(after_help = help())]
pub struct Graph {
    /// File to write the graph to, in the format of its extension; may be given several times. Points are numbered as in the
    /// input, from 0. A folder gets NAME.graph.ply, `{stem}` stands for the name of the input, `-` is JSON on standard output
    #[arg(short, long, value_name = "OUT", required = true, value_hint = ValueHint::FilePath)]
    pub output: Vec<PathBuf>,
    /// The graph: riemannian, the neighbors.k nearest of each point; or delaunay, the edges of the triangles that a filter of
    /// Delaunay triangles leaves (section 2.1), about three for each point, none between parts that lie apart
    #[arg(long, value_name = "NAME", default_value = "riemannian", value_parser = parse::graph)]
    pub graph: GraphKind,
    /// Write the edges that cross a crease too, with a column `cut` that is 1 for them
    #[arg(long)]
    pub all: bool,
    #[command(flatten)]
    pub work: Work,
}
