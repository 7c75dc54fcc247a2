//! `render`: pictures of points and lines.

use std::path::PathBuf;

use lineament::apply::render::{Picture, Scene, Settings, View, render as draw, surfels};
use lineament_io::{write_picture as write, write_picture_to};
use numpy::{IntoPyArray, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::fault::Fault;
use crate::network::NetworkIn;
use crate::work::on_rows;

/// What of a picture is chosen.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Options {
    view: String,
    up: [f64; 3],
    width: usize,
    height: usize,
    caption: bool,
}

impl Options {
    fn settings(self) -> Result<Settings, Fault> {
        let Options { view, up, width, height, caption } = self;
        let views = vec![View::parse(&view)?];
        let settings = Settings { views, up, width, height, caption, ..Settings::default() };
        settings.check()?;
        Ok(settings)
    }
}

/// Draws `(N, 3)` points, and a network over them, as `(height, width, 3)` bytes.
#[pyfunction]
#[pyo3(signature = (points, network, options))]
pub fn render<'py>(
    points: &Bound<'py, PyArray2<f64>>,
    network: Option<NetworkIn<'_>>,
    options: Options,
) -> PyResult<Bound<'py, PyArray3<u8>>> {
    let settings = options.settings()?;
    let network = network.as_ref().map(NetworkIn::network).transpose()?;
    let picture = on_rows(points, None, move |points, _| {
        let (surfels, spacing) = surfels(points)?;
        Ok(draw(
            &Scene { surfels: &surfels, network: network.as_ref(), spacing, ..Scene::default() },
            &settings,
        )?)
    })?;
    let Picture { width, height, rgb, .. } = picture;
    rgb.into_pyarray(points.py()).reshape([height, width, 3])
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

fn taken(picture: &PyReadonlyArray3<'_, u8>) -> Result<Picture, Fault> {
    match *picture.shape() {
        [height, width, 3] => {
            Ok(Picture { width, height, rgb: picture.as_array().iter().copied().collect(), alpha: None })
        }
        _ => Err(Fault::Argument(format!("a picture of shape {:?}: expected (H, W, 3)", picture.shape()))),
    }
}
