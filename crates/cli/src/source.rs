//! Where the points come from: a file, standard input, or a generated scan.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::mesh::{Fold, MeshPoints};
use lineament::{Cloud, shapes};
use lineament_io::{LasFrame, Planned, ReadOptions, Sampled, Unit, read};

use crate::args::{Reading, Source};
use crate::config::near;
use crate::failure::{Code, Failure};

/// One input of the command line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A file, and the stem of the outputs that are named after it where they do not stand beside it.
    File {
        path: PathBuf,
        stem: OsString,
    },
    Stdin,
    Sample {
        name: String,
        seed: u64,
    },
}

/// A cloud with its origin, for outputs and messages.
pub struct Input {
    pub cloud: Cloud,
    /// File name without folders, `stdin`, or `sample NAME, seed N`.
    pub name: String,
    pub sha256: Option<String>,
    /// The coordinate reference system, and how a LAS file stores its coordinates, for outputs that are to be like it.
    pub crs: Option<String>,
    pub epsg: Option<u32>,
    /// The definition of the system in well-known text, and the unit of the coordinates, where they are known.
    pub wkt: Option<String>,
    pub unit: Option<Unit>,
    pub las: Option<LasFrame>,
    /// The mesh that the points were sampled on.
    pub sampled: Option<Sampled>,
    /// The mesh whose vertices these are, where points would be sampled on it.
    pub planned: Option<Planned>,
    /// The name of the format, and the number of bytes; nothing for a generated scan.
    pub format: Option<(String, u64)>,
    /// The missing part of a salvaged file.
    pub missing: Option<String>,
    /// Points that were left out as the file itself flags them as withheld or noise.
    pub noise: usize,
    /// What makes it doubtful that the points are those that were meant; a sentence each.
    pub warnings: Vec<String>,
    /// What was passed over in the file; a sentence each.
    pub remarks: Vec<String>,
    /// Other files that were read for it.
    pub beside: Vec<PathBuf>,
    /// Seconds that reading took.
    pub seconds: f64,
}

impl Input {
    /// The coordinate reference system for outputs: `EPSG:` and its code, or its name.
    pub fn reference(&self) -> Option<String> {
        self.epsg.map(|code| format!("EPSG:{code}")).or_else(|| self.crs.clone())
    }

    /// What LAS outputs take over from the input: how it stores coordinates, or at least its reference system.
    pub fn frame(&self) -> Option<Cow<'_, LasFrame>> {
        let placed = || LasFrame::of_system(self.epsg, self.wkt.as_deref()).map(Cow::Owned);
        self.las.as_ref().map(Cow::Borrowed).or_else(placed)
    }

    /// The edges at which the mesh folds that the points were sampled on; none of a scan.
    pub fn folds(&self) -> &[Fold] {
        self.sampled.as_ref().map_or(&[], |sampled| &sampled.folds)
    }

    /// The direction that points up in pictures: y for glTF, as that format has it, and z for all others.
    pub fn up(&self) -> [f64; 3] {
        let y_up = |(format, _): &(String, u64)| ["glTF", "GLB"].contains(&format.as_str());
        if self.format.as_ref().is_some_and(y_up) { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] }
    }
}

/// The inputs of a command line, in order.
///
/// # Errors
/// Usage if standard input is named twice.
pub fn origins(source: &Source) -> Result<Vec<Origin>, Failure> {
    if let Some(name) = &source.sample {
        return Ok(vec![Origin::Sample { name: name.clone(), seed: source.seed }]);
    }
    let origins = files_at(&source.input);
    if origins.iter().filter(|origin| **origin == Origin::Stdin).count() > 1 {
        return Err(Failure::new(Code::Usage, "standard input (`-`) can be read only once"));
    }
    Ok(origins)
}

/// Files by their paths, `-` being standard input. Those of one stem have the name of their folder before it, so that their
/// results can stand in one folder.
pub fn files_at(paths: &[PathBuf]) -> Vec<Origin> {
    let stem = |path: &PathBuf| path.file_stem().unwrap_or_default().to_owned();
    let mut counts: BTreeMap<OsString, usize> = BTreeMap::new();
    paths.iter().for_each(|path| *counts.entry(stem(path)).or_default() += 1);
    let named = |path: &PathBuf| {
        let own = stem(path);
        let folder = path.parent().and_then(Path::file_name).filter(|_| counts[&own] > 1);
        let Some(folder) = folder else { return own };
        let mut name = folder.to_owned();
        name.push("_");
        name.push(own);
        name
    };
    let of = |path: &PathBuf| match path.as_os_str() == "-" {
        true => Origin::Stdin,
        false => Origin::File { path: path.clone(), stem: named(path) },
    };
    paths.iter().map(of).collect()
}

/// The files among the inputs; no output may name one.
pub fn files(origins: &[Origin]) -> Vec<PathBuf> {
    let file = |origin: &Origin| match origin {
        Origin::File { path, .. } => Some(path.clone()),
        // Where the system has this name, it leads to the file that standard input was redirected from.
        Origin::Stdin => Some(PathBuf::from("/dev/stdin")),
        Origin::Sample { .. } => None,
    };
    origins.iter().filter_map(file).collect()
}

impl Origin {
    /// As messages show it.
    pub fn shown(&self) -> String {
        match self {
            Origin::File { path, .. } => path.display().to_string(),
            Origin::Stdin => "stdin".into(),
            Origin::Sample { name, seed } => format!("sample {name}, seed {seed}"),
        }
    }

