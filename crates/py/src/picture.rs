//! `render`: pictures and drawings of points and lines.

use std::path::PathBuf;

use lineament::apply::render::{
    Color, Hidden, Picture, Scene, Settings, Style, Surfel, Triangles, View, class_tint, draw, lines_spacing,
    patch_tint, render as paint, score_tint, surfels,
};
use lineament::patch::NO_PATCH;
use lineament::{Class, Network};
use lineament_io::{Output, Unit, write_drawing_to, write_picture as write, write_picture_to};
use numpy::{
    IntoPyArray, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArray3,
    PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::arrays::{pairs, rows, table};
use crate::fault::Fault;
use crate::network::NetworkIn;
use crate::provenance::known;
use crate::work::{alone, on_rows};

/// What of a picture is chosen.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Options {
    view: String,
    up: [f64; 3],
    width: usize,
    height: usize,
    caption: bool,
    style: String,
    hidden: String,
    color: String,
    background: String,
    scale_bar: bool,
    unit: Option<String>,
    /// Whether there are lines alone, and no points.
    alone: bool,
    /// Whether the points are the surface.
    seen: bool,
}

impl Options {
    fn settings(&self) -> Result<Settings, Fault> {
        let unit = known(self.unit.as_deref())?.map_or("", Unit::sign);
        let settings = Settings {
            views: View::parse_list(&self.view)?,
            up: self.up,
            width: self.width,
            height: self.height,
            caption: self.caption,
            style: one("style", &self.style, &[("shaded", Style::Shaded), ("lines", Style::Lines)])?,
            hidden: one(
                "hidden",
                &self.hidden,
                &[("none", Hidden::None), ("dashed", Hidden::Dashed), ("solid", Hidden::Solid)],
            )?,
            color: one(
                "color",
                &self.color,
                &[("kind", Color::Kind), ("confidence", Color::Confidence), ("ink", Color::Ink)],
            )?,
            transparent: one("background", &self.background, &[("white", false), ("none", true)])?,
            scale_bar: self.scale_bar.then(|| unit.into()),
        };
        settings.check()?;
        Ok(settings)
    }
}

/// The choice of a name.
fn one<T: Copy>(what: &str, name: &str, choices: &[(&str, T)]) -> Result<T, Fault> {
    let found = choices.iter().find(|(known, _)| *known == name).map(|(_, value)| *value);
    found.ok_or_else(|| {
        let names: Vec<&str> = choices.iter().map(|(known, _)| *known).collect();
        Fault::Argument(format!("{what}: `{name}`: expected one of {}", names.join(", ")))
    })
}

/// What the points are coloured by, a number for each.
#[derive(FromPyObject)]
pub enum Tints<'py> {
    /// Classes.
    Class(PyReadonlyArray1<'py, u8>),
    /// Scores.
    Score(PyReadonlyArray1<'py, f32>),
    /// Patches, -1 for none.
    Patch(PyReadonlyArray1<'py, i32>),
}

impl Tints<'_> {
    fn colours(&self) -> Vec<[f32; 3]> {
        let classes = [Class::Smooth, Class::Crease, Class::Border, Class::Corner, Class::Clutter];
        let class = |&c: &u8| class_tint(classes.get(usize::from(c)).copied().unwrap_or_default());
        match self {
            Tints::Class(values) => values.as_array().iter().map(class).collect(),
            Tints::Score(values) => values.as_array().iter().map(|&score| score_tint(score)).collect(),
            Tints::Patch(values) => {
                let patch = |&label: &i32| patch_tint(u32::try_from(label).unwrap_or(NO_PATCH));
                values.as_array().iter().map(patch).collect()
            }
        }
    }
}

/// `(V, 3)` vertices and `(T, 3)` triangles of a mesh.
type MeshIn<'py> = (PyReadonlyArray2<'py, f64>, PyReadonlyArray2<'py, u32>);

/// Draws `(N, 3)` points, and a network over them, as `(height, width, 3)` bytes, with a fourth for transparency if the ground is none;
/// of a line drawing the text of an SVG file too.
#[pyfunction]
#[pyo3(signature = (points, network, mesh, tints, options))]
pub fn render<'py>(
    points: &Bound<'py, PyArray2<f64>>,
    network: Option<NetworkIn<'_>>,
    mesh: Option<MeshIn<'_>>,
    tints: Option<Tints<'_>>,
    options: Options,
) -> PyResult<(Bound<'py, PyArray3<u8>>, Option<String>)> {
    let settings = options.settings()?;
    let shown = Shown {
        network: network.as_ref().map(NetworkIn::network).transpose()?,
        mesh: mesh.map(|(v, t)| Ok::<_, Fault>((rows(&v)?.to_vec(), pairs(&t)?))).transpose()?,
        tints: tints.map_or(Vec::new(), |tints| tints.colours()),
    };
    let (lines_alone, seen) = (options.alone, options.seen);
    let (picture, svg) = on_rows(points, None, move |points, _| {
        if lines_alone {
            return shown.drawn(&[], shown.spacing(), &settings);
        }
        let (surfels, spacing) = surfels(points)?;
        shown.drawn(if seen { &surfels } else { &[] }, spacing, &settings)
    })?;
    Ok((pixels(points.py(), picture)?, svg))
}

