//! From an input to a cloud: opening, recognising, dispatching.
mod detect;
mod e57;
mod expe;
mod faces;
mod foreign;
mod gltf;
mod join;
pub(crate) mod las;
mod limit;
mod lines;
mod marks;
mod mesh;
mod npy;
mod npz;
mod obj;
mod off;
mod parquet;
mod pcd;
mod place;
mod ply;
mod ptx;
mod raster;
mod rows;
mod select;
mod steps;
mod stl;
mod table;
pub(crate) mod zip;

use crate::crs::Crs;
use crate::error::{Error, printable};
use crate::format::Format;
use crate::source::Source;
use crate::unit::Unit;
use lineament::Cloud;
use lineament::mesh::{Faces, Fold, MeshPlan, MeshPoints};
use std::fmt;
use std::io::Read;
use std::path::{Path, PathBuf};

/// How an input is read.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadOptions {
    /// Read the whole part of an input that ends early, instead of refusing it. `Scan::missing` then counts the rest.
    pub salvage: bool,
    /// Keep the columns beside the positions. Without them reading is faster and takes less memory.
    pub attributes: bool,
    /// Compute the SHA-256 of the input on the way.
    pub hash: bool,
    /// Bytes that the points of a compressed input may take in memory. `None` is 64 MiB and eight times the input:
    /// enough for the files of common programs, too little for a small file that unpacks without end.
    pub memory: Option<u64>,
    /// Keep only points of these classes (LAS 1.4 R15, table 9); none keeps all.
    pub classes: Vec<u8>,
    /// Leave out the points of a LAS input flagged as withheld or, without `classes`, classed as noise (7, 18); `Scan::noise` counts them.
    pub without_noise: bool,
    /// Keep only these returns of each pulse.
    pub returns: Option<Returns>,
    /// Read only this scan of an input that holds several, counted from 1.
    pub scan: Option<usize>,
    /// Keep only every n-th point.
    pub every: Option<usize>,
    /// Keep only one point, the one nearest to the middle, of every cube with this edge, in the unit of the input.
    pub voxel: Option<f64>,
    /// Keep only points from the first corner to the second, both included.
    pub bounds: Option<[[f64; 3]; 2]>,
    /// Take the input for this format, whatever it looks like.
    pub format: Option<Format>,
    /// The columns of x, y and z in a table, by name or by number from 1 on.
    pub columns: Option<[String; 3]>,
    /// The coordinate reference system by its code in the EPSG register, which goes over that of the input.
    pub crs: Option<u32>,
    /// The points to take of a mesh; `None` takes its vertices and does not read the faces.
    pub mesh: Option<MeshPoints>,
    /// Only tell what sampling a mesh would give, and take its vertices; not where `every`, `voxel` or `bounds` choose points.
    pub plan: bool,
}

/// Returns of a pulse, by their number and the number of all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Returns {
    /// The first of each pulse.
    First,
    /// The last of each pulse.
    Last,
    /// Those that are alone in their pulse.
    Only,
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self {
            salvage: false,
            attributes: true,
            hash: false,
            memory: None,
            classes: Vec::new(),
            without_noise: false,
            returns: None,
            scan: None,
            every: None,
            voxel: None,
            bounds: None,
            format: None,
            columns: None,
            crs: None,
            mesh: None,
            plan: false,
        }
    }
}

