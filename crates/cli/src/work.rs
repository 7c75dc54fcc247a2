//! The common course of the commands that extract: check everything before the work begins, then treat one input after
//! the other.

use std::path::{Path, PathBuf};

use lineament::{Extraction, Params};
use lineament_io::ReadOptions;

use crate::args;
use crate::batch::{self, Done};
use crate::config;
use crate::failure::Failure;
use crate::source::{self, Input, Origin};
use crate::{outputs, progress, summary};

/// A command line that has been checked as far as it can be without reading an input.
pub struct Work<'a> {
    pub args: &'a args::Work,
    pub params: Params,
    /// Whether extractions keep the stages of the method.
    pub staged: bool,
    origins: Vec<Origin>,
    /// All files that are read; no output may name one.
    pub inputs: Vec<PathBuf>,
    plan: Vec<Vec<PathBuf>>,
}

/// Settles threads, parameters, inputs and outputs. The outputs asked for are `asked`, a folder gets `suffixes`, and
/// `known` refuses names that no format has.
pub fn prepare<'a, F, E: Into<Failure>>(
    args: &'a args::Work,
    asked: &[PathBuf],
    suffixes: &[&str],
    known: impl Fn(&Path) -> Result<F, E>,
) -> Result<Work<'a>, Failure> {
    prepare_from(Params::default(), args, asked, suffixes, known)
}

/// As [`prepare`], for a command that has other values than the defaults to begin with.
pub fn prepare_from<'a, F, E: Into<Failure>>(
    params: Params,
    args: &'a args::Work,
    asked: &[PathBuf],
    suffixes: &[&str],
    known: impl Fn(&Path) -> Result<F, E>,
) -> Result<Work<'a>, Failure> {
    config::threads(&args.running)?;
    let params = config::params_from(params, &args.tuning)?;
    let origins = source::origins(&args.source)?;
    let inputs = [source::files(&origins), args.tuning.settings.params.iter().cloned().collect()].concat();
    let plan = outputs::plan(&origins, asked, suffixes)?;
    outputs::check(&plan, &inputs, known)?;
    Ok(Work { args, params, staged: false, origins, inputs, plan })
}

impl Work<'_> {
    /// Treats each input by `treat`, which gets its outputs.
    pub fn each(
        &self,
        mut treat: impl FnMut(&Origin, &[PathBuf]) -> Result<Done, Failure>,
    ) -> Result<(), Failure> {
        batch::run(&summary::HEADER, &self.origins, &self.args.running, |i, origin| {
            treat(origin, &self.plan[i])
        })
    }

    /// The number of inputs.
    pub fn count(&self) -> usize {
        self.origins.len()
    }

    /// All files that are read, with those that an input led to.
    pub fn inputs_with(&self, input: &Input) -> Vec<PathBuf> {
        [self.inputs.as_slice(), &input.beside].concat()
    }

    /// Reads an input.
    pub fn load(&self, origin: &Origin, options: &ReadOptions) -> Result<Input, Failure> {
        progress::named("read", self.args.running.quiet, || origin.load(&self.args.source.reading, options))
    }

    /// Extracts the lines of an input.
    pub fn extract(&self, origin: &Origin, input: &Input) -> Result<Extraction, Failure> {
        let quiet = self.args.running.quiet;
        progress::observed(&input.cloud, input.folds(), &self.params, self.staged, quiet)
            .map_err(|e| Failure::from(e).at(origin.shown()))
    }
}