    /// The stem of output names: the file name without its extension, with the name of its folder before it where another input
    /// has the same, `stdin`, or the sample's name.
    pub fn stem(&self) -> OsString {
        match self {
            Origin::File { stem, .. } => stem.clone(),
            _ => self.own_stem(),
        }
    }

    /// The stem of outputs beside the input.
    pub fn own_stem(&self) -> OsString {
        match self {
            Origin::File { path, .. } => path.file_stem().unwrap_or_default().into(),
            Origin::Stdin => "stdin".into(),
            Origin::Sample { name, .. } => name.into(),
        }
    }

    /// The folder that outputs go to when none is named; `None` for standard input.
    pub fn folder(&self) -> Option<PathBuf> {
        match self {
            Origin::File { path, .. } => Some(path.parent().map(PathBuf::from).unwrap_or_default()),
            Origin::Stdin => None,
            Origin::Sample { .. } => Some(PathBuf::new()),
        }
    }

    /// Reads or generates the points.
    ///
    /// # Errors
    /// Input if a file cannot be read, usage for an unknown sample, refused by `--strict`.
    pub fn load(&self, reading: &Reading, options: &ReadOptions) -> Result<Input, Failure> {
        let start = Instant::now();
        let options = &with_reading(options, reading);
        let input = match self {
            Origin::File { path, .. } => from_file(path, self.name(), options),
            Origin::Stdin => from_file(Path::new("-"), self.name(), options),
            Origin::Sample { name, seed } => from_sample(name, *seed, self.name()),
        }?;
        if reading.strict {
            self.refuse_non_finite(&input.cloud)?;
        }
        Ok(Input { seconds: start.elapsed().as_secs_f64(), ..input })
    }

    fn refuse_non_finite(&self, cloud: &Cloud) -> Result<(), Failure> {
        let odd = |point: &&[f64; 3]| !point.iter().all(|x| x.is_finite());
        let Some(first) = cloud.positions.iter().position(|p| odd(&p)) else { return Ok(()) };
        let count = cloud.positions.iter().filter(odd).count();
        let [x, y, z] = cloud.positions[first];
        let message = format!("{}: point {first} is not finite ({x} {y} {z}), {count} in all", self.shown());
        Err(Failure::new(Code::Refused, message)
            .advise("without --strict such points are left out and counted"))
    }

    /// As outputs name it: without folders, so that they do not depend on where the program runs.
    fn name(&self) -> String {
        match self {
            Origin::File { path, .. } => path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            _ => self.shown(),
        }
    }
}

/// The options, completed by the command line.
fn with_reading(options: &ReadOptions, reading: &Reading) -> ReadOptions {
    ReadOptions {
        salvage: reading.salvage,
        memory: reading.memory,
        classes: reading.class.clone(),
        without_noise: options.without_noise && !reading.all_points,
        returns: reading.returns,
        scan: reading.scan,
        every: reading.every,
        voxel: reading.voxel,
        bounds: reading.bounds,
        format: reading.input_format,
        columns: reading.columns.clone(),
        crs: reading.crs,
        mesh: Some(match reading.samples {
            _ if reading.vertices => MeshPoints::Vertices,
            Some(count) => MeshPoints::Sampled(count),
            None => MeshPoints::Auto,
        }),
        ..options.clone()
    }
}

fn from_file(path: &Path, name: String, options: &ReadOptions) -> Result<Input, Failure> {
    if path.is_dir() {
        let failure = Failure::new(Code::Input, format!("`{}` is a folder", path.display()));
        return Err(failure.advise("name the files in it, such as scans/*.ply"));
    }
    let scan = read(path, options)?;
    Ok(Input {
        name,
        sha256: scan.sha256,
        crs: scan.crs,
        epsg: scan.epsg,
        wkt: scan.wkt,
        unit: scan.unit,
        las: scan.las,
        sampled: scan.sampled,
        planned: scan.planned,
        format: Some((scan.format.to_string(), scan.bytes)),
        missing: scan.missing.map(|m| format!("the file ends early: {m}")),
        noise: scan.noise,
        warnings: scan.warnings,
        remarks: scan.ignored,
        beside: scan.beside,
        cloud: scan.cloud,
        seconds: 0.0,
    })
}

fn from_sample(sample: &str, seed: u64, name: String) -> Result<Input, Failure> {
    let found = shapes::sample(sample).ok_or_else(|| {
        let failure = Failure::new(Code::Usage, format!("--sample {sample}: there is no such sample"));
        let meant = near::nearest(sample, shapes::samples().iter().map(|s| s.name));
        let meant = meant.map_or(String::new(), |name| format!("did you mean `{name}`? "));
        failure.advise(format!("{meant}`lineament extract --sample list` lists them"))
    })?;
    let cloud = (found.make)(seed).cloud;
    Ok(Input {
        cloud,
        name,
        sha256: None,
        crs: None,
        epsg: None,
        wkt: None,
        unit: None,
        las: None,
        sampled: None,
        planned: None,
        format: None,
        missing: None,
        noise: 0,
        warnings: Vec::new(),
        remarks: Vec::new(),
        beside: Vec::new(),
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

/// Writes a text to standard output. A closed pipe is not an error: its reader has seen enough.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = std::io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::new(Code::Output, format!("standard output: {e}")))
        }
        _ => Ok(()),
    }
}
