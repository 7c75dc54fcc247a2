//! `lineament extract`.

use std::path::PathBuf;
use std::time::Instant;

use lineament::{Extraction, Params};
use lineament_io::{NetworkContext, Parameter, ReadOptions, network_format, write_network};

use crate::args::Extract;
use crate::config::{self, text};
use crate::failure::Failure;
use crate::source::{self, Input};
use crate::{outputs, progress, summary};

/// Reads, extracts, writes, and says what came of it.
pub fn run(args: &Extract) -> Result<(), Failure> {
    if source::is_list(&args.source) {
        return source::print_list();
    }
    let start = Instant::now();
    config::threads(&args.running)?;
    let params = config::params(&args.tuning)?;
    let outputs = checked_outputs(args)?;
    let input =
        source::load(&args.source, &ReadOptions { attributes: false, hash: true, ..Default::default() })?;
    let found = progress::observed(&input.cloud, &params, args.running.quiet)
        .map_err(|e| Failure::from(e).at(&input.name))?;
    let context = context(&input, &params, &found);
    let writing = Instant::now();
    for path in &outputs {
        outputs::write(path, || write_network(path, &input.files, &found.network, &context))?;
    }
    if !args.running.quiet {
        let verbose = args.running.verbose;
        let mut lines = summary::of(&input, &found, verbose);
        let seconds = [writing, start].map(|t| t.elapsed().as_secs_f64());
        lines.push(summary::times(&input, &found.report, verbose, seconds[0], seconds[1]));
        lines.push(summary::written(&outputs));
        eprintln!("{}", lines.join("\n"));
    }
    Ok(())
}

fn checked_outputs(args: &Extract) -> Result<Vec<PathBuf>, Failure> {
    let outputs = outputs::or_default(&args.output, source::stem(&args.source).as_deref());
    outputs::check(&outputs, &source::files(&args.source), network_format)?;
    Ok(outputs)
}

/// What an output says of where its lines come from.
fn context(input: &Input, params: &Params, found: &Extraction) -> NetworkContext {
    let entries = params.entries();
    let parameters = entries.iter().map(|e| Parameter { key: e.key.clone(), value: text::value(&e.value) });
    let method = entries.iter().find(|e| e.key == "method").map(|e| e.value.clone());
    NetworkContext {
        program_version: env!("CARGO_PKG_VERSION").into(),
        input_name: input.name.clone(),
        input_sha256: input.sha256.clone(),
        input_points: found.report.read as u64,
        method: method.unwrap_or_default(),
        parameters: parameters.collect(),
        spacing: found.report.spacing,
        noise: Some(found.report.noise),
        crs: input.crs.clone(),
        ..NetworkContext::default()
    }
}
