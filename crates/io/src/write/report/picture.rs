//! The picture of a report, for readers without WebGL.

use super::Report;
use super::points::Chosen;
use lineament::apply::render::{Scene, Settings, Slice, render};
use std::io;

const WIDTH: usize = 800;
const HEIGHT: usize = 600;

/// A PNG of the points, lines and slices from the best side.
pub(super) fn draw(report: &Report, chosen: &Chosen) -> io::Result<Vec<u8>> {
    let settings = Settings { up: report.up, width: WIDTH, height: HEIGHT, ..Settings::default() };
    let contours = report.sections.iter().flat_map(|(sections, _)| sections.contours());
    let slices: Vec<Slice> =
        contours.map(|(plane, c)| Slice { plane, points: &c.points, closed: c.closed }).collect();
    let scene = Scene {
        surfels: &chosen.surfels,
        network: report.network,
        slices: &slices,
        spacing: chosen.spacing,
        ..Scene::default()
    };
    let picture = render(&scene, &settings).map_err(io::Error::other)?;
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, WIDTH as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&picture.rgb)?;
    writer.finish()?;
    Ok(bytes)
}