/// Vertices and triangles.
type Mesh = (Vec<[f64; 3]>, Vec<[u32; 3]>);

/// What a picture shows beside points.
struct Shown {
    network: Option<Network>,
    mesh: Option<Mesh>,
    /// Colours of the points, of all or of none.
    tints: Vec<[f32; 3]>,
}

impl Shown {
    /// The spacing of lines without points.
    fn spacing(&self) -> f64 {
        let vertices = self.mesh.as_ref().map_or(&[][..], |(vertices, _)| vertices);
        self.network.as_ref().map_or(0.0, |network| lines_spacing(network, vertices))
    }

    /// The picture, and of a line drawing its text.
    fn drawn(
        &self,
        surfels: &[Surfel],
        spacing: f64,
        settings: &Settings,
    ) -> Result<(Picture, Option<String>), Fault> {
        let tint = |s: &Surfel| self.tints.get(s.source as usize).copied().unwrap_or([1.0; 3]);
        let tints = if self.tints.is_empty() { Vec::new() } else { surfels.iter().map(tint).collect() };
        let mesh = self.mesh.as_ref().map(|(vertices, triangles)| Triangles { vertices, triangles });
        let network = self.network.as_ref();
        let scene = Scene { surfels, tints: &tints, mesh, network, spacing, ..Scene::default() };
        let picture = paint(&scene, settings)?;
        if settings.style != Style::Lines {
            return Ok((picture, None));
        }
        let mut text = Vec::new();
        let broken = |e: &dyn std::fmt::Display| Fault::Internal(e.to_string());
        write_drawing_to(&mut text, &draw(&scene, settings)?).map_err(|e| broken(&e))?;
        Ok((picture, Some(String::from_utf8(text).map_err(|e| broken(&e))?)))
    }
}

/// A picture as an array.
fn pixels(py: Python<'_>, picture: Picture) -> PyResult<Bound<'_, PyArray3<u8>>> {
    let Picture { width, height, rgb, alpha } = picture;
    let Some(alpha) = alpha else { return rgb.into_pyarray(py).reshape([height, width, 3]) };
    let pixels = rgb.chunks_exact(3).zip(alpha);
    let rgba: Vec<u8> = pixels.flat_map(|(rgb, a)| [rgb[0], rgb[1], rgb[2], a]).collect();
    rgba.into_pyarray(py).reshape([height, width, 4])
}

/// A mesh of a file as a dictionary.
#[derive(IntoPyObject)]
pub struct MeshFileOut<'py> {
    vertices: Bound<'py, PyArray2<f64>>,
    triangles: Bound<'py, PyArray2<u32>>,
    warnings: Vec<String>,
}

/// Reads the mesh of a file.
#[pyfunction]
pub fn read_mesh(py: Python<'_>, path: PathBuf) -> PyResult<MeshFileOut<'_>> {
    let mesh = alone(py, move || Ok(lineament_io::read_mesh(&path)?))?;
    let (vertices, triangles) = (table(py, mesh.vertices)?, table(py, mesh.triangles)?);
    Ok(MeshFileOut { vertices, triangles, warnings: mesh.warnings })
}

/// A picture as PNG.
#[pyfunction]
pub fn png<'py>(py: Python<'py>, picture: PyReadonlyArray3<'py, u8>) -> PyResult<Bound<'py, PyBytes>> {
    let picture = taken(&picture)?;
    let mut bytes = Vec::new();
    py.detach(|| write_picture_to(&mut bytes, &picture))?;
    Ok(PyBytes::new(py, &bytes))
}

/// Writes a picture to a file as PNG, which is none of `inputs`.
#[pyfunction]
pub fn write_picture(
    py: Python<'_>,
    path: PathBuf,
    inputs: Vec<PathBuf>,
    picture: PyReadonlyArray3<'_, u8>,
) -> PyResult<()> {
    let picture = taken(&picture)?;
    Ok(py.detach(|| write(&path, &inputs, &picture)).map_err(Fault::from)?)
}

/// Writes a text to a file, which is none of `inputs`.
#[pyfunction]
pub fn write_text(py: Python<'_>, path: PathBuf, inputs: Vec<PathBuf>, text: String) -> PyResult<()> {
    let write = || Output::whole(&path, &inputs, |out| out.write_all(text.as_bytes()));
    Ok(py.detach(write).map_err(Fault::from)?)
}

fn taken(picture: &PyReadonlyArray3<'_, u8>) -> Result<Picture, Fault> {
    let &[height, width, depth] = picture.shape() else {
        return Err(Fault::Argument(format!("a picture of shape {:?}", picture.shape())));
    };
    if !matches!(depth, 3 | 4) {
        let shape = picture.shape();
        return Err(Fault::Argument(format!(
            "a picture of shape {shape:?}: expected (H, W, 3) or (H, W, 4)"
        )));
    }
    let bytes: Vec<u8> = picture.as_array().iter().copied().collect();
    let pixels = bytes.chunks_exact(depth);
    let rgb = pixels.clone().flat_map(|p| [p[0], p[1], p[2]]).collect();
    let alpha = (depth == 4).then(|| pixels.map(|p| p[3]).collect());
    Ok(Picture { width, height, rgb, alpha })
}
