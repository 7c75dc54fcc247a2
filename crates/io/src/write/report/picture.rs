//! The picture of a report, for readers without WebGL.

use super::Report;
use super::points::Chosen;
use lineament::apply::render::{Scene, Settings, render};
use std::io;

const WIDTH: usize = 800;
const HEIGHT: usize = 600;

/// A PNG of the points and lines from the best side.
pub(super) fn draw(report: &Report, chosen: &Chosen) -> io::Result<Vec<u8>> {
    let settings = Settings { up: report.up, width: WIDTH, height: HEIGHT, ..Settings::default() };
    let scene = Scene { surfels: &chosen.surfels, network: report.network, spacing: chosen.spacing };
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
