//! `lineament graph`.

use std::path::PathBuf;
use std::time::Instant;

use lineament::apply::{CutGraph, cut_graph};
use lineament_io::{GraphFormat, GraphTable, ReadOptions, graph_format, write_graph};

use crate::args;
use crate::batch::Done;
use crate::failure::Failure;
use crate::run::context::context;
use crate::source::{self, Origin};
use crate::summary::plural;
use crate::work::{self, Work};
use crate::{outputs, summary};

/// Suffixes of the files that a folder gets.
const SUFFIXES: [&str; 1] = ["graph.ply"];

/// Reads, extracts, cuts the neighbour graph at the lines, and writes it.
pub fn run(args: &args::Graph) -> Result<(), Failure> {
    if source::is_list(&args.work.source) {
        return source::print_list();
    }
    let work = work::prepare(&args.work, &args.output, &SUFFIXES, graph_format)?;
    work.each(|origin, outputs| one(&work, args, origin, outputs))
}

fn one(work: &Work, args: &args::Graph, origin: &Origin, outputs: &[PathBuf]) -> Result<Done, Failure> {
    let start = Instant::now();
    let is = |wanted| outputs.iter().any(|path| graph_format(path).is_ok_and(|format| format == wanted));
    let (attributes, hash) = (is(GraphFormat::Ply), is(GraphFormat::Json));
    let input =
        work.load(origin, &ReadOptions { attributes, without_noise: true, hash, ..Default::default() })?;
    let found = work.extract(origin, &input)?;
    let graph = cut_graph(&input.cloud, &found, &work.params, args.graph)
        .map_err(|e| Failure::from(e).at(origin.shown()))?;
    let context = context(&input, &work.params, &found);
    let table = GraphTable { cloud: &input.cloud, graph: &graph, all: args.all, context: &context };
    let inputs = work.inputs_with(&input);
    for path in outputs {
        outputs::write(path, || write_graph(path, &inputs, &table))?;
    }
    let mut lines = summary::of(&input, &found, work.args.running.verbose);
    lines.push(counts(&graph));
    lines.push(summary::written(outputs));
    let seconds = start.elapsed().as_secs_f64();
    Ok(Done { lines, row: summary::row(found.report.read, Some(&found.network), seconds) })
}

fn counts(graph: &CutGraph) -> String {
    let [kept, cut] = [&graph.edges, &graph.cut].map(|edges| plural(edges.len(), "edge"));
    format!("{kept} along the surface, {cut} across a line")
}