/// The content of an input.
#[derive(Clone, Debug, PartialEq)]
pub struct Scan {
    /// The points in the order and the unit of the input, non-finite rows too. Of a mesh, with `ReadOptions::mesh`, points on its faces.
    pub cloud: Cloud,
    /// The mesh that points were sampled on.
    pub sampled: Option<Sampled>,
    /// The mesh that points would be sampled on; only with `ReadOptions::plan`.
    pub planned: Option<Planned>,
    /// The format that was recognised.
    pub format: Format,
    /// The name of the input, as in messages.
    pub name: String,
    /// Parts of the input that are not in the cloud, one sentence each.
    pub ignored: Vec<String>,
    /// What makes it doubtful that the cloud is the one that was meant, one sentence each.
    pub warnings: Vec<String>,
    /// Other files that the input led to, and that were read.
    pub beside: Vec<PathBuf>,
    /// What is missing of an input that ended early; only with `ReadOptions::salvage`.
    pub missing: Option<Missing>,
    /// Points that were left out as withheld or noise; only with `ReadOptions::without_noise`.
    pub noise: usize,
    /// The coordinate reference system by its name or as `EPSG:` and a code, where the input states one.
    pub crs: Option<String>,
    /// Its code in the EPSG register, where the input states it or names a system that has one.
    pub epsg: Option<u32>,
    /// Its definition in well-known text, where the input or a `.prj` file beside it holds one.
    pub wkt: Option<String>,
    /// The unit of the coordinates, where the format or the reference system fixes it.
    pub unit: Option<Unit>,
    /// How a LAS or LAZ input stores its coordinates, for outputs that are to be like it.
    pub las: Option<LasFrame>,
    /// SHA-256 of all bytes of the input in hexadecimal, if `ReadOptions::hash` asked for it.
    pub sha256: Option<String>,
    /// Bytes of the input.
    pub bytes: u64,
}

/// The faces of a mesh that points were sampled on.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampled {
    /// Their number.
    pub faces: usize,
    /// Mean distance of neighbouring points, unit of the input.
    pub spacing: f64,
    /// The size of their smallest features, unit of the input, where they have any.
    pub feature: Option<f64>,
    /// The edges at which they fold, for `lineament::extract_sampled`.
    pub folds: Vec<Fold>,
}

/// The faces of a mesh on which no points were sampled yet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Planned {
    /// Their number.
    pub faces: usize,
    /// What sampling them gives.
    pub plan: MeshPlan,
}

/// Items that an input announced and does not hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Missing {
    /// The items counted, such as `points`.
    pub unit: String,
    /// How many were announced.
    pub expected: u64,
    /// How many were there whole, and are in the cloud.
    pub read: u64,
}

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Missing { unit, expected, read } = self;
        write!(f, "{read} of {expected} {unit} read, {} missing", expected.saturating_sub(*read))
    }
}

/// The result of a reader.
#[derive(Default)]
pub(crate) struct Decoded {
    pub cloud: Cloud,
    /// Faces between the points, which may name some that there are not, and how many more could not be read.
    pub faces: Faces,
    pub odd_faces: u64,
    pub ignored: Vec<String>,
    pub warnings: Vec<String>,
    pub beside: Vec<PathBuf>,
    pub missing: Option<Missing>,
    pub noise: usize,
    /// The reference system, and the unit of length where the format fixes it.
    pub crs: Crs,
    pub unit: Option<Unit>,
    pub las: Option<LasFrame>,
}

impl Decoded {
    /// An early end: an error, or with salvage a note of it.
    pub fn cut(
        &mut self,
        source: &Source,
        options: &ReadOptions,
        unit: &str,
        expected: u64,
        read: u64,
    ) -> Result<(), Error> {
        if !options.salvage {
            return Err(source.ends_early(unit, expected, read));
        }
        self.missing = Some(Missing { unit: unit.into(), expected, read });
        Ok(())
    }
}

pub use faces::{MeshFile, read_mesh};
pub use join::read_all;
pub(crate) use las::WKT;
pub use las::{LasFrame, Record as LasRecord};
pub use lines::{LineFile, read_lines};
pub use marks::read_marks;

/// Reads the point cloud in the file at `path`; `-` is standard input.
///
/// # Errors
/// An input that cannot be opened, is empty, of no known format, breaks its format's rules, or ends early.
pub fn read(path: &Path, options: &ReadOptions) -> Result<Scan, Error> {
    if path.as_os_str() == "-" {
        return read_from(Box::new(std::io::stdin()), "standard input", options);
    }
    decode(open(path, options.hash)?.0, options)
}

