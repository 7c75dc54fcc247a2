//! Where the points come from: a file, standard input, or a generated scan.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::{Cloud, shapes};
use lineament_io::{LasFrame, ReadOptions, read};

use crate::args::Source;
use crate::failure::{Code, Failure, shown};

/// A cloud with what outputs and messages say of it.
pub struct Input {
    pub cloud: Cloud,
    /// File name without folders, `stdin`, or `sample NAME, seed N`.
    pub name: String,
    /// Files read, for the check that no output names one.
    pub files: Vec<PathBuf>,
    pub sha256: Option<String>,
    /// The coordinate reference system, and how a LAS file stores its coordinates, for outputs that are to be like it.
    pub crs: Option<String>,
    pub las: Option<LasFrame>,
    /// The name of the format, and the number of bytes; nothing for a generated scan.
    pub format: Option<(String, u64)>,
    /// What was passed over in the file, or is missing from it; a sentence each.
    pub remarks: Vec<String>,
    /// Seconds that reading took.
    pub seconds: f64,
}

/// Reads or generates the points.
///
/// # Errors
/// Input if a file cannot be read, usage if there is no such sample.
pub fn load(source: &Source, options: &ReadOptions) -> Result<Input, Failure> {
    let start = Instant::now();
    let input = match (&source.input, &source.sample) {
        (Some(path), _) => from_file(path, options),
        (None, Some(name)) => from_sample(name, source.seed),
        (None, None) => Err(Failure::new(Code::Usage, "no input: give a file, `-`, or --sample NAME")),
    }?;
    Ok(Input { seconds: start.elapsed().as_secs_f64(), ..input })
}

/// Files that the source names, before anything is read.
pub fn files(source: &Source) -> Vec<PathBuf> {
    source.input.iter().filter(|path| path.as_os_str() != "-").cloned().collect()
}

/// What default outputs are named after: the input without its extension, or the sample. `None` for standard input.
pub fn stem(source: &Source) -> Option<PathBuf> {
    match (&source.input, &source.sample) {
        (Some(path), _) if path.as_os_str() == "-" => None,
        (Some(path), _) => Some(path.with_extension("")),
        (None, sample) => sample.as_ref().map(PathBuf::from),
    }
}

fn from_file(path: &Path, options: &ReadOptions) -> Result<Input, Failure> {
    let scan = read(path, options)?;
    let is_stdin = path.as_os_str() == "-";
    let name = path.file_name().map_or_else(|| shown(path), |name| name.to_string_lossy().into_owned());
    let missing = scan.missing.iter().map(|m| format!("the file ends early: {m}"));
    Ok(Input {
        name: if is_stdin { "stdin".into() } else { name },
        files: if is_stdin { Vec::new() } else { vec![path.into()] },
        sha256: scan.sha256,
        crs: scan.crs,
        las: scan.las,
        format: Some((scan.format.to_string(), scan.bytes)),
        remarks: missing.chain(scan.ignored).collect(),
        cloud: scan.cloud,
        seconds: 0.0,
    })
}

fn from_sample(name: &str, seed: u64) -> Result<Input, Failure> {
    let sample = shapes::sample(name).ok_or_else(|| {
        Failure::new(Code::Usage, format!("--sample {name}: there is no such sample"))
            .advise("`lineament extract --sample list` lists them")
    })?;
    Ok(Input {
        cloud: (sample.make)(seed).cloud,
        name: format!("sample {name}, seed {seed}"),
        files: Vec::new(),
        sha256: None,
        crs: None,
        las: None,
        format: None,
        remarks: Vec::new(),
        seconds: 0.0,
    })
}

/// Whether the source is the request to list the samples.
pub fn is_list(source: &Source) -> bool {
    source.sample.as_deref() == Some("list")
}

/// Prints the samples on standard output.
pub fn print_list() -> Result<(), Failure> {
    let samples = shapes::samples();
    let width = samples.iter().map(|s| s.name.len()).max().unwrap_or(0);
    let line = |s: &shapes::Sample| format!("{:width$}  {}\n", s.name, s.description);
    print(&samples.iter().map(line).collect::<String>())
}

/// Writes a text to standard output. A reader that has gone away is no error: it has seen what it wanted.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = std::io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::new(Code::Output, format!("standard output: {e}")))
        }
        _ => Ok(()),
    }
}
