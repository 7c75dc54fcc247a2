//! Lesson 5: a picture of a scan and its lines. `cargo run --example 05_render` writes `bracket.png`.

use lineament::apply::render::{Scene, Settings, View, render, surfels};
use lineament::shapes::{Sampling, Scan, bracket};
use lineament::{Params, extract};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cloud = bracket().sample(&Scan::new(Sampling::BlueNoise { count: 20_000 }).seed(1)).cloud;
    let found = extract(&cloud, &Params::default())?;

    // Each point becomes a small disc in its tangent plane; together the discs hide the lines behind them.
    let (surfels, spacing) = surfels(&cloud)?;
    let scene = Scene { surfels: &surfels, network: Some(&found.network), spacing, ..Scene::default() };

    // `View::Best` tries many directions and takes the one that shows most; `View::parse("top")` names one.
    let settings = Settings { views: vec![View::Best], width: 640, height: 480, ..Settings::default() };
    let picture = render(&scene, &settings)?;
    assert_eq!(picture.rgb.len(), 3 * picture.width * picture.height);

    // The picture is plain RGB bytes: any encoder takes them.
    let file = std::io::BufWriter::new(std::fs::File::create("bracket.png")?);
    let mut encoder = png::Encoder::new(file, picture.width as u32, picture.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(&picture.rgb)?;
    Ok(())
}