/// The source of a file, and its length where that is known.
fn open(path: &Path, hash: bool) -> Result<(Source, Option<u64>), Error> {
    let name = path.display().to_string();
    let fail = |source| Error::Io { action: "open", name: name.clone(), source };
    let file = std::fs::File::open(path).map_err(fail)?;
    let meta = file.metadata().map_err(fail)?;
    if meta.is_dir() {
        return Err(fail(std::io::Error::from(std::io::ErrorKind::IsADirectory)));
    }
    let length = Some(meta.len()).filter(|&length| meta.is_file() && length > 0);
    Ok((Source::new(Box::new(file), name, length, hash).at(path), length))
}

/// Reads a point cloud from a stream. `name` stands for it in messages, and its extension may tell the format.
///
/// # Errors
/// As [`read`].
pub fn read_from(reader: Box<dyn Read + Send>, name: &str, options: &ReadOptions) -> Result<Scan, Error> {
    decode(Source::new(reader, name.into(), None, options.hash), options)
}

fn decode(mut source: Source, options: &ReadOptions) -> Result<Scan, Error> {
    let name = source.name().to_string();
    source.peek(1 << 16)?;
    // After the look ahead: it may have seen the end of a short pipe.
    let length = source.remaining();
    let start = source.peek(1)?;
    let format = match options.format {
        Some(format) if !start.is_empty() => format,
        _ => detect::detect(start, length, &name)?,
    };
    select::fits(&name, format, options)?;
    let filters = !options.classes.is_empty() || options.returns.is_some();
    // Readers of columns; what filters need is dropped below.
    let all = ReadOptions { attributes: true, ..options.clone() };
    let (asked, options) = (options, if filters { &all } else { options });
    let decoded = by_format(&mut source, format, options)?;
    source.drain()?;
    let (mut decoded, mesh::Taken { sampled, planned }) = mesh::taken(decoded, options);
    place::settle(&source, options, &mut decoded)?;
    let Decoded { mut cloud, ignored, warnings, beside, missing, noise, crs, unit, las, .. } = decoded;
    let unit = unit.or_else(|| Unit::of_system(&crs));
    let shown = |all: Vec<String>| -> Vec<String> { all.iter().map(|what| printable(what)).collect() };
    let (mut ignored, mut warnings) = (shown(ignored), shown(warnings));
    select::select(&name, &mut cloud, options, &mut ignored, &mut warnings)?;
    if !asked.attributes {
        cloud.attributes.clear();
    }
    warnings.extend(detect::misnamed(&name, format).filter(|_| options.format.is_none()));
    warnings.extend(steps::warnings(&cloud));
    let (sha256, bytes) = (source.sha256(), source.offset());
    Ok(Scan {
        cloud,
        sampled,
        planned,
        format,
        name,
        ignored,
        warnings,
        beside,
        missing,
        noise,
        crs: crs.name.clone().or_else(|| crs.short()),
        epsg: crs.code.and_then(|code| code.try_into().ok()),
        wkt: crs.wkt,
        unit,
        las,
        sha256,
        bytes,
    })
}

/// The content of an input, by the reader of its format.
fn by_format(source: &mut Source, format: Format, options: &ReadOptions) -> Result<Decoded, Error> {
    match format {
        Format::Ply => ply::read(source, options),
        Format::Table => table::read(source, options),
        Format::Obj => obj::read(source, options),
        Format::Pcd => pcd::read(source, options),
        Format::Las => las::read(source, options),
        Format::E57 => e57::read(source, options),
        Format::Ptx => ptx::read(source, options),
        Format::Raster => raster::read(source, options),
        Format::Stl => stl::read(source, options),
        Format::Off => off::read(source, options),
        Format::Npy => npy::read(source, options),
        Format::Npz => npz::read(source, options),
        Format::Parquet => parquet::read(source, options),
        Format::Expe => expe::read(source, options),
        Format::Gltf => gltf::read(source, options),
    }
}
